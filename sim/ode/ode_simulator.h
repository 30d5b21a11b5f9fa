// SPDX-License-Identifier: MIT
#pragma once

#include "motion/clip.h"
#include "sim/figure/figure_model.h"
#include "sim/simulation_options.h"
#include "sim/simulation_result.h"

namespace flinch::sim {

/// The slow reference of Simulator: a figure in an ODE world that tracks a motion from its start,
/// while a ball flies at it.
///
/// Immutable: each simulation creates its own ODE world, so results do not depend on earlier
/// simulations, and one simulator may serve several threads at a time.
class OdeSimulator {
 public:
  OdeSimulator(const motion::Physique& character, const SimulationOptions& options);

  /// Tracks `reference` (poses at its rate, from time 0) for `duration_s`; the figure holds still
  /// beyond its last pose. Without a ball there are no hits. Throws Error if the physics engine
  /// fails.
  SimulationResult simulate(const motion::Motion& reference, const features::Ball* ball,
                            double duration_s) const;

 private:
  FigureModel figure_model_;
  SimulationOptions options_;
};

}  // namespace flinch::sim
