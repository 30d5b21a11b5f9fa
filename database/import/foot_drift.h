// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/retarget.h"

namespace flinch::database {

/// How far planted feet drift in a retargeted clip.
///
/// A foot's ankle or ball counts as planted while, in the source scaled to the skeleton, it is
/// within 3 cm of its height while the foot is flat, and moves slower than 0.2 m/s, for at least
/// 0.1 s.
struct FootDrift {
  float planted_s = 0;  ///< total of both ankles and both balls
  /// Largest distance over the ground of a planted point from where it was set down, in the scaled
  /// source, m.
  float source_m = 0;
  /// Largest difference of that displacement between the retargeted and the source point, m.
  float added_m = 0;
  float lowest_sole_m = 0;  ///< lowest point of the soles; negative is below the ground
};

/// Measures a clip against the source segment that it was made from.
FootDrift measure_foot_drift(const SourceMotion& source, const motion::Skeleton& skeleton,
                             const Segment& segment, const motion::Motion& clip);

}  // namespace flinch::database
