// SPDX-License-Identifier: MIT
#include "runtime/character.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "motion/rotation.h"
#include "runtime/response/prepared_library.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/loaded_selector.h"
#include "tests/scenes/allocation_count.h"
#include "tests/scenes/not_finite.h"
#include "tests/scenes/walk.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;
using motion::Target;
using tests::distance;
using tests::kInfinity;
using tests::kNan;

const Library& library() {
  static const Library kLibrary = tests::loaded_selector(400, tests::ModelKind::knn);
  return kLibrary;
}

Workspace make_workspace() {
  Workspace workspace;
  workspace.reserve_memory(library().selection_bytes());
  return workspace;
}

// A ball that will hit the middle of a target of a character at the origin that faces +X.
features::Threat threat_to(Target target, float azimuth_deg, float time_s) {
  const PreparedLibrary& prepared = library().prepared();
  const motion::JointFrames frames =
      motion::forward_kinematics(prepared.skeleton(), prepared.idle().poses.front());
  features::ThreatDescription approach;
  approach.azimuth = motion::radians(azimuth_deg);
  approach.elevation = motion::radians(10);
  approach.speed_mps = 20;
  approach.time_to_impact_s = time_s;
  return features::threat_from_description(
      approach, motion::target_centre(prepared.body_model, frames, target), 0);
}

int clip_named(std::string_view name) {
  const auto& clips = library().clip_library().clips;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (clips[i].name == name) return static_cast<int>(i);
  }
  ADD_FAILURE() << "no clip " << name;
  return 0;
}

TEST(Character, PredictsTargetAndTimeToImpact) {
  Workspace workspace = make_workspace();
  for (Target target : {Target::head, Target::trunk, Target::pelvis}) {
    for (float azimuth : {0.0F, 80.0F, -130.0F}) {
      Character told(library());
      Character predicting(library());
      const features::Threat threat = threat_to(target, azimuth, 0.6F);
      ASSERT_EQ(told.perceive(threat, target, 0.6F, workspace), Status::ok);
      ASSERT_EQ(predicting.perceive(threat, workspace), Status::ok);
      EXPECT_EQ(predicting.target(), target);
      EXPECT_NEAR(predicting.time_to_impact_s(), 0.6F, 0.02F);
      EXPECT_FALSE(predicting.candidates().empty());
      EXPECT_EQ(predicting.clip(), predicting.candidates().front().clip);
    }
  }
}

TEST(Character, PredictsWhereACharacterWalksThatTheGameAnimates) {
  Workspace workspace = make_workspace();
  const motion::Motion walk =
      tests::walking(motion::make_figure(library().clip_library().character));
  const motion::Loop loop = motion::Loop::in_cycles(walk);
  for (const float after_s : {0.7F, 1.0F, 1.3F}) {
    Character character(library());
    for (float t = 0; t <= after_s; t += 1.0F / 60) {
      ASSERT_EQ(character.set_pose(sample(loop, t - 1.0F / 60), sample(loop, t), 1.0F / 60),
                Status::ok);
    }
    const Eigen::Vector3f led = sample(loop, after_s + 0.8F).root_position -
                                library().prepared().idle().poses.front().root_position;
    for (Target target : {Target::head, Target::trunk, Target::legs}) {
      features::Threat threat = threat_to(target, 90, 0.8F);
      threat.position.head<2>() += led.head<2>();
      ASSERT_EQ(character.perceive(threat, workspace), Status::ok) << after_s;
      EXPECT_EQ(character.target(), target) << after_s;
      EXPECT_NEAR(character.time_to_impact_s(), 0.8F, 0.05F);
      for (float t = after_s - 0.5F; t <= after_s; t += 1.0F / 60)
        character.set_pose(sample(loop, t - 1.0F / 60), sample(loop, t), 1.0F / 60);
    }
  }
}

TEST(Character, BracesWithoutASelector) {
  Library clips;
  ASSERT_EQ(clips.take(database::authored_library(motion::default_character())),
            database::LoadStatus::ok);
  Character character(clips);
  Workspace workspace = make_workspace();
  const features::Threat threat = threat_to(Target::head, 20, 0.6F);
  EXPECT_EQ(character.perceive(threat, workspace), Status::not_loaded);
  ASSERT_EQ(character.brace(threat), Status::ok);
  EXPECT_EQ(character.target(), Target::head);
  EXPECT_EQ(character.clip(), kNoClip);
  bool moved = false;
  for (int frame = 0; frame < 300; ++frame) {
    ASSERT_EQ(character.update(1.0F / 60), Status::ok);
    moved = moved || character.phase() == Phase::blending;
  }
  EXPECT_TRUE(moved);
  EXPECT_EQ(character.phase(), Phase::idle);
}

TEST(Character, DoesNotAnswerAMiss) {
  Workspace workspace = make_workspace();
  Character character(library());
  features::Threat threat = threat_to(Target::head, 0, 0.6F);
  threat.position.y() += 2;
  EXPECT_EQ(character.perceive(threat, workspace), Status::misses);
  EXPECT_EQ(character.phase(), Phase::idle);
  threat.velocity *= -1;
  EXPECT_EQ(character.perceive(threat, workspace), Status::misses);
  EXPECT_EQ(character.clip(), library().clip_library().idle);
}

TEST(Character, MotionMatchesTheTrainersBitForBit) {
  for (std::string_view name : {"duck_head_front_exaggerated", "sidestep_trunk_left_exaggerated"}) {
    Character character(library());
    ASSERT_EQ(character.place({1, 2}, 0.7F, 0.4F), Status::ok);
    ASSERT_EQ(character.respond(clip_named(name), 0.6F), Status::ok);
    const Response response =
        make_response(library().prepared(), {0.4F, {1, 2}, 0.7F}, clip_named(name), 0.6F);
    for (int frame = 1; frame < 90; ++frame) {
      ASSERT_EQ(character.update(1.0F / 64), Status::ok);
      const Pose expected = pose_at(response, static_cast<float>(frame) / 64);
      EXPECT_EQ(distance(character.pose(), expected), 0) << frame;
    }
  }
}

// At 24, 60, 144 and varying frames per second.
TEST(Character, MotionDoesNotDependOnTheFrameRate) {
  std::mt19937 random(4);
  const auto pose_after_a_second = [&](auto next_dt) {
    Workspace workspace = make_workspace();
    Character character(library());
    character.perceive(threat_to(Target::trunk, 30, 0.55F), Target::trunk, 0.55F, workspace);
    float left_s = 1;
    while (left_s > 1e-7F) {
      const float dt = std::min(left_s, next_dt());
      character.update(dt);
      left_s -= dt;
    }
    return motion::forward_kinematics(library().prepared().skeleton(), character.pose());
  };
  const motion::JointFrames at_60 = pose_after_a_second([] { return 1.0F / 60; });
  const auto expect_same = [&](const motion::JointFrames& frames) {
    for (Role role : motion::kRoles) {
      EXPECT_LT((frames.position[role] - at_60.position[role]).norm(), 1e-3F);
    }
  };
  expect_same(pose_after_a_second([] { return 1.0F / 24; }));
  expect_same(pose_after_a_second([] { return 1.0F / 144; }));
  expect_same(pose_after_a_second([&] { return tests::uniform(random, 0.001F, 0.07F); }));
}

TEST(Character, PassesThroughAllPhasesAndIdlesWhereItEndedUp) {
  Character character(library());
  ASSERT_EQ(character.respond(clip_named("sidestep_trunk_front_exaggerated"), 1.2F), Status::ok);
  EXPECT_EQ(character.phase(), Phase::waiting);
  std::vector<Phase> phases{character.phase()};
  while (character.phase() != Phase::idle) {
    ASSERT_EQ(character.update(0.01F), Status::ok);
    if (character.phase() != phases.back()) phases.push_back(character.phase());
    ASSERT_LT(phases.size(), 20U);
  }
  EXPECT_EQ(phases, (std::vector<Phase>{Phase::waiting, Phase::shifting, Phase::blending,
                                        Phase::protecting, Phase::returning, Phase::idle}));
  const Pose before = character.pose();
  ASSERT_EQ(character.update(1e-3F), Status::ok);
  EXPECT_LT(distance(character.pose(), before), 5e-3F);
}

TEST(Character, ANewThreatContinuesFromTheCurrentPoseAndVelocity) {
  constexpr float kStep_s = 1e-3F;
  Workspace workspace = make_workspace();
  for (float at_s : {0.3F, 0.45F, 0.6F, 0.9F}) {
    Character character(library());
    ASSERT_EQ(character.respond(clip_named("duck_head_front_exaggerated"), 0.6F), Status::ok);
    character.update(at_s - kStep_s);
    const Pose before = character.pose();
    character.update(kStep_s);
    const Pose now = character.pose();
    ASSERT_EQ(
        character.perceive(threat_to(Target::trunk, -60, 0.5F), Target::trunk, 0.5F, workspace),
        Status::ok);
    EXPECT_LT(distance(character.pose(), now), 2e-3F) << at_s;
    character.update(kStep_s);
    const Pose after = character.pose();
    for (Role role : {Role::pelvis, Role::chest, Role::head, Role::left_upper_arm}) {
      const auto velocity = [&](const Pose& a, const Pose& b) {
        return Eigen::Vector3f(
            motion::rotation_vector(b.rotation[role] * a.rotation[role].conjugate()) / kStep_s);
      };
      EXPECT_LT((velocity(now, after) - velocity(before, now)).norm(), 1.0F)
          << motion::name_of(role) << " at " << at_s;
    }
  }
}

// A boxer's guard, stepping forward at 1 m/s: neither an idle pose nor at rest.
TEST(Character, RespondsFromAPoseSetByTheGame) {
  constexpr float kFrame_s = 1.0F / 60;
  Workspace workspace = make_workspace();
  Pose now = library().prepared().idle().poses.front();
  now = motion::placed(now, 1.1F, {3, -2, 0});
  for (Role arm : {Role::left_forearm, Role::right_forearm}) {
    now.rotation[arm] =
        now.rotation[arm] *
        motion::rotation_about(Eigen::Vector3f::UnitZ(), arm == Role::left_forearm ? -1.4F : 1.4F);
  }
  Pose before = now;
  before.root_position -= kFrame_s * Eigen::Vector3f(std::cos(1.1F), std::sin(1.1F), 0);
  Character character(library());
  ASSERT_EQ(character.set_pose(before, now, kFrame_s), Status::ok);
  features::Threat threat = threat_to(Target::head, 0, 0.5F);
  const Eigen::Quaternionf turn = motion::rotation_about(Eigen::Vector3f::UnitZ(), 1.1F);
  threat.position = turn * threat.position + Eigen::Vector3f(3, -2, 0);
  threat.velocity = turn * threat.velocity;
  ASSERT_EQ(character.perceive(threat, workspace), Status::ok);
  EXPECT_LT(distance(character.pose(), now), 2e-3F);
  character.update(1e-3F);
  const Eigen::Vector3f gone = character.pose().root_position - now.root_position;
  EXPECT_LT((gone / 1e-3F - (now.root_position - before.root_position) / kFrame_s).norm(), 0.2F);
  // Standing feet stay in place until a step.
  const auto feet = [&](const Pose& pose) {
    return motion::foot_pose(motion::forward_kinematics(library().prepared().skeleton(), pose),
                             character.response().support);
  };
  EXPECT_LT((feet(character.pose()).ankle - feet(now).ankle).norm(), 1e-3F);
}

TEST(Character, SettlesBackToIdle) {
  Character character(library());
  ASSERT_EQ(character.respond(clip_named("duck_head_front_exaggerated"), 0.6F), Status::ok);
  character.update(0.6F);
  ASSERT_EQ(character.settle(), Status::ok);
  EXPECT_EQ(character.phase(), Phase::returning);
  for (int i = 0; i < 200; ++i) character.update(0.01F);
  EXPECT_EQ(character.phase(), Phase::idle);
  EXPECT_EQ(character.time_to_impact_s(), kInfinity);
}

TEST(Character, MaskKeepsTheGamesJoints) {
  Character character(library());
  ASSERT_EQ(character.respond(clip_named("block_head_front_mild"), 0.5F), Status::ok);
  character.update(0.5F);
  const Pose game = library().prepared().idle().poses.front();
  Mask mask;
  for (Role role :
       {Role::right_clavicle, Role::right_upper_arm, Role::right_forearm, Role::right_hand}) {
    mask.joint[role] = 0;
  }
  const Pose masked = character.pose_over(game, mask);
  const Pose whole = character.pose();
  EXPECT_LT(
      masked.rotation[Role::right_forearm].angularDistance(game.rotation[Role::right_forearm]),
      1e-3F);
  EXPECT_LT(masked.rotation[Role::left_forearm].angularDistance(whole.rotation[Role::left_forearm]),
            1e-3F);
  EXPECT_GT(whole.rotation[Role::right_forearm].angularDistance(game.rotation[Role::right_forearm]),
            0.3F);
  mask.weight = 0;
  EXPECT_LT(distance(character.pose_over(game, mask), game), 1e-3F);
  mask.weight = kNan;
  EXPECT_LT(distance(character.pose_over(game, mask), game), 1e-3F);
}

TEST(Character, RespondsAfterItsReactionDelayAndNotToFasterThreats) {
  Workspace workspace = make_workspace();
  PerceptionLimits limits;
  limits.reaction_delay_s = 0.2F;
  Character character(library());
  character.limit_perception(limits, 1);
  ASSERT_EQ(character.perceive(threat_to(Target::head, 0, 0.7F), Target::head, 0.7F, workspace),
            Status::ok);
  EXPECT_EQ(character.phase(), Phase::reacting);
  character.update(0.15F);
  EXPECT_EQ(character.phase(), Phase::reacting);
  character.update(0.1F);
  EXPECT_NE(character.phase(), Phase::reacting);
  EXPECT_NE(character.phase(), Phase::idle);
  EXPECT_NEAR(character.time_to_impact_s(), 0.45F, 1e-4F);

  Character late(library());
  late.limit_perception(limits, 1);
  ASSERT_EQ(late.perceive(threat_to(Target::head, 0, 0.15F), Target::head, 0.15F, workspace),
            Status::ok);
  late.update(0.3F);
  EXPECT_EQ(late.phase(), Phase::idle);
}

TEST(Character, FailuresToNoticeFollowFromTheSeed) {
  Workspace workspace = make_workspace();
  PerceptionLimits limits;
  limits.chance_to_fail = 0.5F;
  const auto outcomes = [&](std::uint64_t seed) {
    Character character(library());
    character.limit_perception(limits, seed);
    std::vector<Status> seen;
    for (int i = 0; i < 40; ++i) {
      character.place({0, 0}, 0, 0);
      seen.push_back(character.perceive(threat_to(Target::head, 0, 0.5F), workspace));
    }
    return seen;
  };
  const std::vector<Status> first = outcomes(1);
  EXPECT_EQ(first, outcomes(1));
  EXPECT_NE(first, outcomes(2));
  const auto failed = std::ranges::count(first, Status::unnoticed);
  EXPECT_GT(failed, 8);
  EXPECT_LT(failed, 32);
}

std::vector<std::byte> bytes_of(const Character& character) {
  const std::span<const Character, 1> one(&character, 1);
  const auto bytes = std::as_bytes(one);
  return {bytes.begin(), bytes.end()};
}

// Between two answers of a character that perceives with noise, whose next draws count too.
TEST(Character, ARefusedCallChangesNoBit) {
  Workspace workspace = make_workspace();
  Workspace none;
  const features::Threat good = threat_to(Target::head, 0, 0.5F);
  Character character(library());
  character.limit_perception(human_limits(), 3);
  while (character.perceive(good, workspace) != Status::ok)
    ASSERT_EQ(character.settle(), Status::ok);
  character.update(0.1F);
  const Pose pose = character.pose();
  const std::vector<std::byte> before = bytes_of(character);
  const auto expect_refused = [&](Status expected, Status status) {
    EXPECT_EQ(status, expected) << message_of(expected);
    EXPECT_EQ(bytes_of(character), before) << message_of(expected);
  };
  for (float bad : {kNan, kInfinity, -kInfinity, 2e6F, -2e6F}) {
    for (int i = 0; i < 8; ++i) {
      features::Threat threat = good;
      (i < 3   ? threat.position[i]
       : i < 6 ? threat.velocity[i - 3]
       : i < 7 ? threat.radius
               : threat.mass_kg) = bad;
      expect_refused(Status::bad_threat, character.perceive(threat, workspace));
      expect_refused(Status::bad_threat, character.perceive(threat, Target::legs, 0.5F, workspace));
    }
    expect_refused(Status::bad_threat, character.perceive(good, Target::legs, bad, workspace));
    expect_refused(Status::bad_threat, character.respond(1, bad));
    expect_refused(Status::bad_time, character.update(bad));
    expect_refused(Status::bad_time, character.set_pose(pose, pose, bad));
    expect_refused(Status::bad_placement, character.place({0, bad}, 0, 0));
    Pose away = pose;
    away.root_position.x() = bad;
    expect_refused(Status::bad_pose, character.set_pose(pose, away, 0.01F));
  }
  for (float far : {1.01e5F, -1.01e5F}) {
    expect_refused(Status::bad_placement, character.place({far, 0}, 0, 0));
    Pose away = pose;
    away.root_position.z() = far;
    expect_refused(Status::bad_pose, character.set_pose(away, pose, 0.01F));
  }
  expect_refused(Status::other_workspace, character.perceive(good, none));
  expect_refused(Status::other_workspace, character.perceive(good, Target::legs, 0.5F, none));
  expect_refused(Status::bad_clip, character.respond(-1, 0.5F));
}

TEST(Character, RejectsBadInputAndStaysUsable) {
  Workspace workspace = make_workspace();
  const features::Threat good = threat_to(Target::head, 0, 0.5F);
  Character character(library());
  for (float bad : {kNan, kInfinity, -kInfinity}) {
    features::Threat threat = good;
    threat.position.x() = bad;
    EXPECT_EQ(character.perceive(threat, workspace), Status::bad_threat);
    EXPECT_EQ(character.perceive(threat, Target::head, 0.5F, workspace), Status::bad_threat);
    threat = good;
    threat.velocity.z() = bad;
    EXPECT_EQ(character.perceive(threat, workspace), Status::bad_threat);
    EXPECT_EQ(character.perceive(good, Target::head, bad, workspace), Status::bad_threat);
    EXPECT_EQ(character.update(bad), Status::bad_time);
    EXPECT_EQ(character.place({bad, 0}, 0, 0), Status::bad_placement);
    EXPECT_EQ(character.respond(1, bad), Status::bad_threat);
    Pose pose = character.pose();
    pose.root_position.y() = bad;
    EXPECT_EQ(character.set_pose(pose, pose, 0.01F), Status::bad_pose);
    EXPECT_EQ(character.set_pose(character.pose(), character.pose(), bad), Status::bad_time);
  }
  EXPECT_EQ(character.update(0), Status::bad_time);
  EXPECT_EQ(character.update(-0.1F), Status::bad_time);
  EXPECT_EQ(character.perceive(good, Target::head, 0, workspace), Status::bad_threat);
  EXPECT_EQ(character.respond(-1, 0.5F), Status::bad_clip);
  EXPECT_EQ(character.respond(100000, 0.5F), Status::bad_clip);
  Pose stretched = character.pose();
  stretched.rotation[Role::head].coeffs() *= 2;
  EXPECT_EQ(character.set_pose(stretched, stretched, 0.01F), Status::bad_pose);
  Workspace none;
  EXPECT_EQ(character.perceive(good, none), Status::other_workspace);
  EXPECT_EQ(character.phase(), Phase::idle);
  EXPECT_EQ(character.perceive(good, workspace), Status::ok);
  EXPECT_EQ(character.update(0.1F), Status::ok);

  const Library empty;
  Character nobody(empty);
  EXPECT_EQ(nobody.perceive(good, workspace), Status::not_loaded);
  EXPECT_EQ(nobody.update(0.1F), Status::not_loaded);
  EXPECT_EQ(nobody.settle(), Status::not_loaded);
  EXPECT_EQ(distance(nobody.pose(), Pose()), 0);
}

TEST(Character, IsSmallAndAllocatesNothing) {
  EXPECT_LE(sizeof(Character), 16U * 1024);
  Workspace workspace = make_workspace();
  Character character(library());
  const features::Threat threat = threat_to(Target::trunk, 20, 0.5F);
  float sum = 0;
  const std::size_t before = tests::allocation_count();
  for (int round = 0; round < 5; ++round) {
    character.perceive(threat, workspace);
    for (int frame = 0; frame < 20; ++frame) {
      character.update(0.02F);
      sum += character.pose().root_position.x();
    }
  }
  EXPECT_EQ(tests::allocation_count(), before);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace flinch::runtime
