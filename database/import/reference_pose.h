// SPDX-License-Identifier: MIT
#pragma once

#include "database/import/source_figure.h"
#include "database/import/source_space.h"

namespace flinch::database {

/// A source skeleton in the rest pose of the library's: T-pose with straight legs, feet flat,
/// facing +X, Z up. Roles that the file does not have are identity and zero.
struct ReferencePose {
  /// From each joint's own frame to the world, when the figure stands so. A joint's orientation in
  /// the library's terms is then Q(t) * orientation^-1, which is identity in this pose.
  motion::PerRole<Eigen::Quaterniond> orientation;
  motion::PerRole<Eigen::Vector3d> position;  ///< file units, the pelvis at the origin
  motion::PerRole<Eigen::Vector3d> end;       ///< where SourceFigure::end is
  /// -1: from the OFFSETs, which stand like a human; else the frame of the motion that it was
  /// taken from.
  int frame = -1;
  /// Of that frame: 0 is upright and symmetric; above 0.5 the figure hardly stands.
  double doubt = 0;
};

/// Finds the reference pose. From the rest figure where it stands like a human, whatever its arms
/// do; else from the most upright, symmetric frame of the motion, in which the feet are taken to
/// be flat and the trunk straight. From there each bone of the limbs turns by the least rotation
/// onto its direction in the T-pose, going down the chain, so that elbows and knees unbend about
/// their own hinges. Feet only turn about the vertical: they were flat before.
///
/// `up` is the motion's; the rest figure may have another.
ReferencePose find_reference_pose(const Bvh& bvh, const SourceFigure& figure, UpAxis up);

/// Whether a figure stands like a human, Z being up: legs straight down, head above the pelvis,
/// hips level, arms straight and not raised.
bool stands_like_human(const SourceFigure& figure, const FigureFrame& frame);

}  // namespace flinch::database
