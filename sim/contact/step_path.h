// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "features/ball.h"
#include "sim/body_set.h"
#include "sim/body_state.h"
#include "sim/figure/figure_model.h"

namespace flinch::sim {

/// The figure during a step that took it from `from` to `to`. A step moves bodies straight on with
/// the velocities at its end (moved_on), while their velocities change in proportion to the time.
struct StepPath {
  const motion::PerBody<BodyState>& from;
  const motion::PerBody<BodyState>& to;
  double step_s = 0;

  BodyState at(motion::Body body, double time_s) const;
  motion::PerBody<BodyState> at(double time_s) const;
  /// The body at the step's start with the velocities that move it.
  BodyState moving(motion::Body body) const;
};

/// Whether a ball may come within `distance_m` of a part that keeps its velocities within `time_s`.
/// Tests the sphere of `radius` about the part's centre of mass.
bool may_reach(const BodyState& part, double radius, const features::Ball& ball, double time_s,
               double distance_m);

/// Returns the first time of a step at which a ball in free flight touches a body and does not
/// separate from it (`hits`), or `bounce_s` if it reaches the ground before, or nothing if there is
/// neither. Never late, and early by at most the time in which the gap changes by
/// kContactDistance_m.
std::optional<double> first_contact(const FigureModel& figure_model, const StepPath& path,
                                    const features::Ball& ball, std::optional<double> bounce_s);

}  // namespace flinch::sim
