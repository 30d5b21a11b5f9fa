// SPDX-License-Identifier: MIT
#include "sim/figure/waist_up.h"

#include <gtest/gtest.h>

#include "features/random.h"
#include "motion/default_character.h"
#include "motion/rotation.h"

namespace flinch::sim {
namespace {

using motion::Body;
using motion::Role;

FigureModel waist_up_figure() {
  return FigureModel(motion::default_character(), {.figure = FigureKind::waist_up});
}

const JointRange& range_of(Body body) {
  for (const WaistUpJoint& joint : waist_up_joints())
    if (joint.body == body) return joint.range;
  throw std::logic_error("no such joint");
}

TEST(WaistUp, HasEighteenDegreesOfFreedomInEightJoints) {
  int freedoms = 0;
  for (const WaistUpJoint& joint : waist_up_joints())
    for (int axis = 0; axis < 3; ++axis)
      freedoms += joint.range.min[axis] < joint.range.max[axis] ? 1 : 0;
  EXPECT_EQ(freedoms, 18);
  EXPECT_EQ(waist_up_joints().size(), 8U);
  const FigureModel figure = waist_up_figure();
  int free = 0;
  for (const auto& body : figure.tree.bodies)
    if (&body != figure.tree.bodies) free += body.free_axes;
  EXPECT_EQ(free, 18);
}

// The left arm of the appendix turns about its y, our z, from -2.2 (across the chest) to 1.2; the
// right one is its mirror image.
TEST(WaistUp, ArmsBendForwardsAndAreMirrorImages) {
  const JointRange& left = range_of(Body::left_upper_arm);
  EXPECT_EQ(left.min, Eigen::Vector3d(-1.2, -1.2, -2.2));
  EXPECT_EQ(left.max, Eigen::Vector3d(1.2, 1.2, 1.2));
  const Eigen::Vector3d hand = joint_rotation(left, {0, 0, -1.5}) * Eigen::Vector3d::UnitY();
  EXPECT_GT(hand.x(), 0.9) << "to the front";
  const JointRange& right = range_of(Body::right_upper_arm);
  EXPECT_EQ(right.min.z(), -1.2);
  EXPECT_EQ(right.max.z(), 2.2);
  const Eigen::Vector3d other = joint_rotation(right, {0, 0, 1.5}) * -Eigen::Vector3d::UnitY();
  EXPECT_GT(other.x(), 0.9);
  EXPECT_GT(
      (joint_rotation(range_of(Body::left_forearm), {0, 0, -2}) * Eigen::Vector3d::UnitY()).x(),
      0.5);
}

TEST(WaistUp, KeepsTheRatiosOfTheAppendixGains) {
  const FigureModel figure = waist_up_figure();
  const double unit = figure.gains[Body::left_upper_arm].stiffness / 400;
  EXPECT_GT(unit, 1);
  EXPECT_LT(unit, 20);
  for (const WaistUpJoint& joint : waist_up_joints()) {
    EXPECT_NEAR(figure.gains[joint.body].stiffness, unit * joint.gains.stiffness,
                1e-9 * unit * 5000);
    EXPECT_NEAR(figure.gains[joint.body].damping, unit * joint.gains.damping, 1e-9 * unit * 5000);
  }
}

TEST(WaistUp, HasOneDensityAndTheSameMass) {
  const motion::BodyModel people = make_body_model(motion::default_character());
  const motion::BodyModel uniform = with_uniform_density(people);
  float before = 0;
  float after = 0;
  for (const Body body : motion::kBodies) {
    before += people[body].mass_kg;
    after += uniform[body].mass_kg;
    EXPECT_EQ(uniform[body].centre_of_mass, people[body].shape.centre);
  }
  EXPECT_NEAR(after, before, 1e-3F);
  // Boxes: masses as volumes.
  const auto volume = [&](Body body) { return people[body].shape.half_extents.prod(); };
  EXPECT_NEAR(uniform[Body::chest].mass_kg / uniform[Body::left_hand].mass_kg,
              volume(Body::chest) / volume(Body::left_hand), 1e-2F);
}

TEST(WaistUp, BallsPassThroughLegsAndPelvis) {
  const FigureModel figure = waist_up_figure();
  for (const Body body : {Body::pelvis, Body::left_thigh, Body::right_foot})
    EXPECT_FALSE(contains(figure.ball_meets, body));
  for (const Body body : {Body::head, Body::abdomen, Body::left_hand})
    EXPECT_TRUE(contains(figure.ball_meets, body));
}

// Soft limits, equation 3.15.
TEST(WaistUp, PosesAreTruncatedToTheLimitsAndThoseWithinStay) {
  features::Random random(1, features::RandomStream::baseline, 0);
  motion::Pose pose = rest_pose(motion::default_character().skeleton);
  for (int i = 0; i < 100; ++i) {
    for (Eigen::Quaternionf& rotation : pose.rotation) {
      Eigen::Vector3f turn;
      for (float& x : turn) x = static_cast<float>(random.uniform(-1.5, 1.5));
      rotation = motion::rotation_from_vector<float>(turn);
    }
    const motion::Pose held = waist_up_pose(pose);
    for (const WaistUpJoint& joint : waist_up_joints()) {
      const Eigen::Vector3d angles =
          joint_angles(joint.range, held.rotation[role_of(joint.body)].cast<double>());
      EXPECT_GE((angles - joint.range.min).minCoeff(), -1e-6);
      EXPECT_GE((joint.range.max - angles).minCoeff(), -1e-6);
    }
    const motion::Pose again = waist_up_pose(held);
    for (const Role role : motion::kRoles)
      EXPECT_LT(again.rotation[role].angularDistance(held.rotation[role]), 1e-3F);
    EXPECT_EQ(held.rotation[Role::left_thigh].coeffs(), pose.rotation[Role::left_thigh].coeffs());
  }
}

}  // namespace
}  // namespace flinch::sim
