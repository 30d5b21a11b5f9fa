// SPDX-License-Identifier: MIT
#pragma once

#include "motion/figure.h"

namespace flinch::database {

/// A foot's way through a transition: still, or in a step between two parts of it.
struct FootStep {
  motion::FootPose from;
  motion::FootPose to;
  bool moves = false;
  float begin = 0;  ///< in [0, 1], parts of the transition
  float end = 1;
  float lift_m = 0;  ///< height of the arc above the straight way
};

/// How to go from one pose to another (Hermens 2006, section 4.3), feet on the ground where they
/// stay or step.
struct Transition {
  motion::Pose from;
  motion::Pose to;
  motion::PerSide<FootStep> steps;
  /// The foot that the figure hangs from in the first pass: the one nearer to the centre of mass
  /// that stays. None where both step: then the pelvis goes straight.
  std::optional<motion::Side> support;
  motion::JointFrames from_frames;
  motion::JointFrames to_frames;
  Eigen::Vector3f from_centre;  ///< of mass, world, m
  Eigen::Vector3f to_centre;
  /// Whether a hand that on its straight way would come too near to its shoulder, the trunk or the
  /// head swings by the arm's joints instead.
  motion::PerSide<bool> hand_swings{};
  motion::PerSide<float> from_swivel{};  ///< of the arms, radians
  motion::PerSide<float> to_swivel{};
};

/// Feet that differ by more than 5 mm or 1 degree step; where both do, the one ahead goes first,
/// and one foot is always down.
Transition make_transition(const motion::Figure& figure, const motion::Pose& from,
                           const motion::Pose& to);

/// The pose at part `s` of a transition, 0 to 1, clamped: eased in and out; hands on straight lines
/// (or swings, where those are blocked) with swivel angles between; then, in a second pass, the
/// pelvis placed so that the centre of mass is above its straight line and the base of the neck on
/// its own, legs by IK.
motion::Pose pose_at(const motion::Figure& figure, const Transition& transition, float s);

}  // namespace flinch::database
