// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "database/annotate/rest.h"
#include "database/annotate/take.h"

namespace flinch::database {

/// What the analysis of a take starts from. All vectors have one element per pose.
struct TakeSignals {
  Trajectory world;
  std::vector<JointPositions> relative;  ///< see relative_to_stance
  std::vector<float> speed_mps;          ///< see body_speed
  std::vector<float> departure_m;        ///< see departure_from_stance
  float still_limit_mps = 0;
  std::vector<FrameSpan> still;
};
TakeSignals signals_of(const motion::Figure& figure, const motion::Motion& motion);

/// One movement of a take: a candidate for a clip.
struct Movement {
  FrameSpan span;
  /// True: between two returns to a stance in which the body is never still, such as a boxer's
  /// guard. False: between two stills, or an end of the take.
  bool from_moving_stance = false;
};

/// Finds the movements of a take, in order.
///
/// Between two stills the body moves. Such a span is a movement if the pose departs by 0.1 m. It is
/// joined with the next one where that begins within a second and brings the pose back by more than
/// half: a step aside and the step back are one movement.
///
/// A span of more than 3 s, or a whole take that is still for less than a tenth of its time, is
/// split by its departure from its stance instead: a movement is a peak of that departure, above
/// 1.6 times its usual size and 5 cm, from the valley before it to the valley after it, at most 1.5
/// s to either side. Peaks with no valley below 0.6 of the lower one between them are one movement:
/// a weave.
///
/// Movements that begin or end in a T-pose are left out.
std::vector<Movement> find_movements(const TakeSignals& signals);

}  // namespace flinch::database
