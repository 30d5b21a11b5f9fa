// SPDX-License-Identifier: MIT
#pragma once

#include "reaction/reaction.h"

namespace flinch::reaction {

/// The weights of the blend at one time.
struct RecoveryWeights {
  double simulated = 1;  ///< 1 - a
  double returning = 0;  ///< b
};

/// The weights at any time after the first contact; before it, those at the contact.
RecoveryWeights weights_at(const RecoverySchedule& schedule, double since_contact_s) noexcept;

/// When physics stops having an effect, s after the contact: A + 0.26 s.
double simulation_end_s(const RecoverySchedule& schedule) noexcept;
/// When only the motion to return to is shown, s after the contact: B + L.
double duration_s(const RecoverySchedule& schedule) noexcept;

}  // namespace flinch::reaction
