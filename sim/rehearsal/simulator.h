// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "features/ball.h"
#include "motion/body.h"
#include "motion/clip.h"
#include "sim/rehearsal/rehearsal.h"
#include "sim/simulation_options.h"
#include "sim/simulation_result.h"
#include "sim/tree/tree_lanes.h"

namespace flinch::sim {

struct FigureModel;

/// Simulates a figure of 17 bodies that tracks a motion while balls fly at it: the motion once
/// without a ball, then each ball from where it may first touch.
///
/// Immutable: results do not depend on earlier simulations, and one simulator may serve several
/// threads at a time.
class Simulator {
 public:
  Simulator(const motion::Physique& character, const SimulationOptions& options);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;

  /// Tracks `reference` without a ball for `duration_s` and keeps the states that a ball may meet
  /// from `from_s` on.
  Rehearsal rehearse(const motion::Motion& reference, double from_s, double duration_s) const;
  /// The same for several motions, side by side in lanes as ThrowSimulator, to the same bits in a
  /// fraction of the time. What they all begin with is simulated once.
  std::vector<Rehearsal> rehearse(std::span<const motion::Motion> references, double from_s,
                                  double duration_s, std::size_t lanes = widest_lanes()) const;
  /// Returns what OdeSimulator::simulate of the rehearsed motion returns for this ball over the
  /// whole duration, in a fraction of the time and within the error bounds that docs/simulation.md
  /// gives; without the tracking error. `rehearsal` must come from this simulator. Throws Error if
  /// the ball touches the figure before the rehearsal starts. For many balls see ThrowSimulator.
  SimulationResult simulate(const Rehearsal& rehearsal, const features::Ball& ball) const;

  const FigureModel& figure_model() const;
  const SimulationOptions& options() const;

 private:
  struct Setup;
  std::unique_ptr<const Setup> setup_;
};

}  // namespace flinch::sim
