// SPDX-License-Identifier: MIT
#include "models/response_costs.h"

#include <algorithm>
#include <cmath>

namespace flinch::models {

namespace {

/// The work from a stance other than the idle clip, if it is known.
const StanceWork* work_of_stance(const ResponseCosts& costs, int stance) {
  const auto own = std::ranges::find(costs.of_stance, stance, &StanceWork::stance);
  return own == costs.of_stance.end() ? nullptr : &*own;
}

}  // namespace

bool knows_work_from(const ResponseCosts& costs, int stance) {
  return stance == 0 || work_of_stance(costs, stance) != nullptr;
}

float work_j(const ResponseCosts& costs, int clip, const ResponseStart& start) {
  const StanceWork* own = work_of_stance(costs, start.stance);
  const std::vector<float>& work_j = own == nullptr ? costs.work_j : own->work_j;
  const int phase_count = own == nullptr ? costs.phase_count : own->phase_count;
  const auto phases = static_cast<std::size_t>(phase_count);
  const auto times = static_cast<std::size_t>(costs.time_count);
  const float at_time = std::clamp((start.time_to_impact_s - costs.min_time_s) / costs.time_step_s,
                                   0.0F, static_cast<float>(costs.time_count - 1));
  const auto time = std::min(static_cast<std::size_t>(at_time), times - 1);
  const auto next_time = std::min(time + 1, times - 1);
  const float at_phase = (start.phase - std::floor(start.phase)) * static_cast<float>(phase_count);
  const auto phase = static_cast<std::size_t>(at_phase) % phases;
  const auto next_phase = (phase + 1) % phases;
  const float* of_clip = &work_j[static_cast<std::size_t>(clip) * phases * times];
  const float time_weight = at_time - static_cast<float>(time);
  const float phase_weight = at_phase - std::floor(at_phase);
  const auto at = [&](std::size_t p) {
    return std::lerp(of_clip[p * times + time], of_clip[p * times + next_time], time_weight);
  };
  return std::lerp(at(phase), at(next_phase), phase_weight);
}

const motion::PerBody<double>& vulnerability_to(const ResponseCosts& costs, int kind) {
  const auto own = std::ranges::find(costs.of_kind, kind, &features::KindVulnerability::kind);
  return own == costs.of_kind.end() ? costs.vulnerability : own->vulnerability;
}

double damage_ns(const ResponseCosts& costs, int kind, const motion::PerBody<double>& impulse) {
  const motion::PerBody<double>& vulnerability = vulnerability_to(costs, kind);
  double damage = 0;
  for (const motion::Body body : motion::kBodies) damage += vulnerability[body] * impulse[body];
  return damage;
}

namespace {

double reference_damage_ns(const ResponseCosts& costs, int kind) {
  const auto index = static_cast<std::size_t>(kind);
  const bool is_known = kind >= 0 && index < costs.reference_damage_ns.size();
  return costs.reference_damage_ns[is_known ? index : 0];
}

}  // namespace

double damage_per_work(const ResponseCosts& costs, int kind) {
  return reference_damage_ns(costs, kind) / costs.reference_work_j;
}

double cost_ns(const ResponseCosts& costs, double brawn, int kind, double damage_ns,
               double work_j) {
  return (1 - brawn) * damage_ns +
         brawn * work_j * reference_damage_ns(costs, kind) / costs.reference_work_j;
}

}  // namespace flinch::models
