// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <vector>

#include "sim/placed_impulse.h"

namespace flinch::sim {

/// Result of one simulation.
struct SimulationResult {
  /// Impulse that each body received from the ball and from bodies that the ball drove into it,
  /// N·s.
  motion::PerBody<double> impulse;
  /// The parts of `impulse` with their places, in the order of time; empty unless
  /// SimulationOptions::keeps_places.
  std::vector<PlacedImpulse> places;
  /// How far the joints were beyond their limits, summed over joints and integrated over 0.1 s
  /// after each hit, rad·s; 0 unless SimulationOptions::measures_limits.
  double limit_excess_rads = 0;
  /// Time of the first contact of ball and figure, s.
  double first_contact_s = std::numeric_limits<double>::infinity();
  bool skipped = false;     ///< nothing could touch, so nothing was simulated
  int steps = 0;            ///< number of simulated steps
  int solver_messages = 0;  ///< number of messages of the contact solver
  /// Whether all numbers stayed finite. If not, the simulation ended there and the rest is no
  /// result.
  bool is_finite = true;
  /// Distance of hands, feet and head from the reference, root mean square over time and points, m.
  double tracking_error_m = 0;
};

}  // namespace flinch::sim
