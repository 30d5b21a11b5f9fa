// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "motion/body.h"
#include "train/objective/observation.h"

namespace flinch::train {

/// How much an impulse on each body hurts, relative to the most vulnerable one.
using Vulnerability = motion::PerBody<double>;

/// A named vulnerability table; docs/cost.md has the reasons for its numbers.
struct VulnerabilityProfile {
  std::string_view name;
  Vulnerability vulnerability;
};

/// The shipped profiles; the first is the default.
std::span<const VulnerabilityProfile> vulnerability_profiles();
const VulnerabilityProfile* vulnerability_profile_named(std::string_view name);

/// How impulses and work become a cost.
struct CostModel {
  Vulnerability vulnerability = vulnerability_profiles()[0].vulnerability;
  double brawn = 0.1;              ///< in [0, 1]: how much work weighs against damage
  double reference_damage_ns = 1;  ///< D*
  double reference_work_j = 1;     ///< W*, positive
};

/// D*: the largest vulnerability times the largest impulse that a threat of the distribution can
/// give, (1 + restitution) times mass times speed.
double reference_damage_ns(const Vulnerability& vulnerability, double reference_impulse_ns);

/// damage = sum over the bodies b of v_b I_b, N·s (Zordan et al. 2007, equation 1).
double damage_ns(const motion::PerBody<float>& impulse, const Vulnerability& vulnerability);

/// cost = (1 - h) damage + h W D*/W*, N·s: so that h trades like for like.
double cost_of(const Trial& trial, const CostModel& model);

/// One cost a trial.
std::vector<double> costs_of(std::span<const Trial> trials, const CostModel& model);

/// Index of the best trial: the least cost; among those within 1 % of it the one of less work, then
/// the lower clip. `costs` goes with `trials`; there is at least one.
std::size_t best_trial(std::span<const Trial> trials, std::span<const double> costs);

}  // namespace flinch::train
