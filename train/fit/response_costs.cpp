// SPDX-License-Identifier: MIT
#include "train/fit/response_costs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "database/library/library_file.h"

namespace flinch::train {
namespace {

constexpr float kWorkTimeStep_s = 0.05F;  // as ScenarioDistribution has it by default
constexpr int kWorkPhases = 4;            // likewise
constexpr int kMaxWorkTimes = 64;

/// The mean of what was measured, if anything was.
struct MeasuredWork {
  double sum_j = 0;
  int count = 0;

  std::optional<double> mean_j() const {
    return count > 0 ? std::optional(sum_j / count) : std::nullopt;
  }
};

/// Of one clip: what was measured in each cell, by phase and then by time.
class ClipWork {
 public:
  explicit ClipWork(int time_count)
      : times_(static_cast<std::size_t>(time_count)), cells_(kWorkPhases * times_) {}

  MeasuredWork& cell(std::size_t phase, std::size_t time) { return cells_[phase * times_ + time]; }

  std::optional<double> work_j(std::size_t phase, std::size_t time) const {
    if (const auto mean = cells_[phase * times_ + time].mean_j()) return mean;
    for (std::size_t apart = 0; apart < times_; ++apart) {
      MeasuredWork nearest;
      for (std::size_t at = 0; at < times_; ++at) {
        const bool is_apart = std::max(at, time) - std::min(at, time) == apart;
        for (std::size_t p = 0; is_apart && p < kWorkPhases; ++p) {
          nearest.sum_j += cells_[p * times_ + at].sum_j;
          nearest.count += cells_[p * times_ + at].count;
        }
      }
      if (const auto mean = nearest.mean_j()) return mean;
    }
    return std::nullopt;
  }

 private:
  std::size_t times_;
  std::vector<MeasuredWork> cells_;
};

/// Returns how long the idle clip takes there and back, s; 0 if the store holds no library.
float idle_period_s(const StoreHeader& header) {
  database::ClipLibrary library;
  const auto status = database::read_embedded_library(header.library_file, library);
  return status == database::LoadStatus::ok ? 2 * library.idle_clip().motion.duration_s() : 0;
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
  costs.phase_count = kWorkPhases;
  costs.time_step_s = kWorkTimeStep_s;
  const auto time_of = [](const Observation& observation) {
    return observation.scenario.time_to_impact_s;
  };
  const auto [first, last] = std::ranges::minmax_element(observations, {}, time_of);
  costs.min_time_s = first == observations.end() ? 0 : time_of(*first);
  if (first != observations.end()) {
    const long steps = std::lround((time_of(*last) - time_of(*first)) / kWorkTimeStep_s);
    costs.time_count = static_cast<int>(std::min<long>(steps, kMaxWorkTimes - 1)) + 1;
  }
  const float period_s = idle_period_s(header);
  const auto times = static_cast<std::size_t>(costs.time_count);
  std::vector<ClipWork> work(header.clips.size(), ClipWork(costs.time_count));
  for (const Observation& observation : observations) {
    if (observation.scenario.state.stance != 0) continue;
    const float time_s = time_of(observation);
    const auto time = std::min(
        static_cast<std::size_t>(std::lround((time_s - costs.min_time_s) / kWorkTimeStep_s)),
        times - 1);
    const float phase =
        period_s > 0 ? (observation.scenario.state.idle_time_s + time_s) / period_s : 0;
    const auto at_phase = static_cast<std::size_t>(
        std::lround((phase - std::floor(phase)) * float{kWorkPhases}) % kWorkPhases);
    for (const Trial& trial : observation.trials) {
      MeasuredWork& cell = work[static_cast<std::size_t>(trial.clip)].cell(at_phase, time);
      cell.sum_j += double{trial.work_j};
      ++cell.count;
    }
  }
  for (std::size_t clip = 0; clip < work.size(); ++clip) {
    const double otherwise_j = clip < header.clip_work_j.size() ? header.clip_work_j[clip] : 0;
    for (std::size_t phase = 0; phase < kWorkPhases; ++phase) {
      for (std::size_t time = 0; time < times; ++time) {
        const double work_j = work[clip].work_j(phase, time).value_or(otherwise_j);
        costs.work_j.push_back(static_cast<float>(work_j));
      }
    }
  }
  return costs;
}

}  // namespace flinch::train
