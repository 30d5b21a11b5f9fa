// SPDX-License-Identifier: MIT
#include "database/author/protective_motion.h"

#include <gmock/gmock.h>

#include "author_scene.h"
#include "database/author/evasion.h"
#include "database/author/static_balance.h"
#include "database/quality/quality.h"

namespace flinch::database {
namespace {

using motion::JointFrames;
using motion::Pose;
using motion::Role;
using motion::Side;
using motion::Target;
using test::AuthorScene;

TEST(TimeToContact, FollowsEquation41) {
  EXPECT_NEAR(time_to_contact_s(0, 1), 1.0F, 1e-6);
  EXPECT_NEAR(time_to_contact_s(1, 1), 0.25F, 1e-6);
  EXPECT_NEAR(time_to_contact_s(1, -1), 0.35F, 1e-6);
  EXPECT_NEAR(time_to_contact_s(0.5F, 0), 0.75F, 1e-6);
  EXPECT_EQ(time_to_contact_s(2, 3), time_to_contact_s(1, 1));
}

Pose blocking_pose(const AuthorScene& scene) {
  const RuleControls controls{0.3F, 0.2F, 0.3F, {0.2F, 0.2F}, {0.5F, 0.5F}};
  return balanced_pose(scene.figure, scene.start, scene.threat(Target::trunk, 0), controls).pose;
}

float distance_to_line(const Eigen::Vector3f& from, const Eigen::Vector3f& to,
                       const Eigen::Vector3f& point) {
  const Eigen::Vector3f along = (to - from).normalized();
  const Eigen::Vector3f offset = point - from;
  return (offset - offset.dot(along) * along).norm();
}

TEST(Transition, FeetHandsNeckAndCentreOfMassFollowTheirPaths) {
  const AuthorScene scene;
  const Transition transition = make_transition(scene.figure, scene.start, blocking_pose(scene));
  ASSERT_TRUE(transition.support);
  ASSERT_FALSE(transition.hand_swings[Side::left] || transition.hand_swings[Side::right]);
  for (float s = 0; s <= 1; s += 0.05F) {
    const JointFrames frames =
        motion::forward_kinematics(scene.figure.skeleton(), pose_at(scene.figure, transition, s));
    for (Side side : motion::kSides) {
      EXPECT_LT((foot_pose(frames, side).ankle - foot_pose(scene.frames, side).ankle).norm(),
                5e-4F);
    }
    for (Role role : {Role::left_hand, Role::right_hand}) {
      EXPECT_LT(distance_to_line(transition.from_frames.position[role],
                                 transition.to_frames.position[role], frames.position[role]),
                2e-3F)
          << motion::name_of(role) << " at " << s;
    }
    EXPECT_LT(
        distance_to_line(transition.from_frames.position[Role::neck],
                         transition.to_frames.position[Role::neck], frames.position[Role::neck]),
        0.01F);
    Eigen::Vector3f centre = motion::centre_of_mass(scene.figure.bodies, frames);
    Eigen::Vector3f from = transition.from_centre;
    Eigen::Vector3f to = transition.to_centre;
    centre.z() = from.z() = to.z() = 0;
    EXPECT_LT(distance_to_line(from, to, centre), 3e-3F);
  }
}

TEST(Transition, StartsAndEndsAtItsPoses) {
  const AuthorScene scene;
  const Pose to = blocking_pose(scene);
  const Transition transition = make_transition(scene.figure, scene.start, to);
  for (const auto& [s, pose] : {std::pair{0.0F, scene.start}, {1.0F, to}}) {
    const JointFrames expected = motion::forward_kinematics(scene.figure.skeleton(), pose);
    const JointFrames found =
        motion::forward_kinematics(scene.figure.skeleton(), pose_at(scene.figure, transition, s));
    for (Role role : motion::kRoles) {
      EXPECT_LT((found.position[role] - expected.position[role]).norm(), 3e-3F)
          << motion::name_of(role) << " at " << s;
    }
  }
}

TEST(Transition, StepsWithOneFootAlwaysDown) {
  const AuthorScene scene;
  const Transition transition = make_transition(
      scene.figure, scene.start, evasive_pose(scene.figure, scene.start, sidestep(0, -1, 1)));
  EXPECT_TRUE(transition.steps[Side::left].moves && transition.steps[Side::right].moves);
  const float ground = foot_pose(scene.frames, Side::left).ankle.z();
  for (float s = 0; s <= 1; s += 0.02F) {
    const JointFrames frames =
        motion::forward_kinematics(scene.figure.skeleton(), pose_at(scene.figure, transition, s));
    const float left = foot_pose(frames, Side::left).ankle.z() - ground;
    const float right = foot_pose(frames, Side::right).ankle.z() - ground;
    EXPECT_LT(std::min(left, right), 1e-3F) << s;
    EXPECT_GT(std::min(left, right), -1e-3F) << s;
  }
}

TEST(ProtectiveMotion, ReachesHoldsAndReturnsOnTime) {
  const AuthorScene scene;
  const Pose sustained = blocking_pose(scene);
  ProtectiveTiming timing;
  timing.protect_s = 0.4F;
  const motion::Motion motion =
      protective_motion(scene.figure, scene.start, std::nullopt, sustained, timing, 60);
  EXPECT_NEAR(motion.duration_s(), 0.4 + 1.0 / 3 + 0.635, 1.0 / 60);
  const auto hand_at = [&](float time_s) {
    return motion::forward_kinematics(scene.figure.skeleton(), sample(motion, time_s))
        .position[Role::left_hand];
  };
  const Eigen::Vector3f goal =
      motion::forward_kinematics(scene.figure.skeleton(), sustained).position[Role::left_hand];
  EXPECT_LT((hand_at(0.4F) - goal).norm(), 3e-3F);
  EXPECT_LT((hand_at(0.72F) - goal).norm(), 3e-3F);
  EXPECT_LT((hand_at(10) - scene.frames.position[Role::left_hand]).norm(), 3e-3F);
}

TEST(ProtectiveMotion, PassesThroughTheStartleAfterAnEighthOfASecond) {
  const AuthorScene scene;
  const Pose startled = startle(scene.figure, scene.start, scene.threat(Target::head, 30));
  ProtectiveTiming timing;
  timing.protect_s = 0.5F;
  const motion::Motion motion =
      protective_motion(scene.figure, scene.start, startled, blocking_pose(scene), timing, 120);
  const JointFrames found =
      motion::forward_kinematics(scene.figure.skeleton(), sample(motion, 0.125F));
  const JointFrames expected = motion::forward_kinematics(scene.figure.skeleton(), startled);
  EXPECT_LT((found.position[Role::left_hand] - expected.position[Role::left_hand]).norm(), 5e-3F);
}

TEST(ProtectivePoses, StartFromTheMotionsLookAhead) {
  const AuthorScene scene;
  motion::Motion walk;  // forward at 1 m/s
  walk.rate_hz = 120;
  for (int k = 0; k < 60; ++k) {
    walk.poses.push_back(scene.start);
    walk.poses.back().root_position.x() += static_cast<float>(k) / 120;
  }
  const AimedThreat threat = scene.threat(Target::head, 0);
  const RuleControls controls{0.3F, 0.2F, 0.3F, {0.5F, 0.5F}, {0.5F, 0.5F}};
  const ProtectivePoses poses = protective_poses(scene.figure, walk, 0.1F, threat, controls, true);
  EXPECT_NEAR(poses.start.root_position.x(), walk.poses[12].root_position.x(), 1e-4F);
  ASSERT_TRUE(poses.startled);
  EXPECT_NEAR(poses.startled->root_position.x(), walk.poses[22].root_position.x(), 1e-4F);
  const Pose sustained = balanced_pose(scene.figure, walk.poses[32], threat, controls).pose;
  EXPECT_LT((poses.sustained.pose.root_position - sustained.root_position).norm(), 0.01F);
}

}  // namespace
}  // namespace flinch::database
