// SPDX-License-Identifier: MIT
#include "train/fit/response_costs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "database/library/library_file.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::train {
namespace {

constexpr float kWorkTimeStep_s = 0.05F;  // as ScenarioDistribution has it by default
constexpr int kIdlePhases = 4;            // likewise
constexpr int kMovingPhases = 8;          // likewise
constexpr int kMaxWorkTimes = 64;

/// The mean of what was measured, if anything was.
struct MeasuredWork {
  double sum_j = 0;
  int count = 0;

  void add(double work_j) {
    sum_j += work_j;
    ++count;
  }
  std::optional<double> mean_j() const {
    return count > 0 ? std::optional(sum_j / count) : std::nullopt;
  }
};

/// Of one clip: what was measured in each cell, by phase and then by time.
class ClipWork {
 public:
  ClipWork(std::size_t phases, std::size_t times)
      : phases_(phases), times_(times), cells_(phases * times) {}

  MeasuredWork& cell(std::size_t phase, std::size_t time) { return cells_[phase * times_ + time]; }

  std::optional<double> work_j(std::size_t phase, std::size_t time) const {
    if (const auto mean = cells_[phase * times_ + time].mean_j()) return mean;
    for (std::size_t apart = 0; apart < times_; ++apart) {
      MeasuredWork nearest;
      for (std::size_t at = 0; at < times_; ++at) {
        const bool is_apart = std::max(at, time) - std::min(at, time) == apart;
        for (std::size_t p = 0; is_apart && p < phases_; ++p) {
          nearest.sum_j += cells_[p * times_ + at].sum_j;
          nearest.count += cells_[p * times_ + at].count;
        }
      }
      if (const auto mean = nearest.mean_j()) return mean;
    }
    return std::nullopt;
  }

 private:
  std::size_t phases_;
  std::size_t times_;
  std::vector<MeasuredWork> cells_;
};

/// The times to impact of the table of work.
struct WorkTimes {
  float min_s = 0;
  std::size_t count = 1;

  std::size_t nearest(float time_s) const {
    const auto time = static_cast<std::size_t>(std::lround((time_s - min_s) / kWorkTimeStep_s));
    return std::min(time, count - 1);
  }
};

WorkTimes work_times(std::span<const Observation> observations) {
  const auto time_of = [](const Observation& observation) {
    return observation.scenario.time_to_impact_s;
  };
  const auto [first, last] = std::ranges::minmax_element(observations, {}, time_of);
  if (first == observations.end()) return {};
  const long steps = std::lround((time_of(*last) - time_of(*first)) / kWorkTimeStep_s);
  return {time_of(*first), static_cast<std::size_t>(std::min<long>(steps, kMaxWorkTimes - 1)) + 1};
}

/// What was measured of the responses from one stance.
class StanceTable {
 public:
  /// `period_s` is that of the stance; 0 if it has none.
  StanceTable(const StoreHeader& header, int stance, float period_s, const WorkTimes& times)
      : header_(header),
        stance_(stance),
        phases_(stance == 0 ? kIdlePhases : kMovingPhases),
        period_s_(period_s),
        times_(times),
        of_clip_(header.clips.size(), ClipWork(phases_, times.count)) {}

  bool is_measured() const { return is_measured_; }

  void add(const Observation& observation) {
    is_measured_ = true;
    const float time_s = observation.scenario.time_to_impact_s;
    const float periods =
        period_s_ > 0 ? (observation.scenario.state.idle_time_s + time_s) / period_s_ : 0;
    const long phase = std::lround((periods - std::floor(periods)) * static_cast<float>(phases_));
    for (const Trial& trial : observation.trials) {
      const double work_j = double{trial.work_j};
      of_clip_[static_cast<std::size_t>(trial.clip)]
          .cell(static_cast<std::size_t>(phase) % phases_, times_.nearest(time_s))
          .add(work_j);
      if (trial.clip != header_.idle) excess_.add(work_j - reference_j(trial.clip));
    }
  }

  models::StanceWork table() const {
    // The reference response begins in the idle clip. Others take more, or less, by as much as
    // those that were measured do on average.
    const double excess_j = stance_ == 0 ? 0 : excess_.mean_j().value_or(0);
    models::StanceWork made{stance_, {}, static_cast<int>(phases_)};
    for (std::size_t clip = 0; clip < of_clip_.size(); ++clip) {
      const double otherwise_j = std::max(reference_j(static_cast<int>(clip)) + excess_j, 0.0);
      for (std::size_t phase = 0; phase < phases_; ++phase)
        for (std::size_t time = 0; time < times_.count; ++time)
          made.work_j.push_back(
              static_cast<float>(of_clip_[clip].work_j(phase, time).value_or(otherwise_j)));
    }
    return made;
  }

 private:
  double reference_j(int clip) const {
    const auto index = static_cast<std::size_t>(clip);
    return index < header_.clip_work_j.size() ? header_.clip_work_j[index] : 0;
  }

  const StoreHeader& header_;
  int stance_;
  std::size_t phases_;
  float period_s_;
  WorkTimes times_;
  std::vector<ClipWork> of_clip_;
  MeasuredWork excess_;  ///< over the reference responses
  bool is_measured_ = false;
};

/// The tables of a store's stances, which are empty yet. Periods are unknown, and so phases, if the
/// store holds no library.
std::vector<StanceTable> empty_tables(const StoreHeader& header, const WorkTimes& times) {
  std::vector<float> periods_s(std::max<std::size_t>(header.stances.size(), 1), 0.0F);
  database::ClipLibrary library;
  if (database::read_embedded_library(header.library_file, library) == database::LoadStatus::ok) {
    const std::vector<motion::Loop> loops = stance_loops(library);
    for (std::size_t i = 0; i < std::min(loops.size(), periods_s.size()); ++i)
      periods_s[i] = loops[i].period_s();
  }
  std::vector<StanceTable> tables;
  for (const float period_s : periods_s)
    tables.emplace_back(header, static_cast<int>(tables.size()), period_s, times);
  return tables;
}

}  // namespace

models::ResponseCosts response_costs(const StoreHeader& header,
                                     std::span<const Observation> observations,
                                     const CostModel& model) {
  models::ResponseCosts costs;
  costs.vulnerability = model.vulnerability;
  costs.of_kind = model.of_kind;
  costs.reference_damage_ns = model.reference_damage_ns;
  costs.reference_work_j = model.reference_work_j;
  if (model.vulnerability_name != vulnerability_profiles()[0].name)
    costs.vulnerability_name = model.vulnerability_name;
  costs.time_step_s = kWorkTimeStep_s;
  const WorkTimes times = work_times(observations);
  costs.min_time_s = times.min_s;
  costs.time_count = static_cast<int>(times.count);
  std::vector<StanceTable> tables = empty_tables(header, times);
  for (const Observation& observation : observations)
    tables[static_cast<std::size_t>(observation.scenario.state.stance)].add(observation);
  models::StanceWork idle = tables.front().table();
  costs.work_j = std::move(idle.work_j);
  costs.phase_count = idle.phase_count;
  for (std::size_t stance = 1; stance < tables.size(); ++stance)
    if (tables[stance].is_measured()) costs.of_stance.push_back(tables[stance].table());
  return costs;
}

}  // namespace flinch::train
