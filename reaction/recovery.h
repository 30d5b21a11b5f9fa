// SPDX-License-Identifier: MIT
#pragma once

namespace flinch::reaction {

/// The schedule of the return from a hit to animation: the double blend of "Anticipating impacts",
/// sections 4.1.3 and 4.2. Physics moves the character alone for a time A after the contact. With
/// E(s) = 3 s^2 - 2 s^3 of s clamped to [0, 1], the pose at time t after the first contact is
///
///     (1 - a) simulated + a destination,      a = E((t - A) / 0.26 s)               (part one)
///     destination = (1 - b) sustained + b returning,  b = E((t - B) / L)            (part two)
///
/// The paper gives the lengths of both parts, 0.26 and 0.375 s, and says that the destination has
/// gone 25 % of its way when part one ends. One ease over both parts does all that: E(q) = 1/4 at
/// q = 1/2 - sin(10 degrees), so that
///
///     L = 0.375 s / (1 - q) = 0.557 s,      B = A + 0.26 s - q L = A + 0.078 s.
///
/// The sustained pose is held until B: for 1/3 s in the paper, of which the part beyond A + 0.078 s
/// lies before the contact. Both weights start and end with zero velocity, so the result is as
/// smooth as the simulation and the motions are.
struct RecoverySchedule {
  double simulation_only_s = 0.075;  ///< A; the paper leaves 0.05 to 0.1 s to the animator
};

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
