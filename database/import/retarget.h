// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/source_motion.h"
#include "motion/clip.h"
#include "motion/skeleton.h"

namespace flinch::database {

/// Which part of a source becomes a clip, and how it is placed.
struct Segment {
  double start_s = 0;  ///< from the source's first frame
  double end_s = 0;    ///< at least start_s and at most the source's duration
  /// Added to the pelvis' facing at the start to get the actor's facing, radians counter-clockwise.
  double heading = 0;
};

/// Puts a segment of a source on a skeleton, at a fixed rate.
///
/// Joint orientations are the source's relative to its reference pose. The middle of the hips moves
/// as the source's, scaled by the ratio of the leg lengths. The feet follow the source's, scaled
/// likewise, so that planted feet stay planted (see compute_ankle_goals); the legs reach them by
/// IK, for which the pelvis may sink a little. Elbows and knees turn about their hinges only, which
/// leaves every joint where it was. Feet and toes do not go below the ground.
///
/// The motion starts with the pelvis above the origin and the actor facing +X.
motion::Motion retarget(const SourceMotion& source, const motion::Skeleton& skeleton,
                        const Segment& segment, float rate_hz);

/// A source's frame at a time between two of its own.
SourceFrame sample(const SourceMotion& source, double time_s);

/// What the skeleton's poses take from a source: the ratio of the leg lengths.
float leg_ratio(const SourceMotion& source, const motion::Skeleton& skeleton);

/// The rotation and shift that place a segment: world = turn * (scale * source) + shift, but for
/// heights.
struct Placement {
  float yaw = 0;
  Eigen::Vector3f shift = Eigen::Vector3f::Zero();
};
Placement placement_of(const SourceMotion& source, const motion::Skeleton& skeleton,
                       const Segment& segment);

}  // namespace flinch::database
