// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "features/known_kind.h"
#include "motion/body.h"
#include "train/objective/observation.h"
#include "train/objective/vulnerability.h"

namespace flinch::train {

/// Parameters that turn impulses and work into a cost.
struct CostModel {
  Vulnerability vulnerability = vulnerability_profiles()[0].vulnerability;
  std::vector<features::KindVulnerability> of_kind{};  ///< kinds with a table of their own
  double brawn = 0.5;                                  ///< in [0, 1]: weight of work against damage
  std::vector<double> reference_damage_ns{1};          ///< D* of each kind of threat
  double reference_work_j = 1;                         ///< W*, positive
  std::string vulnerability_name = vulnerability_profiles()[0].name;
};

/// Returns the table against a kind of threat.
const Vulnerability& vulnerability_to(const CostModel& model, int kind);

/// Returns D* of a kind of threat: the largest vulnerability times the largest impulse that such a
/// threat can give.
double reference_damage_ns(const Vulnerability& vulnerability, const features::KnownKind& kind);

/// damage = sum over the bodies b of v_b I_b, N·s (Zordan et al. 2007, equation 1).
double damage_ns(const motion::PerBody<float>& impulse, const Vulnerability& vulnerability);

/// cost = (1 - h) damage + h W D*/W*, N·s. The factor D*/W* makes work and damage comparable.
/// `kind` is that of the threat, an index of the model's.
double cost_of(const Trial& trial, int kind, const CostModel& model);

/// Returns one cost per trial.
std::vector<double> costs_of(std::span<const Trial> trials, int kind, const CostModel& model);

/// Returns the index of the best trial: the one with the lowest cost; among those within 1 % of it,
/// the one with less work, then the one with the lower clip index. `costs` has one value for each
/// of `trials`; there must be at least one.
std::size_t best_trial(std::span<const Trial> trials, std::span<const double> costs);

}  // namespace flinch::train
