// SPDX-License-Identifier: MIT
#pragma once

#include "motion/figure.h"

namespace flinch::database {

/// Trajectory of a foot in a transition: at rest, or stepping during a part of it.
struct FootStep {
  motion::FootPose from;
  motion::FootPose to;
  bool moves = false;
  float begin = 0;  ///< fraction of the transition, in [0, 1]
  float end = 1;
  float lift_m = 0;  ///< height of the arc above the straight line
};

/// A transition from one pose to another (Hermens 2006, section 4.3). Feet that stay are on the
/// ground throughout; others step.
struct Transition {
  motion::Pose from;
  motion::Pose to;
  motion::PerSide<FootStep> steps;
  /// The foot from which the first pass computes the figure: of those that stay, the one nearer to
  /// the centre of mass. None where both step: then the pelvis moves in a straight line.
  std::optional<motion::Side> support;
  motion::JointFrames from_frames;
  motion::JointFrames to_frames;
  Eigen::Vector3f from_centre;  ///< of mass, world, m
  Eigen::Vector3f to_centre;
  /// Whether a hand moves by interpolated joint angles, because on a straight line it would come
  /// too close to its shoulder, the trunk or the head.
  motion::PerSide<bool> hand_swings{};
  motion::PerSide<float> from_swivel{};  ///< of the arms, radians
  motion::PerSide<float> to_swivel{};
};

/// Makes a transition. Feet that differ by more than 5 mm or 1 degree step. If both do, the leading
/// one steps first, and one foot is always on the ground.
Transition make_transition(const motion::Figure& figure, const motion::Pose& from,
                           const motion::Pose& to);

/// Returns the pose at the fraction `s` of a transition, clamped to [0, 1] and eased in and out.
/// Hands move on straight lines (or by joint angles, where those are blocked) with interpolated
/// swivel angles. A second pass then places the pelvis so that the centre of mass is above its
/// straight line and the base of the neck is on its own; the legs follow by IK.
motion::Pose pose_at(const motion::Figure& figure, const Transition& transition, float s);

}  // namespace flinch::database
