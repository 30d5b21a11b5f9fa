// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "database/import/retarget.h"

namespace flinch::tests {

/// How far head, shoulders and hands of a retargeted pose are from where the source has them, each
/// relative to the middle between the hips, m. Of two sides, the farther.
struct PlaceDeviation {
  float head = 0;
  float shoulder = 0;
  float hand = 0;  ///< of the wrist
};

/// Returns the deviations of every pose of a clip, which was retargeted from this segment of the
/// source at the source's own rate, to a skeleton of the source's size. The source's places come
/// from its file by forward kinematics, independently of the retargeting.
std::vector<PlaceDeviation> place_deviations(const database::Source& source,
                                             const motion::Skeleton& skeleton,
                                             const database::Segment& segment,
                                             const motion::Motion& clip);

/// The largest of each.
PlaceDeviation largest(const std::vector<PlaceDeviation>& deviations);

/// Returns the root mean square of a joint's angular acceleration relative to its parent, rad/s^2.
double angular_acceleration(const motion::Motion& clip, motion::Role role);

}  // namespace flinch::tests
