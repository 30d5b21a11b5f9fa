// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "features/known_kind.h"
#include "motion/body.h"

namespace flinch::models {

/// The work of each clip's response from a stance other than the idle clip.
struct StanceWork {
  int stance = 0;  ///< which of the library's stances (features::CharacterState), above 0
  /// For each clip, phase of the stance at the impact and time, as ResponseCosts::work_j, J.
  std::vector<float> work_j;
  int phase_count = 1;
  bool operator==(const StanceWork&) const = default;
};

/// What the selector's clips cost, as it was fitted to (docs/cost.md): what turns the impulses of a
/// simulated hit into a cost at run time, and the measured work of each clip's response.
struct ResponseCosts {
  motion::PerBody<double> vulnerability;  ///< v_b, at least 0
  /// v_b of kinds of threats with a table of their own, by rising kind.
  std::vector<features::KindVulnerability> of_kind;
  /// D* of each kind of threat that the selector knows, positive.
  std::vector<double> reference_damage_ns = std::vector<double>(1, 1.0);
  double reference_work_j = 1;  ///< W*, positive
  /// The work of the response of each clip from the idle clip, J: for each clip of the library, for
  /// each phase of the idle clip at the impact, from `min_time_s` to the impact on in steps of
  /// `time_step_s`.
  std::vector<float> work_j;
  int phase_count = 1;
  int time_count = 1;
  float min_time_s = 0;
  float time_step_s = 1;
  /// The same from other stances, by rising stance, at the same times to impact.
  std::vector<StanceWork> of_stance;
  /// The name of the vulnerability table; empty for the trainer's default.
  std::string vulnerability_name;
};

/// What the work of a response depends on besides its clip.
struct ResponseStart {
  int stance = 0;  ///< in which the character is when it perceives the threat
  /// Where that stance would be at the impact, in periods; the integral part does not matter.
  float phase = 0;
  float time_to_impact_s = 0;
};

/// Whether there is a table of the work of responses that begin in this stance. For stance 0, the
/// idle clip, there always is.
bool knows_work_from(const ResponseCosts& costs, int stance);

/// Returns the work of a clip's response, J: interpolated between the times and phases of the
/// table, constant beyond its times. knows_work_from(costs, start.stance) must hold.
float work_j(const ResponseCosts& costs, int clip, const ResponseStart& start);

/// Returns v_b against a kind of threat.
const motion::PerBody<double>& vulnerability_to(const ResponseCosts& costs, int kind);

/// damage = sum over the bodies b of v_b I_b, N·s, of these impulses (N·s) of a kind of threat.
double damage_ns(const ResponseCosts& costs, int kind, const motion::PerBody<double>& impulse);

/// Returns what a joule counts as damage, D*/W*, N·s/J, against a kind of threat. A kind that the
/// selector does not know counts as the first.
double damage_per_work(const ResponseCosts& costs, int kind);

/// cost = (1 - brawn) damage + brawn work D*/W*, N·s, of a response to a threat of this kind.
double cost_ns(const ResponseCosts& costs, double brawn, int kind, double damage_ns, double work_j);

}  // namespace flinch::models
