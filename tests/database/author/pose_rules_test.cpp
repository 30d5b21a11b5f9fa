// SPDX-License-Identifier: MIT
#include "database/rules/pose_rules.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "author_scene.h"
#include "database/author/static_balance.h"
#include "motion/body_distance.h"
#include "motion/error.h"
#include "motion/joint_limits.h"

namespace flinch::database {
namespace {

using motion::degrees;
using motion::joint_limits_named;
using motion::JointFrames;
using motion::JointLimits;
using motion::limit_excess;
using motion::Pose;
using motion::radians;
using motion::Role;
using motion::rotation_about;
using motion::Side;
using motion::Target;
using test::angle_about;
using test::AuthorScene;

const Eigen::Vector3f kX = Eigen::Vector3f::UnitX();
const Eigen::Vector3f kY = Eigen::Vector3f::UnitY();
const Eigen::Vector3f kZ = Eigen::Vector3f::UnitZ();

constexpr float kTolerance = 0.01F;  // degrees

// Rotations of the spine's joints from the identity pose, degrees about an axis.
struct SpineAngles {
  float pelvis, waist, back, neck_and_head;
};
SpineAngles spine_angles(const Pose& pose, const Eigen::Vector3f& axis) {
  return {
      angle_about(pose.rotation[Role::pelvis], axis),
      angle_about(pose.rotation[Role::abdomen], axis),
      angle_about(pose.rotation[Role::chest], axis),
      angle_about(pose.rotation[Role::neck], axis) + angle_about(pose.rotation[Role::head], axis)};
}

void expect_angles(const SpineAngles& found, const SpineAngles& expected) {
  EXPECT_NEAR(found.pelvis, expected.pelvis, kTolerance);
  EXPECT_NEAR(found.waist, expected.waist, kTolerance);
  EXPECT_NEAR(found.back, expected.back, kTolerance);
  EXPECT_NEAR(found.neck_and_head, expected.neck_and_head, kTolerance);
}

TEST(RuleControls, FollowTable31) {
  AimedThreat threat;
  threat.threat.velocity = {22.8F + 0.25F * (29.7F - 22.8F), 0, 0};
  threat.threat.radius = 0.033F + 0.75F * (0.2F - 0.033F);
  const RuleControls controls = rule_controls(threat);
  EXPECT_NEAR(controls.lean, 0.25F, 1e-5);
  EXPECT_NEAR(controls.turn, 0.75F, 1e-5);
  EXPECT_NEAR(controls.recoil, 0.75F, 1e-5);
  for (Side side : motion::kSides) {
    EXPECT_NEAR(controls.reach[side], 0.75F, 1e-5);
    EXPECT_NEAR(controls.swivel[side], 0.75F, 1e-5);
  }
}

TEST(RuleControls, AreClampedBeyondTheirRanges) {
  AimedThreat threat;
  threat.threat.velocity = {100, 0, 0};
  threat.threat.radius = 0.001F;
  EXPECT_EQ(rule_controls(threat).lean, 1);
  EXPECT_EQ(rule_controls(threat).turn, 0);
}

TEST(LeanAway, ReachesTable32sMaximaForAFrontalThreat) {
  expect_angles(spine_angles(lean_away(Pose(), -kX, 1, {1, 0}), kY), {-15, -10, -25, -50});
}

TEST(LeanAway, LeansRightFromTheLeft) {
  expect_angles(spine_angles(lean_away(Pose(), -kY, 1, {1, 0}), kX), {15, 10, 25, 50});
}

TEST(LeanAway, ScalesWithTheControl) {
  expect_angles(spine_angles(lean_away(Pose(), -kX, 0.4F, {1, 0}), kY), {-6, -4, -10, -20});
}

TEST(LeanAway, ReversesThePelvisForAPelvisThreat) {
  expect_angles(spine_angles(lean_away(Pose(), -kX, 1, {0, 1}), kY), {15, 0, 0, 0});
}

TEST(LeanAway, InterpolatesBetweenHeadAndPelvis) {
  expect_angles(spine_angles(lean_away(Pose(), -kX, 1, {0.75F, 0.25F}), kY),
                {-7.5F, -7.5F, -18.75F, -37.5F});
}

// For a threat from the left, a quarter turn brings the back to it: after 65 degrees of the neck,
// 25 remain, of which the back's share is 12.5 but its maximum 8, the waist's 7.5 and the pelvis'
// 5.
TEST(TurnAway, SplitsTheRemainderOverBackWaistAndPelvis) {
  expect_angles(spine_angles(turn_away(Pose(), radians(90), 1), kZ), {-5, -7.5F, -8, -65});
  expect_angles(spine_angles(turn_away(Pose(), radians(-90), 1), kZ), {5, 7.5F, 8, 65});
}

TEST(TurnAway, ReachesAllMaximaForAFrontalThreat) {
  expect_angles(spine_angles(turn_away(Pose(), 0, 1), kZ), {-20, -12, -8, -65});
}

TEST(TurnAway, TurnsOnlyTheNeckForAThreatFromBehind) {
  expect_angles(spine_angles(turn_away(Pose(), radians(140), 1), kZ), {0, 0, 0, -40});
  expect_angles(spine_angles(turn_away(Pose(), radians(180), 1), kZ), {0, 0, 0, 0});
}

TEST(TurnAway, ScalesAllAnglesByTheControl) {
  expect_angles(spine_angles(turn_away(Pose(), radians(90), 0.5F), kZ),
                {-2.5F, -3.75F, -4, -32.5F});
}

TEST(Recoil, RaisesBothClaviclesAlikeByTheMaxima) {
  const Pose pose = recoil(Pose(), 1);
  const Eigen::Quaternionf expected =
      rotation_about(kX, radians(35)) * rotation_about(kY, radians(-25));
  EXPECT_LT(pose.rotation[Role::left_clavicle].angularDistance(expected), 1e-3);
  EXPECT_LT(pose.rotation[Role::right_clavicle].angularDistance(motion::mirrored(expected)), 1e-3);
}

TEST(TargetWeights, FollowEquation34) {
  const TargetWeights weights = target_weights(0.3F, 0.5F);
  EXPECT_NEAR(weights.head, 0.625F, 1e-6);
  EXPECT_NEAR(weights.pelvis, 0.375F, 1e-6);
}

Eigen::Vector3f palm_of(const motion::Figure& figure, const JointFrames& frames, Side side) {
  const Role hand = motion::roles_of(arm_of(side)).end;
  return frames.position[hand] + frames.orientation[hand] * (0.5F * figure.skeleton().tip[hand]);
}

TEST(Block, PutsBothPalmsBesideTheLineAtTheirReach) {
  const AuthorScene scene;
  const AimedThreat threat = scene.threat(Target::head, 10);
  RuleControls controls;
  controls.reach = {0.7F, 0.7F};
  controls.swivel = {0.5F, 0.5F};
  ThreatGeometry geometry = threat_geometry(scene.figure, scene.start, threat);
  geometry.weights = {1, 0};
  Pose pose = scene.start;
  block(scene.figure, scene.frames, geometry, controls, pose);
  const JointFrames frames = motion::forward_kinematics(scene.figure.skeleton(), pose);

  const float arm = 0.98F * limb_length(scene.figure.skeleton(), motion::Limb::left_arm);
  const float hand = scene.figure.skeleton().tip[Role::left_hand].norm();
  const float farthest = std::min(0.9F, arm + 0.25F * hand);
  const float reach = farthest + 0.7F * (0.3F - farthest);
  for (Side side : motion::kSides) {
    const Eigen::Vector3f palm = palm_of(scene.figure, frames, side);
    const Eigen::Vector3f from_target = palm - threat.target_point;
    const float along = from_target.dot(geometry.to_threat);
    EXPECT_GT(along, 0.1F);
    EXPECT_NEAR((from_target - along * geometry.to_threat).norm(), 0.25F * hand, 0.01F);
    const Role shoulder = side == Side::left ? Role::left_upper_arm : Role::right_upper_arm;
    EXPECT_NEAR((palm - frames.position[shoulder]).norm(), reach, 0.01F);
  }
}

TEST(Block, ReachesFartherForSmallThreats) {
  const AuthorScene scene;
  const AimedThreat threat = scene.threat(Target::head, 0);
  const ThreatGeometry geometry = threat_geometry(scene.figure, scene.start, threat);
  std::array<float, 2> distance{};
  for (std::size_t large = 0; large < 2; ++large) {
    RuleControls controls;
    controls.reach = {static_cast<float>(large), static_cast<float>(large)};
    Pose pose = scene.start;
    block(scene.figure, scene.frames, geometry, controls, pose);
    const JointFrames frames = motion::forward_kinematics(scene.figure.skeleton(), pose);
    distance[large] =
        (palm_of(scene.figure, frames, Side::left) - frames.position[Role::left_upper_arm]).norm();
  }
  EXPECT_GT(distance[0], distance[1] + 0.1F);
}

TEST(Block, PutsHandsBehindTheHeadForAThreatFromBehind) {
  const AuthorScene scene;
  const ThreatGeometry geometry =
      threat_geometry(scene.figure, scene.start, scene.threat(Target::head, 180));
  Pose pose = scene.start;
  block(scene.figure, scene.frames, geometry, {}, pose);
  const JointFrames frames = motion::forward_kinematics(scene.figure.skeleton(), pose);
  for (Side side : motion::kSides) {
    const Eigen::Vector3f palm = palm_of(scene.figure, frames, side);
    EXPECT_LT(palm.x(), frames.position[Role::head].x() - 0.05F);
    EXPECT_NEAR(palm.z(), frames.position[Role::head].z(), 0.12F);
  }
}

TEST(ApplyRules, KeepsFeetInPlaceAndNeckAndArmsWithinHumanLimits) {
  const AuthorScene scene;
  const motion::PerSide<motion::FootPose> feet{foot_pose(scene.frames, Side::left),
                                               foot_pose(scene.frames, Side::right)};
  for (float azimuth = -180; azimuth < 180; azimuth += 15) {
    for (Target target : {Target::head, Target::trunk, Target::pelvis}) {
      const AimedThreat threat = scene.threat(target, azimuth, 1);
      const RuleControls controls{1, 1, 1, {0.8F, 0.8F}, {0.3F, 0.3F}};
      const Pose pose =
          apply_rules(scene.figure, scene.start, threat_geometry(scene.figure, scene.start, threat),
                      controls, feet);
      ASSERT_TRUE(test::is_finite(pose));
      const JointFrames frames = motion::forward_kinematics(scene.figure.skeleton(), pose);
      for (Side side : motion::kSides) {
        EXPECT_LT((foot_pose(frames, side).ankle - feet[side].ankle).norm(), 1e-3F);
      }
      for (std::string_view name : {"neck", "trunk", "left_shoulder", "right_shoulder",
                                    "left_wrist", "right_wrist", "left_clavicle"}) {
        const JointLimits& limits = joint_limits_named(name);
        EXPECT_LT(limit_excess(limits, relative_rotation(frames, limits.from, limits.to)),
                  radians(0.1F))
            << name << " at azimuth " << azimuth;
      }
    }
  }
}

// A fifth of the way: elbows from 18 degrees towards 150; the head turns 0.4 of 50 degrees.
TEST(Startle, BlendsTwentyPercentAndTurnsTheHeadTowardTheThreat) {
  const AuthorScene scene;
  const Pose pose = startle(scene.figure, scene.start, scene.threat(Target::head, 50));
  EXPECT_NEAR(angle_about(pose.rotation[Role::left_forearm], -kZ), 18 + 0.2F * (150 - 18), 0.1);
  const JointFrames frames = motion::forward_kinematics(scene.figure.skeleton(), pose);
  const Eigen::Vector3f forward = frames.orientation[Role::head] * kX;
  EXPECT_NEAR(degrees(std::atan2(forward.y(), forward.x())), 20, 0.5);
}

TEST(CheckThreat, RefusesInvalidThreats) {
  const AuthorScene scene;
  const AimedThreat good = scene.threat(Target::head, 30);
  EXPECT_NO_THROW(check_threat(scene.figure, scene.start, good));
  AimedThreat still = good;
  still.threat.velocity.setZero();
  EXPECT_THROW(check_threat(scene.figure, scene.start, still), Error);
  AimedThreat nan = good;
  nan.threat.position.x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(check_threat(scene.figure, scene.start, nan), Error);
  AimedThreat inside = good;
  inside.threat.position = inside.target_point + Eigen::Vector3f(0.05F, 0, 0);
  EXPECT_THROW(check_threat(scene.figure, scene.start, inside), Error);
}

}  // namespace
}  // namespace flinch::database
