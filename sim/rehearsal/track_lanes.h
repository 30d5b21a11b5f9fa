// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/rehearsal/rehearsal_track.h"

namespace flinch::sim {

/// Records tracks that are empty and have one duration, several side by side in lanes, each to the
/// bits that it has alone. What their motions begin with in common is stepped once. `lanes` as for
/// ThrowSimulator.
void record(const FigureModel& figure_model, const SimulationOptions& options,
            std::span<const std::unique_ptr<Rehearsal::Track>> tracks, std::size_t lanes);

/// Returns the time until which the references of motions are the same to the bit, s.
double common_time_s(std::span<const std::unique_ptr<Rehearsal::Track>> tracks);

}  // namespace flinch::sim
