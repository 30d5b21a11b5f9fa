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

namespace flinch::sim {

/// A ball, and the rehearsal whose figure it flies at from time 0 on.
struct Throw {
  const Rehearsal& rehearsal;
  features::Ball ball;
};

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
  /// Returns for each throw what OdeSimulator::simulate of the rehearsed motion returns for this
  /// ball over the whole duration, in a fraction of the time and within the error bounds that
  /// docs/simulation.md gives; without the tracking error. Rehearsals must come from this
  /// simulator. A result does not depend on the other throws; many at once cost less than one by
  /// one. Throws Error if a ball touches the figure before its rehearsal starts.
  std::vector<SimulationResult> simulate(std::span<const Throw> throws) const;
  SimulationResult simulate(const Rehearsal& rehearsal, const features::Ball& ball) const;

 private:
  struct Setup;
  std::unique_ptr<const Setup> setup_;
};

}  // namespace flinch::sim
