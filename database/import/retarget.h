// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/import/source_motion.h"
#include "motion/clip.h"
#include "motion/skeleton.h"

namespace flinch::database {

/// The part of a source that becomes a clip, and its heading.
struct Segment {
  double start_s = 0;  ///< after the source's first frame
  double end_s = 0;    ///< at least start_s and at most the source's duration
  /// Added to the pelvis' facing at the start to get the actor's facing, radians counter-clockwise.
  double heading = 0;
};

/// Throws Error for a segment that would have more than kMaxFrames frames at this rate. `where` is
/// its place in a file, for the message.
void check_frame_count(const std::string& where, const Segment& segment, float rate_hz);

/// Retargets a segment of a source to a skeleton, sampled at a fixed rate.
///
/// Joint orientations are the source's relative to its reference pose. The midpoint of the hips
/// moves like the source's, scaled by the ratio of the leg lengths. The feet follow the source's,
/// scaled likewise, so that planted feet stay planted (see compute_ankle_goals); the legs reach
/// them by IK, for which the pelvis may be lowered a little. Elbows and knees rotate about their
/// hinges only, which does not move any joint. Feet and toes stay above the ground.
///
/// The motion starts with the pelvis above the origin and the actor facing +X.
motion::Motion retarget(const SourceMotion& source, const motion::Skeleton& skeleton,
                        const Segment& segment, float rate_hz);

/// Returns a source's frame at a time, interpolated between two of its own.
SourceFrame sample(const SourceMotion& source, double time_s);

/// Returns the scale from a source to the skeleton: the ratio of the leg lengths.
float leg_ratio(const SourceMotion& source, const motion::Skeleton& skeleton);

/// Rotation and translation that place a segment: world = turn * (scale * source) + shift. Heights
/// are treated separately.
struct Placement {
  float yaw = 0;
  Eigen::Vector3f shift = Eigen::Vector3f::Zero();
};
Placement placement_of(const SourceMotion& source, const motion::Skeleton& skeleton,
                       const Segment& segment);

}  // namespace flinch::database
