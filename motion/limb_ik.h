// SPDX-License-Identifier: MIT
#pragma once

#include "motion/foot.h"
#include "motion/skeleton.h"

namespace flinch::motion {

/// The four limbs that two-bone IK solves.
enum class Limb : std::uint8_t { left_arm, right_arm, left_leg, right_leg };
inline constexpr std::array<Limb, 4> kLimbs{Limb::left_arm, Limb::right_arm, Limb::left_leg,
                                            Limb::right_leg};

/// The joints of a limb from the trunk outwards: shoulder, elbow, wrist or hip, knee, ankle.
struct LimbRoles {
  Role upper;
  Role lower;
  Role end;
};
LimbRoles roles_of(Limb limb);

Limb arm_of(Side side);
Limb leg_of(Side side);

/// Sum of the lengths of the limb's two bones, m: the distance between its ends when straight.
float limb_length(const Skeleton& skeleton, Limb limb);

/// Largest height (world z, m) of the upper joint, moved vertically, at which the end is still
/// within `reach`. Where the horizontal distance alone exceeds `reach`, returns the end's own
/// height.
float max_upper_height(const Eigen::Vector3f& upper_position, const Eigen::Vector3f& end_position,
                       float reach);

/// Unit axis of the elbow or knee in the frame of the upper joint; a positive rotation of the lower
/// joint about it bends the limb. Knees bend about +Y, which takes the shin backwards from the rest
/// pose. The left elbow bends about -Z and the right about +Z, which takes the forearm forwards
/// from the T-pose.
Eigen::Vector3f hinge_axis(Limb limb);

/// Range of elbow and knee angles, radians: the angle between the bones seen along the hinge, 0
/// where they are straight (which need not be the rest pose). From the American Academy of
/// Orthopaedic Surgeons (1965): elbow 0 to 150 degrees, knee 0 to 135, widened to 150 for the
/// passive bend of a deep crouch.
struct HingeLimits {
  float min = 0.01F;
  float max = 2.618F;
};

/// Distance between the limb's ends when it is bent as far as `limits` allow, m.
float folded_limb_length(const Skeleton& skeleton, Limb limb, const HingeLimits& limits = {});

/// Result of solving a limb.
struct LimbSolution {
  Eigen::Quaternionf upper;  ///< orientation of the upper joint, world
  Eigen::Quaternionf lower;  ///< orientation of the lower joint, world
  bool reached = true;       ///< false: the end stays more than 0.1 mm from the target
};

/// Bends a limb so that its end joint comes to `end_position`. The end lands on the target where
/// the hinge limits allow it, whatever the directions of the bones; otherwise on the nearest point
/// of the line from the upper joint.
///
/// The lower joint turns about its hinge only. The swivel angle places the middle joint on its
/// circle about the line from the upper joint to the end (Tolani, Goswami and Badler 2000, section
/// 4): 0 puts it in the direction of `pole_vector` (world, need not be unit), positive turns it
/// counter-clockwise about the line. Where the pole is parallel to the line, its plane is undefined
/// and a fixed one is used. In a limb within about 10 degrees of straight, the position of the
/// middle joint hardly defines a plane; there the hinge is turned so that it bends towards the
/// pole, with a smooth transition.
LimbSolution solve_limb(const Skeleton& skeleton, Limb limb, const Eigen::Vector3f& upper_position,
                        const Eigen::Vector3f& end_position, const Eigen::Vector3f& pole_vector,
                        float swivel, const HingeLimits& limits = {});

/// Returns the pole vector that reproduces these frames with swivel 0 if the lower joint rotates
/// about its hinge only: the unit direction, world, from the line between upper joint and end joint
/// to the middle joint. For a straight or overextended limb, returns the direction in which its
/// hinge bends.
Eigen::Vector3f pole_vector(const JointFrames& frames, Limb limb);

/// Moves a limb's end joint to a position with the least change of pose: the lower joint rotates
/// about the axis of its present bend until the distance is right, then the whole limb swings there
/// by the shortest rotation. A limb whose end is already there does not change. `frames` belong to
/// `pose`; only those of the limb and its parent need be valid. A position out of reach is
/// approached until the limb is as straight as `limits` allow, or as it is now if that is
/// straighter. Returns whether the end came within 0.1 mm.
bool move_limb_end(const JointFrames& frames, Limb limb, const Eigen::Vector3f& end_position,
                   const Eigen::Quaternionf& end_orientation, Pose& pose,
                   const HingeLimits& limits = {});

/// Returns the pose with one limb bent so that its end joint comes to `end_position` with
/// `end_orientation` (both world). The middle joint keeps its plane (see pole_vector), and the
/// lower joint's rotation becomes one about its hinge only. `reached` is as in LimbSolution.
Pose with_limb_end(const Skeleton& skeleton, const Pose& pose, Limb limb,
                   const Eigen::Vector3f& end_position, const Eigen::Quaternionf& end_orientation,
                   bool* reached = nullptr);

}  // namespace flinch::motion
