// SPDX-License-Identifier: MIT
#pragma once

#include "sim/rehearsal/rehearsal_track.h"
#include "sim/rehearsal/simulator.h"

namespace flinch::sim {

/// Simulates a ball and the figure of a rehearsal from their first contact until they can no
/// longer meet.
SimulationResult run_rehearsed(const FigureModel& figure_model, const SimulationOptions& options,
                               const Rehearsal::Track& track, const features::Ball& ball);

}  // namespace flinch::sim
