// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/rehearsal/rehearsal_track.h"
#include "sim/rehearsal/simulator.h"

namespace flinch::sim {

/// The number of the first free step of a rehearsal in which a ball may touch something, the figure
/// or the ground; nothing if there is none. Up to there a simulation is the rehearsal. Throws Error
/// if the rehearsal was not kept so early.
std::optional<std::size_t> first_possible_contact(const FigureModel& figure_model,
                                                  const SimulationOptions& options,
                                                  const Rehearsal::Track& track, const Ball& ball);

/// Simulates a ball and the figure of a rehearsal from where they may first meet to where they
/// never will again.
SimulationResult run_rehearsed(const FigureModel& figure_model, const SimulationOptions& options,
                               const Rehearsal::Track& track, const Ball& ball);

}  // namespace flinch::sim
