// SPDX-License-Identifier: MIT
#include "train/objective/cost.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace flinch::train {

namespace {

using motion::Body;

// Costs within this share of the lowest count as equal to it.
constexpr double kTieTolerance = 0.01;

}  // namespace

const Vulnerability& vulnerability_to(const CostModel& model, int kind) {
  const auto own = std::ranges::find(model.of_kind, kind, &features::KindVulnerability::kind);
  return own == model.of_kind.end() ? model.vulnerability : own->vulnerability;
}

double reference_damage_ns(const Vulnerability& vulnerability, const features::KnownKind& kind) {
  return *std::max_element(vulnerability.begin(), vulnerability.end()) * largest_impulse_ns(kind);
}

double damage_ns(const motion::PerBody<float>& impulse, const Vulnerability& vulnerability) {
  double damage = 0;
  for (const Body body : motion::kBodies) damage += vulnerability[body] * double{impulse[body]};
  return damage;
}

double cost_of(const Trial& trial, int kind, const CostModel& model) {
  const double reference_ns = model.reference_damage_ns[static_cast<std::size_t>(kind)];
  const double work = double{trial.work_j} * reference_ns / model.reference_work_j;
  return (1 - model.brawn) * damage_ns(trial.impulse, vulnerability_to(model, kind)) +
         model.brawn * work;
}

std::vector<double> costs_of(std::span<const Trial> trials, int kind, const CostModel& model) {
  std::vector<double> costs;
  costs.reserve(trials.size());
  for (const Trial& trial : trials) costs.push_back(cost_of(trial, kind, model));
  return costs;
}

std::size_t best_trial(std::span<const Trial> trials, std::span<const double> costs) {
  const double least = *std::min_element(costs.begin(), costs.end());
  std::size_t best = trials.size();
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (costs[i] > least * (1 + kTieTolerance)) continue;
    if (best == trials.size() || std::tie(trials[i].work_j, trials[i].clip) <
                                     std::tie(trials[best].work_j, trials[best].clip))
      best = i;
  }
  return best;
}

}  // namespace flinch::train
