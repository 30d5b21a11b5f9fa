// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>

#include "motion/body.h"
#include "motion/clip.h"
#include "sim/rehearsal/rehearsal.h"
#include "sim/simulation_options.h"

namespace flinch::sim {

/// What one simulation found.
struct SimulationResult {
  /// Impulse that each body took from the ball, and from bodies that the ball drove into it, N·s.
  motion::PerBody<double> impulse;
  double first_contact_s = std::numeric_limits<double>::infinity();  ///< of ball and figure
  bool skipped = false;     ///< nothing could touch: nothing was simulated
  int steps = 0;            ///< that were simulated
  int solver_messages = 0;  ///< that the solver of contacts wanted to print
  /// Root mean square over time and hands, feet and head of their distance from the reference, m.
  double tracking_error_m = 0;
};

/// Simulates a figure of 17 bodies that tracks a motion while a ball flies at it.
///
/// Holds nothing that a simulation changes: each makes its own ODE world, so that results do not
/// depend on what was simulated before, and one simulator may serve several threads at a time.
class Simulator {
 public:
  Simulator(const motion::Physique& character, const SimulationOptions& options);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;

  /// Tracks `reference` (poses at its rate, from time 0) for `duration_s`; beyond its last pose it
  /// holds still. Without a ball nothing can hit. Throws Error if the physics engine fails.
  SimulationResult simulate(const motion::Motion& reference, const Ball* ball,
                            double duration_s) const;

  /// Tracks `reference` without a ball for `duration_s` and keeps what a ball may meet from
  /// `from_s` on.
  Rehearsal rehearse(const motion::Motion& reference, double from_s, double duration_s) const;
  /// What simulate() of the rehearsed motion finds for this ball over its whole duration, in a
  /// fraction of the time, within the bounds that docs/simulation.md gives; without its tracking
  /// error. `rehearsal` must come from this simulator. Throws Error if the ball
  /// touches the figure before the rehearsal begins.
  SimulationResult simulate(const Rehearsal& rehearsal, const Ball& ball) const;

 private:
  struct Setup;
  std::unique_ptr<const Setup> setup_;
};

}  // namespace flinch::sim
