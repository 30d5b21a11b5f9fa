// SPDX-License-Identifier: MIT
#pragma once

namespace flinch::reaction {

/// The way from a blow back to a motion: the double blend of "Anticipating impacts", sections 4.1.3
/// and 4.2. With A the time that the simulation has alone and E(s) = 3 s^2 - 2 s^3 of s clamped to
/// [0, 1], at time t after the first contact the character is shown
///
///     (1 - a) simulated + a destination,      a = E((t - A) / 0.26 s)               (part one)
///     destination = (1 - b) sustained + b returning,  b = E((t - B) / L)            (part two)
///
/// The paper gives the lengths of both parts, 0.26 and 0.375 s, and that the destination is 25 % of
/// its way when part one ends. One ease over both does all that: E(q) = 1/4 at q = 1/2 - sin(10
/// degrees), so that
///
///     L = 0.375 s / (1 - q) = 0.557 s,      B = A + 0.26 s - q L = A + 0.078 s.
///
/// Until B the sustained pose is held: for 1/3 s in the paper, of which what A + 0.078 s leaves
/// lies before the contact. Both weights begin and end with no velocity, so that what is shown is
/// as smooth as the simulation and the motions are.
struct RecoverySchedule {
  double simulation_only_s = 0.075;  ///< A: the paper leaves 0.05 to 0.1 s to the animator
};

struct RecoveryWeights {
  double simulated = 1;  ///< 1 - a
  double returning = 0;  ///< b
};

/// Any time; before the contact is as at it.
RecoveryWeights weights_at(const RecoverySchedule& schedule, double since_contact_s) noexcept;

/// From when on the simulation is not shown, s after the contact.
double simulation_end_s(const RecoverySchedule& schedule) noexcept;
/// From when on only the motion returned to is shown, s after the contact.
double duration_s(const RecoverySchedule& schedule) noexcept;

}  // namespace flinch::reaction
