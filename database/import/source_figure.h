// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/import/bvh.h"
#include "database/import/role_map.h"
#include "motion/role.h"

namespace flinch::database {

/// A point fixed to a joint.
struct Landmark {
  int joint = -1;                                    ///< index into Bvh::joints
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< in the joint's frame, file units
};

/// The joints and end points of a file that retargeting uses: the joint of each role, and the far
/// end of its segment. In a limb, that is the next joint or, at its end, the End Site; in a hand
/// the farthest fingertip; in a head its own End Site. Nothing where the file has none.
struct SourceFigure {
  motion::PerRole<int> joint{};
  /// The joint that the segment turns with: that of the role but for a foot whose ankle is split
  /// in two joints.
  motion::PerRole<int> carrier{};
  motion::PerRole<std::optional<Landmark>> end;

  bool has(motion::Role role) const { return joint[role] >= 0; }
};
SourceFigure source_figure(const Bvh& bvh, const RoleMap& roles);

/// The figure in one frame, rotated by a constant rotation of the file's space. Roles that the file
/// does not have are zero.
struct FigureFrame {
  motion::PerRole<Eigen::Vector3d> position;
  motion::PerRole<Eigen::Quaterniond> orientation;  ///< from the frame of SourceFigure::carrier
  motion::PerRole<Eigen::Vector3d> end;             ///< position of SourceFigure::end
};
FigureFrame figure_frame(const SourceFigure& figure, const BvhFrame& frame,
                         const Eigen::Quaterniond& turn);

/// Returns the sum of the lengths of thigh and shin, mean of both sides.
double leg_length(const FigureFrame& frame);

/// Returns the midpoint between the hip joints.
Eigen::Vector3d hip_centre(const FigureFrame& frame);

/// Returns the direction from the right side to the left, unit: the mean of the directions between
/// the hips and between the shoulders.
Eigen::Vector3d leftward(const FigureFrame& frame);

/// Returns the nearest ancestor role that the file has; nothing for the pelvis.
std::optional<motion::Role> parent_in(const SourceFigure& figure, motion::Role role);

}  // namespace flinch::database
