// SPDX-License-Identifier: MIT
#pragma once

#include "sim/encounter/encounter.h"
#include "sim/rehearsal/rehearsal_track.h"
#include "sim/rehearsal/simulator.h"

namespace flinch::sim {

/// Simulates a ball and the figure of a rehearsal from their first contact until they can no longer
/// meet, then the next ball, which may meet another rehearsal. Allocates nothing for a ball, except
/// for more contacts than ever before.
class RehearsalRun {
 public:
  /// Both arguments must outlive this.
  RehearsalRun(const FigureModel& figure_model, const SimulationOptions& options);

  /// Goes to the first contact. Returns whether there is a step to take from there; if not, the
  /// result is complete. `track` must outlive the run. Throws Error as Simulator::simulate.
  bool start(const Rehearsal::Track& track, const features::Ball& ball);
  /// Takes a step. Returns whether there is another to take; if not, the result is complete.
  bool step();
  const SimulationResult& result() const { return result_; }

 private:
  bool begin_step();
  bool leaves(double time_s) const;

  const FigureModel& figure_model_;
  const SimulationOptions& options_;
  Encounter<TreeScene> encounter_;
  const Rehearsal::Track* track_ = nullptr;
  ReferenceState now_;
  double step_s_ = 0;  ///< of the step that has begun
  SimulationResult result_;
};

}  // namespace flinch::sim
