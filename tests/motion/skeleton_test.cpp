// SPDX-License-Identifier: MIT
#include "motion/skeleton.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/default_character.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

using tests::random_pose;

// Forward kinematics with 4x4 matrices in double, from the root down each chain.
Eigen::Isometry3d by_matrices(const Skeleton& skeleton, const Pose& pose, Role role) {
  Eigen::Isometry3d local = Eigen::Isometry3d::Identity();
  const std::optional<Role> parent = parent_of(role);
  const Eigen::Vector3f& offset = parent ? skeleton.offset[role] : pose.root_position;
  local.translate(offset.cast<double>());
  local.rotate(pose.rotation[role].cast<double>().toRotationMatrix());
  return parent ? by_matrices(skeleton, pose, *parent) * local : local;
}

TEST(ForwardKinematics, MatchesMatrixProducts) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const Skeleton skeleton = tests::with_crooked_bones(default_character().skeleton, random);
    const Pose pose = random_pose(random);
    const JointFrames frames = forward_kinematics(skeleton, pose);
    for (Role role : kRoles) {
      const Eigen::Isometry3d expected = by_matrices(skeleton, pose, role);
      EXPECT_LT((frames.position[role].cast<double>() - expected.translation()).norm(), 1e-5);
      EXPECT_LT((frames.orientation[role].cast<double>().toRotationMatrix() - expected.linear())
                    .cwiseAbs()
                    .maxCoeff(),
                1e-5);
    }
  }
}

TEST(ForwardKinematics, SubsetOfRolesMatchesAllRolesBitForBit) {
  std::mt19937 random(3);
  const Skeleton skeleton = tests::with_crooked_bones(default_character().skeleton, random);
  constexpr std::array kArm{Role::pelvis,        Role::abdomen,        Role::chest,
                            Role::left_clavicle, Role::left_upper_arm, Role::left_forearm};
  for (int i = 0; i < 100; ++i) {
    const Pose pose = random_pose(random);
    const JointFrames all = forward_kinematics(skeleton, pose);
    const JointFrames some = forward_kinematics(skeleton, pose, kArm);
    for (Role role : kArm) {
      EXPECT_EQ(some.position[role], all.position[role]);
      EXPECT_EQ(some.orientation[role].coeffs(), all.orientation[role].coeffs());
    }
  }
}

TEST(ForwardKinematics, IsInvertedByPoseFromFrames) {
  std::mt19937 random(2);
  const Skeleton skeleton = default_character().skeleton;
  for (int i = 0; i < 100; ++i) {
    const Pose pose = random_pose(random);
    EXPECT_LT(tests::distance(pose_from_frames(forward_kinematics(skeleton, pose)), pose), 1e-5F);
  }
}

TEST(Facing, IsTheYawOfThePelvis) {
  for (float yaw : {-3.0F, -1.0F, 0.0F, 0.5F, 3.1F}) {
    EXPECT_NEAR(facing(placed(rest_pose(default_character().skeleton), yaw, {1, 2, 0})), yaw,
                1e-5F);
  }
}

TEST(Placed, MovesEveryJointRigidly) {
  std::mt19937 random(3);
  const Skeleton skeleton = default_character().skeleton;
  const Pose pose = random_pose(random);
  const Eigen::Vector3f move(3, -2, 0.5F);
  const Eigen::AngleAxisf turn(0.8F, Eigen::Vector3f::UnitZ());
  const JointFrames before = forward_kinematics(skeleton, pose);
  const JointFrames after = forward_kinematics(skeleton, placed(pose, 0.8F, move));
  for (Role role : kRoles) {
    EXPECT_LT((after.position[role] - (turn * before.position[role] + move)).norm(), 1e-5F);
  }
}

TEST(DefaultCharacter, Is175CentimetresTallAndStandsOnTheGround) {
  const Physique man = default_character();
  const JointFrames rest = forward_kinematics(man.skeleton, rest_pose(man.skeleton));
  EXPECT_NEAR((rest.position[Role::head] + man.skeleton.tip[Role::head]).z(), 1.75F, 1e-5F);
  EXPECT_NEAR(rest.position[Role::left_foot].z(), 0.039F * 1.75F, 1e-5F);
  EXPECT_NEAR(rest.position[Role::left_shin].z(), 0.285F * 1.75F, 1e-5F);
  for (Role role : kRoles) {
    const Eigen::Vector3f& offset = man.skeleton.offset[role];
    const Eigen::Vector3f& other = man.skeleton.offset[mirrored(role)];
    EXPECT_EQ(offset, Eigen::Vector3f(other.x(), -other.y(), other.z()));
    EXPECT_TRUE(man.skeleton.tip[role].allFinite());
    EXPECT_GT(man.skeleton.tip[role].norm(), 0.01F);
  }
}

}  // namespace
}  // namespace flinch::motion
