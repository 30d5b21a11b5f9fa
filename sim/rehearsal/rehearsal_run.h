// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/rehearsal/rehearsal_track.h"
#include "sim/rehearsal/simulator.h"

namespace flinch::sim {

/// Returns the index of the first free step of a rehearsal in which a ball may touch the figure or
/// the ground, or nothing if there is none. Until then a simulation equals the rehearsal. Throws
/// Error if the rehearsal was not kept from early enough.
std::optional<std::size_t> first_possible_contact(const FigureModel& figure_model,
                                                  const SimulationOptions& options,
                                                  const Rehearsal::Track& track,
                                                  const features::Ball& ball);

/// Simulates a ball and the figure of a rehearsal from the time at which they may first meet until
/// they can no longer meet.
SimulationResult run_rehearsed(const FigureModel& figure_model, const SimulationOptions& options,
                               const Rehearsal::Track& track, const features::Ball& ball);

}  // namespace flinch::sim
