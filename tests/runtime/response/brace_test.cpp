// SPDX-License-Identifier: MIT
#include "runtime/response/brace.h"

#include <gtest/gtest.h>

#include <random>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "motion/rotation.h"
#include "runtime/response/prepared_library.h"
#include "tests/motion/random_motion.h"
#include "tests/scenes/allocation_count.h"
#include "tests/scenes/walk.h"

namespace flinch::runtime {
namespace {

using motion::Role;
using motion::Side;

const PreparedLibrary& bracing() {
  static const database::ClipLibrary clips =
      tests::with_walk(database::authored_library(motion::default_character()));
  static const PreparedLibrary library = prepare(clips);
  return library;
}

/// A ball at a target of a character in its stance, where it will be.
RuledThreat ball_at(motion::Target target, float azimuth_deg, const features::CharacterState& state,
                    float speed_mps = 26, float radius = 0.105F) {
  features::ThreatDescription description;
  description.azimuth = motion::radians(azimuth_deg);
  description.elevation = motion::radians(5);
  description.speed_mps = speed_mps;
  description.radius = radius;
  description.time_to_impact_s = 0.8F;
  RuledThreat threat;
  threat.time_to_impact_s = description.time_to_impact_s;
  threat.target_point =
      features::predict_character(bracing().figure_in(state), state, threat.time_to_impact_s)
          .target_centres[target];
  threat.threat = threat_from_description(description, threat.target_point, state.facing);
  return threat;
}

features::CharacterState in_stance(int stance) {
  features::CharacterState state;
  state.idle_time_s = 0.3F;
  state.facing = 0.7F;
  state.stance = stance;
  return state;
}

motion::JointFrames frames_at(const Response& r, float time_s) {
  return motion::forward_kinematics(bracing().skeleton(), pose_at(r, time_s));
}

Eigen::Vector3f palm_of(const motion::JointFrames& frames, Side side) {
  const Role hand = motion::roles_of(motion::arm_of(side)).end;
  return frames.position[hand] + frames.orientation[hand] * (0.5F * bracing().skeleton().tip[hand]);
}

float distance_to_line(const Eigen::Vector3f& point, const RuledThreat& threat) {
  const Eigen::Vector3f along = velocity_at(threat.threat, threat.time_to_impact_s).normalized();
  const Eigen::Vector3f offset = point - threat.target_point;
  return (offset - offset.dot(along) * along).norm();
}

TEST(Brace, HandsAreOnTheThreatsLineAtTheImpact) {
  for (const int stance : {0, 1, 2}) {
    for (const motion::Target target : {motion::Target::head, motion::Target::trunk}) {
      for (const float azimuth : {-30.0F, 0.0F, 30.0F}) {
        const features::CharacterState state = in_stance(stance);
        const RuledThreat threat = ball_at(target, azimuth, state);
        const Response r = make_brace(bracing(), state, threat);
        ASSERT_TRUE(is_valid(r));
        const motion::JointFrames frames = frames_at(r, threat.time_to_impact_s);
        for (const Side side : motion::kSides) {
          EXPECT_LT(distance_to_line(palm_of(frames, side), threat), 0.12F)
              << stance << ", " << motion::name_of(target) << " from " << azimuth;
        }
      }
    }
  }
}

TEST(Brace, TakesTheTimeOfEquation41) {
  const features::CharacterState state = in_stance(0);
  for (const float speed_mps : {20.0F, 25.0F, 29.0F, 40.0F}) {
    for (const float azimuth : {0.0F, 90.0F, 180.0F}) {
      const RuledThreat threat = ball_at(motion::Target::head, azimuth, state, speed_mps);
      const Response r = make_brace(bracing(), state, threat);
      const float share = std::clamp((speed_mps - 22.8F) / (29.7F - 22.8F), 0.0F, 1.0F);
      const float cosine = std::cos(motion::radians(azimuth)) * std::cos(motion::radians(5));
      const float needed_s = (0.25F + 0.75F * (1 - share)) * (1 + 0.2F * (1 - cosine));
      EXPECT_EQ(r.peak_s, threat.time_to_impact_s);
      EXPECT_NEAR(r.peak_s - r.begin_s, std::min(needed_s, threat.time_to_impact_s), 0.02F);
    }
  }
}

TEST(Brace, ALargeThreatIsMetNearerToTheBodyThanASmallOne) {
  const features::CharacterState state = in_stance(0);
  const auto reach_to = [&](float radius) {
    const RuledThreat threat = ball_at(motion::Target::head, 0, state, 26, radius);
    const motion::JointFrames frames =
        frames_at(make_brace(bracing(), state, threat), threat.time_to_impact_s);
    return (palm_of(frames, Side::left) - frames.position[Role::left_upper_arm]).norm();
  };
  EXPECT_GT(reach_to(0.04F), reach_to(0.19F) + 0.1F);
}

TEST(Brace, TheCentreOfMassGoesTowardTheThreat) {
  const motion::Figure figure = motion::make_figure(motion::default_character());
  const motion::Pose pose = bracing().idle().poses.front();
  const motion::JointFrames frames = motion::forward_kinematics(figure.skeleton(), pose);
  const motion::PerSide<motion::FootPose> feet{motion::foot_pose(frames, Side::left),
                                               motion::foot_pose(frames, Side::right)};
  for (const float azimuth : {0.0F, 60.0F, -120.0F}) {
    const RuledThreat threat = ball_at(motion::Target::head, azimuth, {});
    const database::AimedThreat aimed{threat.threat, threat.target_point};
    const database::RuleControls controls = database::rule_controls(aimed);
    const auto centre = [&](const motion::Pose& at) {
      return motion::centre_of_mass(figure.bodies,
                                    motion::forward_kinematics(figure.skeleton(), at));
    };
    const Eigen::Vector3f way =
        centre(braced_pose(figure, pose, aimed, controls, feet)) -
        centre(database::apply_rules(figure, pose, threat_geometry(figure, pose, aimed), controls,
                                     feet));
    const Eigen::Vector2f toward =
        (threat.threat.position - threat.target_point).head<2>().normalized();
    EXPECT_NEAR(way.head<2>().dot(toward), database::kBraceDistance, 5e-3F) << azimuth;
  }
}

TEST(Brace, StartlesFirstOnRequest) {
  const features::CharacterState state = in_stance(0);
  RuledThreat threat = ball_at(motion::Target::head, 20, state);
  const Response calm = make_brace(bracing(), state, threat);
  threat.startles = true;
  const Response startled = make_brace(bracing(), state, threat);
  const auto shrug = [](const Response& r, float time_s) {
    return pose_at(r, time_s).rotation[Role::left_clavicle].angularDistance(
        pose_at(r, 0).rotation[Role::left_clavicle]);
  };
  const float startled_s = startled.begin_s + database::kStartle;
  EXPECT_GT(shrug(startled, startled_s), shrug(calm, startled_s) + 0.03F);
  EXPECT_LT(tests::distance(pose_at(startled, startled.peak_s), pose_at(calm, calm.peak_s)), 1e-2F);
}

TEST(Brace, AWalkerWalksOnBeforeAndAfter) {
  const features::CharacterState state = in_stance(2);
  const Response r = make_brace(bracing(), state, ball_at(motion::Target::head, 0, state, 29.5F));
  ASSERT_TRUE(is_valid(r));
  EXPECT_GT(r.leave_s, 0.2F);
  const motion::Loop& walk = bracing().stance_of(state).loop;
  for (float t = 0; t < r.leave_s; t += 0.05F)
    EXPECT_LT(tests::distance(pose_at(r, t), features::idle_pose(walk, state, t)), 1e-5F);
  const float end_s = duration_s(r);
  const Eigen::Vector3f way =
      pose_at(r, end_s + 2.2F).root_position - pose_at(r, end_s + 1.1F).root_position;
  EXPECT_NEAR(way.norm(), 0.99F, 0.02F);
}

TEST(Brace, AllocatesNothingAndRefusesWhatStandsStill) {
  const features::CharacterState state = in_stance(0);
  RuledThreat threat = ball_at(motion::Target::head, 0, state);
  make_brace(bracing(), state, threat);
  const auto before = tests::allocation_count();
  EXPECT_TRUE(is_valid(make_brace(bracing(), state, threat)));
  EXPECT_EQ(tests::allocation_count(), before);
  threat.threat.velocity.setZero();
  threat.threat.falls = false;
  EXPECT_FALSE(is_valid(make_brace(bracing(), state, threat)));
}

}  // namespace
}  // namespace flinch::runtime
