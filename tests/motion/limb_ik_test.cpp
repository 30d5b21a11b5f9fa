// SPDX-License-Identifier: MIT
#include "motion/limb_ik.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/default_character.h"
#include "motion/rotation.h"
#include "tests/motion/random_motion.h"

namespace flinch::motion {
namespace {

using tests::random_direction;
using tests::random_pose;
using tests::random_rotation;
using tests::uniform;

constexpr float kPi = std::numbers::pi_v<float>;

struct Solved {
  Eigen::Vector3f middle;
  Eigen::Vector3f end;
};

Solved positions(const Skeleton& skeleton, Limb limb, const Eigen::Vector3f& upper_position,
                 const LimbSolution& solution) {
  const LimbRoles roles = roles_of(limb);
  const Eigen::Vector3f middle = upper_position + solution.upper * skeleton.offset[roles.lower];
  return {middle, middle + solution.lower * skeleton.offset[roles.end]};
}

float angle_between(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(LimbIk, EndLandsOnTargetForRandomReachableTargets) {
  std::mt19937 random(1);
  int cases = 0;
  for (int i = 0; i < 500; ++i) {
    const Skeleton skeleton = tests::with_crooked_bones(default_character().skeleton, random);
    for (Limb limb : kLimbs) {
      const LimbRoles roles = roles_of(limb);
      const float upper = skeleton.offset[roles.lower].norm();
      const float lower = skeleton.offset[roles.end].norm();
      const Eigen::Vector3f from = tests::random_vector(random, 2);
      const float reach = uniform(random, 0.4F * (upper + lower), 0.97F * (upper + lower));
      const Eigen::Vector3f target = from + reach * random_direction(random);
      const LimbSolution solution = solve_limb(skeleton, limb, from, target,
                                               random_direction(random), uniform(random, -4, 4));
      EXPECT_TRUE(solution.reached);
      EXPECT_LT((positions(skeleton, limb, from, solution).end - target).norm(), 1e-4F);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 2000);
}

TEST(LimbIk, LowerJointTurnsAboutItsHingeAloneAndBends) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    const Skeleton skeleton = default_character().skeleton;
    const Limb limb = kLimbs[static_cast<std::size_t>(i) % kLimbs.size()];
    const Eigen::Vector3f target = uniform(random, 0.1F, 0.9F) * random_direction(random);
    const LimbSolution solution =
        solve_limb(skeleton, limb, Eigen::Vector3f::Zero(), target, random_direction(random), 0);
    const Eigen::Quaternionf local = solution.upper.conjugate() * solution.lower;
    const float sine = local.vec().dot(hinge_axis(limb));
    EXPECT_LT((local.vec() - sine * hinge_axis(limb)).norm(), 1e-5F);
    EXPECT_GT(sine * local.w(), 0);  // bends the anatomical way
  }
}

TEST(LimbIk, KneesBendBackwardsAndElbowsForwards) {
  const Skeleton skeleton = default_character().skeleton;
  for (Limb limb : kLimbs) {
    const LimbRoles roles = roles_of(limb);
    Pose pose = rest_pose(skeleton);
    pose.rotation[roles.lower] = Eigen::AngleAxisf(kPi / 2, hinge_axis(limb));
    const JointFrames frames = forward_kinematics(skeleton, pose);
    const Eigen::Vector3f lower = frames.position[roles.end] - frames.position[roles.lower];
    const bool is_leg = limb == Limb::left_leg || limb == Limb::right_leg;
    const Eigen::Vector3f expected = (is_leg ? -1.0F : 1.0F) * Eigen::Vector3f::UnitX();
    EXPECT_LT(angle_between(lower, expected), 1e-4F);
  }
}

// Law of cosines: a leg with bones a and b whose ends are d apart bends by pi - gamma with d^2 =
// a^2 + b^2 - 2 a b cos gamma. Bones of 3 and 4 and a distance of 5 give a right angle.
TEST(LimbIk, Solves345Triangle) {
  Skeleton skeleton = default_character().skeleton;
  skeleton.offset[Role::left_shin] = {0, 0, -0.3F};
  skeleton.offset[Role::left_foot] = {0, 0, -0.4F};
  const LimbSolution solution = solve_limb(skeleton, Limb::left_leg, Eigen::Vector3f::Zero(),
                                           {0, 0, -0.5F}, Eigen::Vector3f::UnitX(), 0);
  const Eigen::Quaternionf local = solution.upper.conjugate() * solution.lower;
  EXPECT_NEAR(Eigen::AngleAxisf(local).angle(), kPi / 2, 1e-5F);
  // The knee: 0.3^2 / 0.5 below the hip and 0.3 * 0.4 / 0.5 in front of the line.
  const Solved solved = positions(skeleton, Limb::left_leg, Eigen::Vector3f::Zero(), solution);
  EXPECT_LT((solved.middle - Eigen::Vector3f(0.24F, 0, -0.18F)).norm(), 1e-5F);
}

TEST(LimbIk, SwivelRotatesTheMiddleJointAboutTheLimbAxis) {
  std::mt19937 random(3);
  const Skeleton skeleton = default_character().skeleton;
  for (int i = 0; i < 300; ++i) {
    const Limb limb = kLimbs[static_cast<std::size_t>(i) % kLimbs.size()];
    const Eigen::Vector3f from = tests::random_vector(random, 1);
    const Eigen::Vector3f line = random_direction(random);
    const Eigen::Vector3f pole = line.cross(random_direction(random)).normalized();
    const float swivel = uniform(random, -3, 3);
    const LimbSolution solution =
        solve_limb(skeleton, limb, from, from + 0.35F * line, pole + 0.7F * line, swivel);
    const Eigen::Vector3f middle = positions(skeleton, limb, from, solution).middle - from;
    const Eigen::Vector3f expected = std::cos(swivel) * pole + std::sin(swivel) * line.cross(pole);
    const Eigen::Vector3f off_line = middle - middle.dot(line) * line;
    EXPECT_LT(angle_between(off_line, expected), 1e-3F);
  }
}

TEST(LimbIk, UnreachableTargetsAreClampedToTheNearestPointOnTheLine) {
  const Skeleton skeleton = default_character().skeleton;
  const HingeLimits limits;
  for (Limb limb : kLimbs) {
    const LimbRoles roles = roles_of(limb);
    const float a = skeleton.offset[roles.lower].norm();
    const float b = skeleton.offset[roles.end].norm();
    const Eigen::Vector3f line = Eigen::Vector3f(1, 2, -3).normalized();
    const auto end_for = [&](float distance) {
      const LimbSolution solution = solve_limb(skeleton, limb, Eigen::Vector3f::Zero(),
                                               distance * line, Eigen::Vector3f::UnitX(), 0.5F);
      EXPECT_FALSE(solution.reached);
      return positions(skeleton, limb, Eigen::Vector3f::Zero(), solution).end;
    };
    const auto length_at = [&](float bend) {
      return std::sqrt(a * a + b * b + 2 * a * b * std::cos(bend));
    };
    EXPECT_LT((end_for(3) - length_at(limits.min) * line).norm(), 1e-4F);
    EXPECT_LT((end_for(0.02F) - length_at(limits.max) * line).norm(), 1e-4F);
  }
}

TEST(LimbIk, ReturnsFiniteRotationsForDegenerateInput) {
  const Skeleton skeleton = default_character().skeleton;
  const Eigen::Vector3f zero = Eigen::Vector3f::Zero();
  const Eigen::Vector3f down = -Eigen::Vector3f::UnitZ();
  Skeleton boneless = skeleton;
  boneless.offset[Role::left_foot] = zero;
  for (const LimbSolution& solution :
       {solve_limb(skeleton, Limb::left_leg, zero, zero, down, 0),
        solve_limb(skeleton, Limb::left_leg, zero, 0.5F * down, down, 0),
        solve_limb(skeleton, Limb::left_leg, zero, 0.5F * down, zero, 0),
        solve_limb(boneless, Limb::left_leg, zero, 0.5F * down, down, 0)}) {
    EXPECT_NEAR(solution.upper.norm(), 1, 1e-5F);
    EXPECT_NEAR(solution.lower.norm(), 1, 1e-5F);
  }
}

TEST(LimbIk, PoleVectorReproducesAHingedLimb) {
  std::mt19937 random(4);
  for (int i = 0; i < 500; ++i) {
    const Skeleton skeleton = tests::with_crooked_bones(default_character().skeleton, random);
    Pose pose = random_pose(random);
    for (Limb limb : kLimbs) {
      pose.rotation[roles_of(limb).lower] =
          Eigen::AngleAxisf(uniform(random, 0.3F, 2.2F), hinge_axis(limb));
    }
    const JointFrames frames = forward_kinematics(skeleton, pose);
    for (Limb limb : kLimbs) {
      const LimbRoles roles = roles_of(limb);
      bool reached = false;
      const Pose again = with_limb_end(skeleton, pose, limb, frames.position[roles.end],
                                       frames.orientation[roles.end], &reached);
      EXPECT_TRUE(reached);
      EXPECT_LT(tests::distance(again, pose), 2e-3F);
    }
  }
}

TEST(LimbIk, WithLimbEndPlacesTheEndAndMovesNothingElse) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    const Skeleton skeleton = tests::with_crooked_bones(default_character().skeleton, random);
    const Pose pose = random_pose(random);  // includes rotations that no hinge allows
    const Limb limb = kLimbs[static_cast<std::size_t>(i) % kLimbs.size()];
    const LimbRoles roles = roles_of(limb);
    const Eigen::Vector3f from = forward_kinematics(skeleton, pose).position[roles.upper];
    const Eigen::Vector3f target = from + 0.45F * random_direction(random);
    const Eigen::Quaternionf orientation = random_rotation(random);
    const Pose result = with_limb_end(skeleton, pose, limb, target, orientation);
    const JointFrames frames = forward_kinematics(skeleton, result);
    EXPECT_LT((frames.position[roles.end] - target).norm(), 1e-4F);
    EXPECT_LT(frames.orientation[roles.end].angularDistance(orientation), 2e-3F);
    for (Role role : kRoles) {
      if (role == roles.upper || role == roles.lower || role == roles.end) continue;
      EXPECT_EQ(result.rotation[role].coeffs(), pose.rotation[role].coeffs());
    }
  }
}

TEST(LimbIk, StraighteningLegDoesNotTwist) {
  std::mt19937 random(6);
  const Skeleton skeleton = tests::with_crooked_bones(default_character().skeleton, random);
  const Eigen::Vector3f hip(0, 0.1F, 0.93F);
  const float length =
      skeleton.offset[Role::left_shin].norm() + skeleton.offset[Role::left_foot].norm();
  const auto thigh_at = [&](float reach) {
    return solve_limb(skeleton, Limb::left_leg, hip, hip - Eigen::Vector3f(0, 0, reach),
                      Eigen::Vector3f::UnitX(), 0)
        .upper;
  };
  Eigen::Quaternionf last = thigh_at(0.90F * length);
  for (float share = 0.9F; share < 1; share += 0.0005F) {
    const Eigen::Quaternionf thigh = thigh_at(share * length);
    EXPECT_LT(thigh.angularDistance(last), 0.1F) << share;
    last = thigh;
  }
}

// A leg bent by an arbitrary angle, as in recordings: not only about its hinge.
Pose with_random_leg(std::mt19937& random) {
  Pose pose = rest_pose(default_character().skeleton);
  std::uniform_real_distribution<float> angle(-0.3F, 0.3F);
  std::uniform_real_distribution<float> bend(0.0F, 1.6F);
  pose.rotation[Role::left_thigh] = rotation_about(Eigen::Vector3f::UnitY(), -0.6F * bend(random)) *
                                    rotation_about(Eigen::Vector3f::UnitX(), angle(random));
  pose.rotation[Role::left_shin] = rotation_about(Eigen::Vector3f::UnitY(), bend(random)) *
                                   rotation_about(Eigen::Vector3f::UnitZ(), angle(random));
  return pose;
}

TEST(MoveLimbEnd, ChangesNothingWhenTheEndIsAtTheGoal) {
  const Skeleton skeleton = default_character().skeleton;
  std::mt19937 random(21);
  for (int i = 0; i < 500; ++i) {
    const Pose before = with_random_leg(random);
    const JointFrames frames = forward_kinematics(skeleton, before);
    Pose after = before;
    EXPECT_TRUE(move_limb_end(frames, Limb::left_leg, frames.position[Role::left_foot],
                              frames.orientation[Role::left_foot], after));
    for (Role role : kRoles) {
      EXPECT_LT(after.rotation[role].angularDistance(before.rotation[role]), 2e-3F) << i;
    }
  }
}

// A hyperextended knee that must bend does so forwards, not farther backwards.
TEST(MoveLimbEnd, AKneeThatWasBentBackwardsBendsTheRightWay) {
  const Skeleton skeleton = default_character().skeleton;
  const Eigen::Vector3f hinge = hinge_axis(Limb::left_leg);
  for (float backwards : {0.02F, 0.1F, 0.3F}) {
    Pose pose = rest_pose(skeleton);
    pose.rotation[Role::left_shin] = rotation_about(hinge, -backwards);
    const JointFrames frames = forward_kinematics(skeleton, pose);
    const Eigen::Vector3f place = frames.position[Role::left_foot] + Eigen::Vector3f(0, 0, 0.15F);
    EXPECT_TRUE(
        move_limb_end(frames, Limb::left_leg, place, frames.orientation[Role::left_foot], pose));
    EXPECT_GT(rotation_vector(pose.rotation[Role::left_shin]).dot(hinge), 0.5F) << backwards;
  }
}

TEST(MoveLimbEnd, ReachesNearbyGoalsWithSmallRotations) {
  const Skeleton skeleton = default_character().skeleton;
  std::mt19937 random(22);
  std::uniform_real_distribution<float> part(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const Pose before = with_random_leg(random);
    const JointFrames frames = forward_kinematics(skeleton, before);
    const Eigen::Vector3f place = frames.position[Role::left_foot] +
                                  0.03F * Eigen::Vector3f(part(random), part(random), part(random));
    const Eigen::Quaternionf orientation =
        rotation_about(Eigen::Vector3f::UnitZ(), 0.3F * part(random));
    Pose after = before;
    const bool reached = move_limb_end(frames, Limb::left_leg, place, orientation, after);
    const JointFrames moved = forward_kinematics(skeleton, after);
    const float missed = (moved.position[Role::left_foot] - place).norm();
    EXPECT_TRUE(std::abs(missed - 1e-4F) < 2e-5F || reached == (missed < 1e-4F)) << missed;
    EXPECT_LT(missed, 0.031F);
    EXPECT_LT(moved.orientation[Role::left_foot].angularDistance(orientation), 2e-3F);
    if (reached) {
      // A small displacement of the end moves the knee little, except near a straight leg.
      EXPECT_LT((moved.position[Role::left_shin] - frames.position[Role::left_shin]).norm(), 0.2F);
    }
  }
}

}  // namespace
}  // namespace flinch::motion
