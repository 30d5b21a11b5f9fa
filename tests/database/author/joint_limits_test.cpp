// SPDX-License-Identifier: MIT
#include "motion/joint_limits.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "author_scene.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

using motion::clamp_to_limits;
using motion::degrees;
using motion::human_joint_limits;
using motion::joint_angles;
using motion::joint_limits_named;
using motion::JointLimits;
using motion::limit_excess;
using motion::radians;
using motion::Role;
using motion::rotation_about;
using motion::rotation_of_angles;
using motion::Side;

Eigen::Vector3f angles_deg(std::string_view name, const motion::JointFrames& frames) {
  const JointLimits& limits = joint_limits_named(name);
  return joint_angles(limits, relative_rotation(frames, limits.from, limits.to))
      .unaryExpr([](float angle) { return degrees(angle); });
}

motion::JointFrames frames_with_arm(const motion::ArmAngles& angles) {
  const test::AuthorScene scene;
  motion::Pose pose = motion::rest_pose(scene.figure.skeleton());
  for (Side side : motion::kSides) set_arm(pose, side, angles);
  return motion::forward_kinematics(scene.figure.skeleton(), pose);
}

TEST(JointLimits, AreSymmetric) {
  const motion::JointFrames frames =
      frames_with_arm({radians(40), radians(25), radians(10), radians(70)});
  for (const char* joint : {"shoulder", "elbow", "wrist"}) {
    EXPECT_LT((angles_deg(std::string("left_") + joint, frames) -
               angles_deg(std::string("right_") + joint, frames))
                  .norm(),
              0.01F)
        << joint;
  }
}

TEST(JointLimits, AllowHumanPosesOnly) {
  const auto shoulder_excess = [](const motion::ArmAngles& angles) {
    const motion::JointFrames frames = frames_with_arm(angles);
    const JointLimits& limits = joint_limits_named("left_shoulder");
    return degrees(limit_excess(limits, relative_rotation(frames, limits.from, limits.to)));
  };
  EXPECT_EQ(shoulder_excess({0, 0, 0, 0}), 0);                                  // hanging
  EXPECT_EQ(shoulder_excess({radians(90), 0, 0, 0}), 0);                        // to the front
  EXPECT_EQ(shoulder_excess({radians(170), radians(5), 0, 0}), 0);              // overhead
  EXPECT_EQ(shoulder_excess({0, radians(90), radians(80), 0}), 0);              // hands up
  EXPECT_EQ(shoulder_excess({radians(-25), radians(10), 0, 0}), 0);             // to the back
  EXPECT_GT(shoulder_excess({radians(-110), radians(10), 0, 0}), 10);           // far to the back
  EXPECT_GT(shoulder_excess({radians(20), radians(10), radians(120), 0}), 10);  // twisted
}

TEST(JointLimits, ABoundWithoutTrigonometryAdmitsOnlyWhatIsWithin) {
  std::mt19937 random(7);
  std::normal_distribution<float> normal;
  for (const JointLimits& limits : human_joint_limits()) {
    int within = 0;
    int clearly = 0;
    for (int i = 0; i < 4000; ++i) {
      // From next to the reference to half a turn from it, with either sign of the quaternion.
      const float spread = std::ldexp(1.0F, -(i % 8));
      const Eigen::Vector3f turn(normal(random), normal(random), normal(random));
      Eigen::Quaternionf rotation = rotation_of_angles(limits, 3 * spread * turn);
      if (random() % 2 == 0) rotation.coeffs() *= -1;
      const bool is_within = limit_excess(limits, rotation) <= 0;
      const bool is_clear = is_clearly_within(limits, rotation);
      ASSERT_TRUE(is_within || !is_clear) << limits.name;
      within += is_within ? 1 : 0;
      clearly += is_clear ? 1 : 0;
    }
    EXPECT_GT(within, 200) << limits.name;
    EXPECT_LT(within, 3800) << limits.name;
    EXPECT_GT(clearly, within * 8 / 10) << limits.name;
  }
}

TEST(JointLimits, AnElbowBendsOneWay) {
  const JointLimits& elbow = joint_limits_named("right_elbow");
  const auto bent = [](float angle) {
    return rotation_about(Eigen::Vector3f::UnitZ(), radians(angle));
  };
  EXPECT_EQ(limit_excess(elbow, bent(120)), 0);
  EXPECT_NEAR(degrees(limit_excess(elbow, bent(-45))), 40, 0.01);
}

TEST(JointLimits, AnglesRoundTripThroughTheRotation) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> part(0, 1);
  for (const JointLimits& limits : human_joint_limits()) {
    for (int i = 0; i < 50; ++i) {
      Eigen::Vector3f angles;
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        angles[axis] = limits.min[axis] + part(random) * (limits.max[axis] - limits.min[axis]);
      }
      const Eigen::Quaternionf rotation = rotation_of_angles(limits, angles);
      EXPECT_LT((joint_angles(limits, rotation) - angles).norm(), 2e-3F) << limits.name;
      EXPECT_LT(limit_excess(limits, rotation), 2e-3F) << limits.name;
    }
  }
}

TEST(JointLimits, ClampedRotationsAreWithinTheLimits) {
  std::mt19937 random(8);
  std::normal_distribution<float> normal;
  for (const JointLimits& limits : human_joint_limits()) {
    for (int i = 0; i < 50; ++i) {
      const Eigen::Quaternionf any =
          Eigen::Quaternionf(normal(random), normal(random), normal(random), normal(random))
              .normalized();
      EXPECT_LT(limit_excess(limits, clamp_to_limits(limits, any)), 5e-3F) << limits.name;
    }
  }
}

TEST(JointLimits, UnknownNamesAreRefused) {
  EXPECT_THROW(joint_limits_named("left_wing"), Error);
}

}  // namespace
}  // namespace flinch::database
