// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/retarget.h"

namespace flinch::database {

/// How planted feet fare in a retargeted clip.
///
/// A foot's ankle or ball is planted while, in the source scaled to the skeleton, it is within 3 cm
/// of the height that it has while the foot stands flat and moves slower than 0.2 m/s, for at least
/// 0.1 s.
struct FootDrift {
  float planted_s = 0;  ///< together, of both ankles and both balls
  /// How far planted points wander over the ground from where they were set down: the largest, in
  /// the scaled source, m.
  float source_m = 0;
  /// How far the retargeted points are from making the same way as the source's: the largest, m.
  float added_m = 0;
  float lowest_sole_m = 0;  ///< lowest point of the soles: negative is under the ground
};

/// Measures a clip against the segment that it was made from.
FootDrift measure_foot_drift(const SourceMotion& source, const motion::Skeleton& skeleton,
                             const Segment& segment, const motion::Motion& clip);

}  // namespace flinch::database
