// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/import/source_figure.h"
#include "database/import/source_space.h"

namespace flinch::database {

/// A source skeleton in the library's rest pose: T-pose with straight legs, feet flat, facing +X, Z
/// up. Roles that the file does not have are identity and zero.
struct ReferencePose {
  /// From each joint's own frame to the world in this pose. A joint's orientation in the library's
  /// terms is then Q(t) * orientation^-1, which is identity in this pose.
  motion::PerRole<Eigen::Quaterniond> orientation;
  motion::PerRole<Eigen::Vector3d> position;  ///< file units, the pelvis at the origin
  motion::PerRole<Eigen::Vector3d> end;       ///< position of SourceFigure::end
  /// -1: from the OFFSETs, which form a standing human; otherwise the frame of the motion that it
  /// was taken from.
  int frame = -1;
  /// Whether the feet of the standing pose do, as those of a left-handed file do when it is read as
  /// right-handed.
  bool feet_point_backward = false;
  /// Score of that frame: 0 is upright and symmetric; above 0.5 the figure hardly stands.
  double doubt = 0;
};

/// A standing pose of a source, from which its reference pose is made.
struct StandingPose {
  BvhFrame joints;              ///< in the file's space
  Eigen::Quaterniond to_world;  ///< to Z up and facing +X
  int frame = -1;               ///< as ReferencePose::frame
  double doubt = 0;             ///< as ReferencePose::doubt
};

/// Returns the rest figure, all rotations zero, if it stands like a human, whatever its arms do.
std::optional<StandingPose> standing_rest_figure(const Bvh& bvh, const SourceFigure& figure);

/// Finds the standing pose: the rest figure where that stands like a human, whatever its arms do;
/// otherwise the most upright, symmetric frame of the motion. `up` is the motion's; the rest figure
/// may have another.
StandingPose find_standing_pose(const Bvh& bvh, const SourceFigure& figure, UpAxis up);

/// Makes the reference pose from a standing pose, whose feet are assumed flat and, in a frame of
/// the motion, whose trunk straight. Each bone of the limbs is rotated by the shortest rotation to
/// its direction in the T-pose, from the trunk outwards, so that elbows and knees straighten about
/// their own hinges. Feet rotate only about the vertical, because they are already flat.
ReferencePose make_reference_pose(const SourceFigure& figure, const StandingPose& standing);

/// Returns whether both feet point backward. Ask before with_human_ends, which takes such ends for
/// none.
bool feet_point_backward(const SourceFigure& figure, const StandingPose& standing);

/// Returns whether a figure stands like a human, with Z up: legs straight down, head above the
/// pelvis, hips level, arms straight and not raised.
bool stands_like_human(const SourceFigure& figure, const FigureFrame& frame);

}  // namespace flinch::database
