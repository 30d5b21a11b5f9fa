// SPDX-License-Identifier: MIT
#include "motion/pose_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/default_character.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

constexpr float kBetween_s = 0.05F;

struct Moving {
  Pose before;
  Pose now;
};
Moving random_moving(std::mt19937& random) {
  Moving moving{tests::random_pose(random, 0.5F), tests::random_pose(random, 0.5F)};
  return moving;
}

/// D^2 by its formula, body by body in the world.
double squared_by_formula(const Physique& man, const Moving& one, const Moving& other) {
  const BodyModel model = make_body_model(man);
  const auto seen = [&](const Moving& moving, const Pose& pose, Body body) {
    const Eigen::Vector3f centre =
        centre_of_mass(model, forward_kinematics(man.skeleton, pose), body);
    const Eigen::Vector3f ground(moving.now.root_position.x(), moving.now.root_position.y(), 0);
    const Eigen::AngleAxisf turn(-facing(moving.now), Eigen::Vector3f::UnitZ());
    return Eigen::Vector3f(turn * (centre - ground));
  };
  double sum = 0;
  for (const Body body : kBodies) {
    const Eigen::Vector3f x = seen(one, one.now, body) - seen(other, other.now, body);
    const Eigen::Vector3f before = seen(one, one.before, body) - seen(other, other.before, body);
    const Eigen::Vector3f v = (x - before) / kBetween_s;
    sum += double{model[body].mass_kg / man.mass_kg} *
           (double{x.squaredNorm()} + 0.01 * double{v.squaredNorm()});
  }
  return sum;
}

TEST(PoseDistance, MatchesItsFormulaWhereverTheCharactersAre) {
  const Physique man = default_character();
  const PoseMetric metric(man);
  std::mt19937 random(4);
  for (int k = 0; k < 30; ++k) {
    const Moving one = random_moving(random);
    const Moving other = random_moving(random);
    const PoseFeatures a = metric.features(one.before, one.now, kBetween_s);
    const PoseFeatures b = metric.features(other.before, other.now, kBetween_s);
    const double expected = squared_by_formula(man, one, other);
    EXPECT_NEAR(double{squared_distance(a, b)}, expected, 1e-4 * expected);
    EXPECT_EQ(squared_distance(a, a), 0);
    const float yaw = tests::uniform(random, -3, 3);
    const Eigen::Vector3f place(tests::uniform(random, -9, 9), 2, 0);
    const PoseFeatures moved =
        metric.features(placed(one.before, yaw, place), placed(one.now, yaw, place), kBetween_s);
    EXPECT_LT(squared_distance(a, moved), 1e-6F);
    // A bound stops the sum, above it.
    const auto whole = static_cast<float>(expected);
    EXPECT_GT(squared_distance(a, b, 0.5F * whole), 0.5F * whole);
    EXPECT_EQ(squared_distance(a, b, 1.1F * whole), squared_distance(a, b));
  }
}

}  // namespace
}  // namespace flinch::motion
