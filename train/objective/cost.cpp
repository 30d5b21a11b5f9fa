// SPDX-License-Identifier: MIT
#include "train/objective/cost.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace flinch::train {

namespace {

using motion::Body;

constexpr Vulnerability default_vulnerability() {
  Vulnerability v;
  v[Body::head] = v[Body::neck] = 1;
  v[Body::chest] = v[Body::abdomen] = v[Body::pelvis] = 0.7;
  v[Body::left_thigh] = v[Body::right_thigh] = 0.4;
  v[Body::left_shin] = v[Body::right_shin] = 0.4;
  v[Body::left_foot] = v[Body::right_foot] = 0.4;
  v[Body::left_upper_arm] = v[Body::right_upper_arm] = 0.3;
  v[Body::left_forearm] = v[Body::right_forearm] = 0.25;
  v[Body::left_hand] = v[Body::right_hand] = 0.2;
  return v;
}

constexpr Vulnerability uniform_vulnerability() {
  Vulnerability v;
  for (double& value : v) value = 1;
  return v;
}

constexpr std::array<VulnerabilityProfile, 2> kProfiles{{
    {"default", default_vulnerability()},
    {"uniform", uniform_vulnerability()},
}};

// Costs within this share of the lowest count as equal to it.
constexpr double kTieTolerance = 0.01;

}  // namespace

std::span<const VulnerabilityProfile> vulnerability_profiles() {
  return kProfiles;
}

const VulnerabilityProfile* vulnerability_profile_named(std::string_view name) {
  for (const VulnerabilityProfile& profile : kProfiles)
    if (profile.name == name) return &profile;
  return nullptr;
}

double reference_damage_ns(const Vulnerability& vulnerability, double reference_impulse_ns) {
  return *std::max_element(vulnerability.begin(), vulnerability.end()) * reference_impulse_ns;
}

double damage_ns(const motion::PerBody<float>& impulse, const Vulnerability& vulnerability) {
  double damage = 0;
  for (const Body body : motion::kBodies) damage += vulnerability[body] * double{impulse[body]};
  return damage;
}

double cost_of(const Trial& trial, const CostModel& model) {
  const double work = double{trial.work_j} * model.reference_damage_ns / model.reference_work_j;
  return (1 - model.brawn) * damage_ns(trial.impulse, model.vulnerability) + model.brawn * work;
}

std::vector<double> costs_of(std::span<const Trial> trials, const CostModel& model) {
  std::vector<double> costs;
  costs.reserve(trials.size());
  for (const Trial& trial : trials) costs.push_back(cost_of(trial, model));
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
