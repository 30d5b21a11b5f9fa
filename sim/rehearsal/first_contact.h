// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/rehearsal/rehearsal_track.h"

namespace flinch::sim {

/// Where a ball first touches the figure of a rehearsal or the ground.
struct FirstContact {
  double time_s = 0;
  bool is_bounce = false;             ///< off the ground, before any contact with the figure
  motion::PerBody<BodyState> figure;  ///< then
};

/// Sweeps a ball, given at time 0, along a rehearsal. Returns its first contact, or nothing if
/// there is none. Throws Error if the rehearsal was not kept from early enough.
std::optional<FirstContact> first_contact(const FigureModel& figure_model,
                                          const Rehearsal::Track& track,
                                          const features::Ball& ball);

}  // namespace flinch::sim
