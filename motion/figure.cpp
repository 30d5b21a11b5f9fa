// SPDX-License-Identifier: MIT
#include "motion/figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/rotation.h"

namespace flinch::motion {

namespace {

void bend(const LimbRoles& roles, const LimbSolution& solution, const JointFrames& frames,
          Pose& pose) {
  const Eigen::Quaternionf& parent = frames.orientation[*parent_of(roles.upper)];
  pose.rotation[roles.upper] = (parent.conjugate() * solution.upper).normalized();
  pose.rotation[roles.lower] = (solution.upper.conjugate() * solution.lower).normalized();
}

}  // namespace

Figure make_figure(const Physique& character) {
  return {character, make_body_model(character)};
}

bool solve_legs(const Skeleton& skeleton, const JointFrames& trunk, const PerSide<FootPose>& feet,
                Pose& pose) {
  bool reached = true;
  for (Side side : kSides) {
    const FootPose& place = feet[side];
    const LimbRoles roles = roles_of(leg_of(side));
    const Eigen::Vector3f knee_way = place.orientation * Eigen::Vector3f::UnitX();
    const LimbSolution solution =
        solve_limb(skeleton, leg_of(side), trunk.position[roles.upper], place.ankle, knee_way, 0);
    bend(roles, solution, trunk, pose);
    pose.rotation[roles.end] = (solution.lower.conjugate() * place.orientation).normalized();
    reached = reached && solution.reached;
  }
  return reached;
}

float max_pelvis_height(const Skeleton& skeleton, const JointFrames& trunk,
                        const PerSide<FootPose>& feet) {
  float highest = std::numeric_limits<float>::infinity();
  for (Side side : kSides) {
    const float reach = 0.997F * limb_length(skeleton, leg_of(side));
    const Eigen::Vector3f& hip = trunk.position[roles_of(leg_of(side)).upper];
    const float hip_z = max_upper_height(hip, feet[side].ankle, reach);
    highest = std::min(highest, hip_z - hip.z());
  }
  return trunk.position[Role::pelvis].z() + highest;
}

Eigen::Quaternionf solve_arm(const Skeleton& skeleton, const JointFrames& trunk, Side side,
                             const HandGoal& place, Pose& pose) {
  const LimbRoles roles = roles_of(arm_of(side));
  const LimbSolution solution = solve_limb(skeleton, arm_of(side), trunk.position[roles.upper],
                                           place.wrist, place.pole, sign_of(side) * place.swivel);
  bend(roles, solution, trunk, pose);
  return solution.lower;
}

Pose with_feet(const Skeleton& skeleton, const Pose& pose, const PerSide<FootPose>& feet) {
  Pose result = pose;
  solve_legs(skeleton, forward_kinematics(skeleton, pose), feet, result);
  return result;
}

// The angle between the components of pole and elbow perpendicular to the shoulder-wrist line.
float swivel_of(const JointFrames& frames, Side side, const Eigen::Vector3f& pole) {
  const LimbRoles roles = roles_of(arm_of(side));
  const Eigen::Vector3f line =
      (frames.position[roles.end] - frames.position[roles.upper]).normalized();
  const Eigen::Vector3f elbow = pole_vector(frames, arm_of(side));
  const Eigen::Vector3f zero = pole - pole.dot(line) * line;
  return sign_of(side) * std::atan2(line.dot(zero.cross(elbow)), zero.dot(elbow));
}

// For the left arm: from the T-pose it is lowered about x, then raised sideways about x and forward
// about -y. Elbows bend about -z.
void set_arm(Pose& pose, Side side, const ArmAngles& angles) {
  const Eigen::Quaternionf upper =
      rotation_about(Eigen::Vector3f::UnitY(), -angles.flexion) *
      rotation_about(Eigen::Vector3f::UnitX(), angles.abduction - radians(90)) *
      rotation_about(Eigen::Vector3f::UnitY(), -angles.rotation);
  const Eigen::Quaternionf lower = rotation_about(Eigen::Vector3f::UnitZ(), -angles.elbow);
  const LimbRoles roles = roles_of(arm_of(side));
  const bool left = side == Side::left;
  pose.rotation[roles.upper] = left ? upper : mirrored(upper);
  pose.rotation[roles.lower] = left ? lower : mirrored(lower);
  pose.rotation[roles.end] = Eigen::Quaternionf::Identity();
}

Eigen::Quaternionf relative_rotation(const JointFrames& frames, Role from, Role to) {
  return frames.orientation[from].conjugate() * frames.orientation[to];
}

float stature(const Skeleton& skeleton) {
  const JointFrames rest = forward_kinematics(skeleton, rest_pose(skeleton));
  return rest.position[Role::head].z() + skeleton.tip[Role::head].z();
}

}  // namespace flinch::motion
