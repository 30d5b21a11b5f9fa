// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>

#include "motion/body.h"
#include "motion/clip.h"
#include "sim/rehearsal/rehearsal.h"
#include "sim/simulation_options.h"

namespace flinch::sim {

/// Result of one simulation.
struct SimulationResult {
  /// Impulse that each body received from the ball and from bodies that the ball drove into it,
  /// N·s.
  motion::PerBody<double> impulse;
  /// Time of the first contact of ball and figure, s.
  double first_contact_s = std::numeric_limits<double>::infinity();
  bool skipped = false;     ///< nothing could touch, so nothing was simulated
  int steps = 0;            ///< number of simulated steps
  int solver_messages = 0;  ///< number of messages of the contact solver
  /// Distance of hands, feet and head from the reference, root mean square over time and points, m.
  double tracking_error_m = 0;
};

/// Simulates a figure of 17 bodies that tracks a motion while a ball flies at it.
///
/// Immutable: each simulation creates its own ODE world, so results do not depend on earlier
/// simulations, and one simulator may serve several threads at a time.
class Simulator {
 public:
  Simulator(const motion::Physique& character, const SimulationOptions& options);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;

  /// Tracks `reference` (poses at its rate, from time 0) for `duration_s`; the figure holds still
  /// beyond its last pose. Without a ball there are no hits. Throws Error if the physics engine
  /// fails.
  SimulationResult simulate(const motion::Motion& reference, const features::Ball* ball,
                            double duration_s) const;

  /// Tracks `reference` without a ball for `duration_s` and keeps the states that a ball may meet
  /// from `from_s` on.
  Rehearsal rehearse(const motion::Motion& reference, double from_s, double duration_s) const;
  /// Returns what simulate() of the rehearsed motion returns for this ball over the whole duration,
  /// in a fraction of the time and within the error bounds that docs/simulation.md gives; without
  /// the tracking error. `rehearsal` must come from this simulator. Throws Error if the ball
  /// touches the figure before the rehearsal starts.
  SimulationResult simulate(const Rehearsal& rehearsal, const features::Ball& ball) const;

 private:
  struct Setup;
  std::unique_ptr<const Setup> setup_;
};

}  // namespace flinch::sim
