// SPDX-License-Identifier: MIT
#pragma once

#include "motion/foot.h"
#include "motion/skeleton.h"

namespace flinch::motion {

/// The four chains that two-bone IK serves.
enum class Limb : std::uint8_t { left_arm, right_arm, left_leg, right_leg };
inline constexpr std::array<Limb, 4> kLimbs{Limb::left_arm, Limb::right_arm, Limb::left_leg,
                                            Limb::right_leg};

/// The roles along a limb: shoulder, elbow, wrist, or hip, knee, ankle.
struct LimbRoles {
  Role upper;
  Role lower;
  Role end;
};
LimbRoles roles_of(Limb limb);

Limb arm_of(Side side);
Limb leg_of(Side side);

/// The length of its two bones, m: how far the end of a straight limb is from its upper joint.
float limb_length(const Skeleton& skeleton, Limb limb);

/// How high the upper joint may rise, world z, m, with the end no farther off than `reach`; where
/// the end is farther aside than that, the end's own height.
float max_upper_height(const Eigen::Vector3f& upper_position, const Eigen::Vector3f& end_position,
                       float reach);

/// The axis of the elbow or knee in the frame of the upper joint, unit; turning the lower joint by
/// a positive angle about it bends the limb. Knees bend about +Y, which takes the shin backwards
/// from the rest pose; the left elbow about -Z and the right about +Z, which take the forearm
/// forwards from the T-pose.
Eigen::Vector3f hinge_axis(Limb limb);

/// How far elbows and knees bend, radians: the angle between the bones seen along the hinge, 0
/// where they are straight (which need not be the rest pose). From the ranges of motion of the
/// American Academy of Orthopaedic Surgeons (1965): elbow 0 to 150 degrees, knee 0 to 135, widened
/// to 150 for the passive bend of a deep crouch.
struct HingeLimits {
  float min = 0.01F;
  float max = 2.618F;
};

/// Result of solving a limb.
struct LimbSolution {
  Eigen::Quaternionf upper;  ///< orientation of the upper joint, world
  Eigen::Quaternionf lower;  ///< orientation of the lower joint, world
  bool reached = true;       ///< false: the end stays more than 0.1 mm from the target
};

/// Bends a limb so that its end joint comes to `end_position`. The end lands on the target where
/// the hinge limits allow it, for bones of any direction; else on the nearest point of the line
/// from the upper joint. The lower joint only turns about its hinge.
///
/// The swivel angle says where the middle joint goes on its circle about the line from the upper
/// joint to the end (Tolani, Goswami and Badler 2000, section 4): 0 puts it in the direction of
/// `pole_vector` (world, need not be unit), positive turns it counter-clockwise about the line.
/// Where the pole is parallel to the line any plane will do, and a fixed one is taken. The middle
/// joint of a limb within about 10 degrees of straight says little of its plane; there it is the
/// hinge that is turned so as to bend towards the pole, going over smoothly.
LimbSolution solve_limb(const Skeleton& skeleton, Limb limb, const Eigen::Vector3f& upper_position,
                        const Eigen::Vector3f& end_position, const Eigen::Vector3f& pole_vector,
                        float swivel, const HingeLimits& limits = {});

/// The direction from the line upper joint - end joint to the middle joint, world, unit: the pole
/// vector that reproduces these frames with swivel 0 if the lower joint is turned about its hinge
/// alone. Of a straight or overextended limb, the direction in which its hinge bends.
Eigen::Vector3f pole_vector(const JointFrames& frames, Limb limb);

/// Brings a limb's end joint to a place by the least change: the lower joint turns about the axis
/// of its present bend until the distance is right, then the whole limb swings there by the
/// shortest way. A limb whose end is there already stays as it is. `frames` are the pose's; only
/// the limb's and its parent's need be right. A place out of reach is approached as far as the limb
/// goes, which is as straight as it is now, if that is straighter than `limits` allow. Returns
/// whether the end came within 0.1 mm.
bool move_limb_end(const JointFrames& frames, Limb limb, const Eigen::Vector3f& end_position,
                   const Eigen::Quaternionf& end_orientation, Pose& pose,
                   const HingeLimits& limits = {});

/// The pose with one limb bent so that its end joint comes to `end_position` with the orientation
/// `end_orientation` (both world); the middle joint keeps to its plane (see pole_vector), and the
/// lower joint's rotation becomes one about its hinge alone. `reached` as in LimbSolution.
Pose with_limb_end(const Skeleton& skeleton, const Pose& pose, Limb limb,
                   const Eigen::Vector3f& end_position, const Eigen::Quaternionf& end_orientation,
                   bool* reached = nullptr);

}  // namespace flinch::motion
