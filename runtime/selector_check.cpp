// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <span>

#include "database/library/library_bounds.h"
#include "models/pair_index.h"
#include "runtime/selector_file.h"

namespace flinch::runtime {
namespace {

bool all_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

bool are_clips(std::span<const int> labels, std::size_t clip_count) {
  return std::all_of(labels.begin(), labels.end(), [clip_count](int label) {
    return label >= 0 && static_cast<std::size_t>(label) < clip_count;
  });
}

bool are_rising_clips(std::span<const int> clips, std::size_t clip_count) {
  return are_clips(clips, clip_count) &&
         std::adjacent_find(clips.begin(), clips.end(), std::greater_equal<>()) == clips.end();
}

bool is_part_sound(const models::ClipSummary& clip) {
  return database::fault_of_name(clip.name) == nullptr &&
         (!clip.annotation ||
          database::fault_of(*clip.annotation, database::kMaxTime_s) == nullptr);
}

bool is_part_sound(const features::Scaling& scaling, std::size_t feature_count) {
  // Bounded, so that no range is infinite. No feature of a real scene comes near.
  constexpr double kMaxFeature = 1e12;
  const auto is_bounded = [](double x) { return std::abs(x) <= kMaxFeature; };
  return scaling.min.size() == feature_count && scaling.max.size() == feature_count &&
         std::ranges::all_of(scaling.min, is_bounded) &&
         std::ranges::all_of(scaling.max, is_bounded) &&
         std::equal(scaling.min.begin(), scaling.min.end(), scaling.max.begin(),
                    [](double least, double most) { return least <= most; });
}

/// Checks one of a machine's four lists of vectors, which starts at `next`: ascending indices of a
/// class with this many vectors. Advances `next` to the following list.
bool is_list(const models::SvmModel& model, std::size_t& next, std::size_t count, int vectors) {
  if (count > model.vectors.size() - next) return false;
  const auto list = std::span(model.vectors).subspan(next, count);
  next += count;
  return std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end() &&
         (list.empty() || list.back() < vectors);
}

/// Whether there is one machine per pair of classes, with all of its lists and coefficients.
bool are_machines_sound(const models::SvmModel& model) {
  const std::size_t classes = model.label.size();
  if (model.machines.size() != classes * (classes - 1) / 2) return false;
  std::size_t next = 0;
  std::size_t coefficients = 0;
  for (std::size_t i = 0; i < classes; ++i) {
    for (std::size_t j = i + 1; j < classes; ++j) {
      const models::SvmMachine& machine = model.machines[models::pair_index(i, j, classes)];
      for (std::size_t list = 0; list < machine.count.size(); ++list) {
        const int vectors = model.vectors_of_class[list < 2 ? i : j];
        if (!is_list(model, next, machine.count[list], vectors)) return false;
      }
      coefficients += std::size_t{machine.count[0]} + machine.count[2];
      if (!std::isfinite(machine.rho)) return false;
    }
  }
  return next == model.vectors.size() && coefficients == model.coefficients.size();
}

/// Whether the rows are finite and their padding is zero.
bool are_rows_sound(const models::SvmModel& model) {
  const std::vector<float>& values = model.support_vectors;
  const auto features = static_cast<std::size_t>(model.feature_count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % model.row_size() < features ? !std::isfinite(values[i]) : values[i] != 0) return false;
  }
  return true;
}

bool is_part_sound(const models::SvmModel& model, std::size_t clip_count,
                   std::size_t feature_count) {
  const std::size_t classes = model.label.size();
  const std::set<int> different(model.label.begin(), model.label.end());
  const std::vector<int>& counts = model.vectors_of_class;
  const auto is_negative = [](auto number) { return number < 0; };
  if (classes == 0 || different.size() != classes || !are_clips(model.label, clip_count) ||
      counts.size() != classes || model.bound.size() != classes ||
      std::any_of(counts.begin(), counts.end(), is_negative)) {
    return false;
  }
  const auto vectors = std::accumulate(
      counts.begin(), counts.end(), std::size_t{0},
      [](std::size_t sum, int count) { return sum + static_cast<std::size_t>(count); });
  return model.kernel <= models::SvmKernel::rbf && model.degree >= 0 && model.gamma >= 0 &&
         static_cast<std::size_t>(model.feature_count) == feature_count &&
         all_finite(std::array{model.gamma, model.coef0, model.cost}) &&
         vectors <= static_cast<std::size_t>(std::numeric_limits<int>::max()) &&
         model.support_vectors.size() == vectors * model.row_size() && are_rows_sound(model) &&
         all_finite(model.bound) && all_finite(model.coefficients) &&
         std::none_of(model.bound.begin(), model.bound.end(), is_negative) &&
         std::none_of(model.coefficients.begin(), model.coefficients.end(), is_negative) &&
         are_machines_sound(model);
}

bool is_part_sound(const models::KnnModel& model, std::size_t clip_count,
                   std::size_t feature_count) {
  const bool has_costs = model.vote == models::KnnVote::cost;
  return model.k >= 1 && model.k <= models::kMaxNeighbours && model.vote <= models::KnnVote::cost &&
         static_cast<std::size_t>(model.feature_count) == feature_count && !model.label.empty() &&
         are_clips(model.label, clip_count) &&
         model.points.size() == model.label.size() * feature_count &&
         std::all_of(model.points.begin(), model.points.end(),
                     [](float x) { return std::isfinite(x); }) &&
         model.cost.size() == (has_costs ? model.label.size() * clip_count : 0) &&
         (!has_costs || (std::isfinite(model.cost_step_ns) && model.cost_step_ns > 0));
}

// An extra unit or member would be read beyond the weights; sizes above a few thousand would
// overflow their product.
bool is_part_sound(const models::NetworkModel& model, std::size_t clip_count,
                   std::size_t feature_count) {
  constexpr int kMaxCount = 1 << 12;
  const auto is_weight = [](float weight) {
    return std::abs(weight) <= models::kMaxNetworkWeight;  // false for not-a-number
  };
  return static_cast<std::size_t>(model.feature_count) == feature_count &&
         model.hidden_count >= 1 && model.hidden_count <= kMaxCount &&
         model.hidden_count % models::kNetworkBlock == 0 && model.member_count >= 1 &&
         model.member_count <= kMaxCount && !model.clip.empty() &&
         are_rising_clips(model.clip, clip_count) && is_weight(model.mean_root) &&
         is_weight(model.scale_root) && model.scale_root > 0 && is_weight(model.variance_ns) &&
         model.variance_ns >= 0 &&
         model.weights.size() ==
             model.shape().weight_count() * static_cast<std::size_t>(model.member_count) &&
         std::all_of(model.weights.begin(), model.weights.end(), is_weight);
}

// A sum beyond the bound would overflow; an extra machine would be read beyond the weights.
bool is_part_sound(const models::PairwiseModel& model, std::size_t clip_count,
                   std::size_t feature_count) {
  const std::size_t classes = model.clip.size();
  const std::size_t row_size = models::PairwiseModel::row_size(feature_count);
  const std::size_t machines = model.weights.size() / row_size;
  const auto has_room = [row_size](const std::int16_t* row) {
    return std::accumulate(row, row + row_size, std::int64_t{0},
                           [](std::int64_t sum, std::int16_t w) { return sum + std::abs(w); }) <=
           models::PairwiseModel::kMaxWeightSum;
  };
  for (std::size_t i = 0; i < machines; ++i) {
    if (!has_room(model.weights.data() + i * row_size)) return false;
  }
  return static_cast<std::size_t>(model.feature_count) == feature_count && classes > 0 &&
         are_rising_clips(model.clip, clip_count) && model.weights.size() % row_size == 0 &&
         model.machine.size() == classes * (classes - 1) / 2 &&
         std::all_of(model.machine.begin(), model.machine.end(), [machines](int machine) {
           return machine == models::PairwiseModel::kNone ||
                  (machine >= 0 && static_cast<std::size_t>(machine) < machines);
         });
}

bool is_amount(double x) {
  return std::isfinite(x) && x >= 0;
}

/// Whether work is that of so many clips, phases and times.
bool is_work_sound(std::span<const float> work_j, std::size_t clip_count, int phase_count,
                   int time_count) {
  constexpr int kMaxCount = 1 << 12;
  return phase_count >= 1 && phase_count <= kMaxCount && time_count >= 1 &&
         time_count <= kMaxCount &&
         work_j.size() == clip_count * static_cast<std::size_t>(phase_count) *
                              static_cast<std::size_t>(time_count) &&
         std::ranges::all_of(work_j, [](float work) { return is_amount(double{work}); });
}

bool is_part_sound(const models::ResponseCosts& costs, std::size_t clip_count) {
  const auto are_amounts = [&](const motion::PerBody<double>& table) {
    return std::all_of(table.begin(), table.end(), is_amount);
  };
  const auto kinds = static_cast<int>(costs.reference_damage_ns.size());
  return are_amounts(costs.vulnerability) &&
         std::ranges::all_of(costs.of_kind,
                             [&](const features::KindVulnerability& own) {
                               return own.kind >= 0 && own.kind < kinds &&
                                      are_amounts(own.vulnerability);
                             }) &&
         std::ranges::adjacent_find(costs.of_kind, std::ranges::greater_equal{},
                                    &features::KindVulnerability::kind) == costs.of_kind.end() &&
         std::ranges::all_of(costs.reference_damage_ns,
                             [&](double x) { return is_amount(x) && x > 0; }) &&
         is_amount(costs.reference_work_j) && costs.reference_work_j > 0 &&
         is_work_sound(costs.work_j, clip_count, costs.phase_count, costs.time_count) &&
         std::ranges::all_of(
             costs.of_stance,
             [&](const models::StanceWork& own) {
               // A stance is a clip, so there are no more of them.
               return own.stance >= 1 && static_cast<std::size_t>(own.stance) < clip_count &&
                      is_work_sound(own.work_j, clip_count, own.phase_count, costs.time_count);
             }) &&
         std::ranges::adjacent_find(costs.of_stance, std::ranges::greater_equal{},
                                    &models::StanceWork::stance) == costs.of_stance.end() &&
         std::isfinite(costs.min_time_s) && std::isfinite(costs.time_step_s) &&
         costs.time_step_s > 0 &&
         (costs.vulnerability_name.empty() ||
          database::fault_of_name(costs.vulnerability_name) == nullptr);
}

bool is_part_sound(const std::vector<features::KnownKind>& kinds) {
  return !kinds.empty() && kinds.size() <= features::kMaxThreatKinds &&
         std::ranges::all_of(kinds, [](const features::KnownKind& kind) {
           return database::fault_of_name(kind.name) == nullptr && features::is_sound(kind);
         });
}

}  // namespace

bool is_sound(const std::vector<Footwork>& footwork, const database::ClipLibrary& library) {
  const auto is_of_clip = [](const Footwork& one, const motion::Clip& clip) {
    return is_sound(one, clip);
  };
  return std::equal(footwork.begin(), footwork.end(), library.clips.begin(), library.clips.end(),
                    is_of_clip);
}

bool is_sound(const models::Selector& selector) {
  const std::size_t clip_count = selector.clips.size();
  const auto feature_count = static_cast<std::size_t>(selector.layout.size());
  const auto is_clip_sound = [](const models::ClipSummary& clip) { return is_part_sound(clip); };
  const auto is_near = [](const Eigen::Vector3f& place) {
    return (place.array().abs() <= database::kMaxDistance_m).all();  // false for not-a-number
  };
  return selector.idle >= 0 && static_cast<std::size_t>(selector.idle) < clip_count &&
         clip_count <= database::kMaxClips &&
         std::all_of(selector.clips.begin(), selector.clips.end(), is_clip_sound) &&
         (!selector.costs || selector.costs->reference_damage_ns.size() == selector.kinds.size()) &&
         feature_count > 0 && is_part_sound(selector.scaling, feature_count) &&
         selector.brawn >= 0 && selector.brawn <= 1 && is_part_sound(selector.kinds) &&
         (!selector.costs || is_part_sound(*selector.costs, clip_count)) &&
         (!selector.realism || (models::is_sound(*selector.realism) &&
                                database::fault_of_name(selector.realism->judge) == nullptr)) &&
         std::all_of(selector.target_centres.begin(), selector.target_centres.end(), is_near) &&
         std::visit(
             [&](const auto& model) { return is_part_sound(model, clip_count, feature_count); },
             selector.model);
}

bool is_compatible(const models::Selector& selector, const database::ClipLibrary& library) {
  const auto is_same = [](const models::ClipSummary& summary, const motion::Clip& clip) {
    return summary.name == clip.name && (clip.annotation || !summary.annotation);
  };
  const std::size_t stances = database::stance_clips(library).size();
  const auto is_stance = [stances](const models::StanceWork& own) {
    return static_cast<std::size_t>(own.stance) < stances;
  };
  return selector.library_hash == library.hash && selector.idle == library.idle &&
         (!selector.costs || std::ranges::all_of(selector.costs->of_stance, is_stance)) &&
         std::equal(selector.clips.begin(), selector.clips.end(), library.clips.begin(),
                    library.clips.end(), is_same);
}

}  // namespace flinch::runtime
