// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "motion/clip.h"
#include "sim/figure/figure_model.h"

namespace flinch::sim {

/// The character of Rose (2006), appendix A: a man from the waist up, of uniform density, whose
/// hips are held. Eight joints with 18 degrees of freedom have PD servos (section 3.2); abdomen and
/// chest are one body there, as are neck and head, and the legs are missing: here they follow the
/// motion rigidly, and balls pass through legs and pelvis.

/// A joint of the character. Its axes are those of the appendix, whose x points to the left, y up
/// and z forward, in the rest pose: here y, z and x.
struct WaistUpJoint {
  motion::Body body{};
  JointKind kind = JointKind::ball;
  JointRange range;  ///< the appendix' limits; axes that the joint does not turn about have 0
  Gains gains;       ///< k and k_d, in the thesis' units
};
std::span<const WaistUpJoint> waist_up_joints();

/// The share of the torque about the bone that twist damping leaves: 1 - d_r, d_r = 0.9.
inline constexpr double kThesisTwistShare = 0.1;

/// Returns a figure's bodies with their mass redistributed at one density for all.
motion::BodyModel with_uniform_density(motion::BodyModel model);

/// Gives a figure the character's joints, limits and servos. The thesis tells no density, so its
/// unit of torque is unknown: it is chosen so that the servo of the shoulder is critically damped
/// for the outstretched arm, c = 4 k I / k_d^2. The ratios of all gains are the appendix'.
void make_waist_up(FigureModel& figure_model);

/// Returns the nearest pose that the character can want: angles beyond the limits are truncated
/// (equation 3.15, its min and max exchanged), those that it lacks are 0.
motion::Pose waist_up_pose(const motion::Pose& pose);

/// The same for all poses of a motion.
motion::Motion waist_up_motion(motion::Motion motion);

}  // namespace flinch::sim
