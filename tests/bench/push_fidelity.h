// SPDX-License-Identifier: MIT
#pragma once

#include "tests/bench/push_cases.h"

namespace flinch::bench {

/// How faithful the answers to pushes are: of 24 directions, 3 strengths and 5 places in each
/// state.
struct PushFidelity {
  std::size_t asked = 0;
  std::size_t good = 0;      ///< of those: the best Q is above 0.5
  std::size_t accepted = 0;  ///< answered; a quarter of these is played and measured, as follows
  std::size_t right = 0;     ///< fastest velocity within 10 % and 15 degrees of the asked
  std::size_t off = 0;       ///< the recorded direction is 35 degrees or more off
  std::size_t off_right = 0;
  std::vector<double> speed_errors;  ///< %
  std::vector<double> angle_errors;  ///< degrees
  std::vector<double> slips_mm;      ///< of a standing ankle beyond the recording's own
  std::vector<double> seams;         ///< see docs/pushing.md
  double bone_error_m = 0;           ///< longest change of a bone
};
PushFidelity measure_fidelity(const PushStudy& study, const runtime::PushModel& model,
                              const std::vector<State>& states);

}  // namespace flinch::bench
