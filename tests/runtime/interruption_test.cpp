// SPDX-License-Identifier: MIT
// Responses that begin while others play: joints stay within their limits, feet above the ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string_view>
#include <utility>

#include "motion/figure.h"
#include "motion/joint_limits.h"
#include "motion/rotation.h"
#include "runtime/character.h"
#include "runtime/response/prepared_library.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/loaded_selector.h"
#include "tests/scenes/sample_count.h"

namespace flinch::runtime {
namespace {

using tests::samples;
using tests::uniform;

constexpr float kFrame_s = 1.0F / 60;

const Library& authored_selector() {
  static const Library kLibrary = tests::loaded_selector(60, tests::ModelKind::knn);
  return kLibrary;
}

/// The joint that exceeds its limits most, and by how much, radians.
std::pair<float, std::string_view> max_excess(const motion::JointFrames& frames) {
  std::pair<float, std::string_view> max;
  for (const motion::JointLimits& limits : motion::human_joint_limits()) {
    const Eigen::Quaternionf rotation = motion::relative_rotation(frames, limits.from, limits.to);
    max = std::max(max, {limit_excess(limits, rotation), limits.name});
  }
  return max;
}

float min_sole_height(const motion::JointFrames& frames) {
  const motion::PerSide<Sole>& soles = authored_selector().prepared().soles;
  return std::min(min_height(soles[motion::Side::left], frames, motion::Side::left),
                  min_height(soles[motion::Side::right], frames, motion::Side::right));
}

/// The largest change of a joint's velocity over three poses, one frame apart, rad/s.
float max_velocity_step(const motion::Pose& first, const motion::Pose& second,
                        const motion::Pose& third) {
  float max = 0;
  for (motion::Role role : motion::kRoles) {
    const auto turn = [role](const motion::Pose& from, const motion::Pose& to) {
      return motion::rotation_vector(to.rotation[role] * from.rotation[role].conjugate());
    };
    max = std::max(max, (turn(second, third) - turn(first, second)).norm() / kFrame_s);
  }
  return max;
}

/// A ball that hits a character at `position` somewhere between shin and head, from any side.
features::Threat random_ball(std::mt19937& random, const Eigen::Vector2f& position) {
  features::ThreatDescription approach;
  approach.azimuth = uniform(random, -3.1F, 3.1F);
  approach.elevation = uniform(random, 0.1F, 0.5F);
  approach.speed_mps = uniform(random, 8, 30);
  approach.time_to_impact_s = uniform(random, 0.25F, 1.2F);
  const Eigen::Vector3f goal(position.x(), position.y(), uniform(random, 0.3F, 1.7F));
  return features::threat_from_description(approach, goal, 0);
}

// A ball every 0.1 to 0.6 s, for half an hour: hardly any response is ever finished.
TEST(Interruption, JointsStayWithinTheirLimitsAndFeetAboveTheGround) {
  const motion::Skeleton& skeleton = authored_selector().prepared().skeleton();
  Workspace workspace;
  ASSERT_EQ(workspace.reserve_memory(authored_selector().selection_bytes()),
            database::LoadStatus::ok);
  std::mt19937 random(3);
  Character character(authored_selector());
  motion::Pose before = character.pose();
  motion::Pose now = before;
  float max_step = 0;
  int answered = 0;
  int frames_left = samples(100000);
  while (frames_left > 0) {
    const features::Threat ball = random_ball(random, character.state().position);
    answered += character.perceive(ball, workspace) == Status::ok ? 1 : 0;
    const int length = static_cast<int>(uniform(random, 0.1F, 0.6F) / kFrame_s);
    for (int i = 0; i < length; ++i, --frames_left) {
      ASSERT_EQ(character.update(kFrame_s), Status::ok);
      const motion::Pose pose = character.pose();
      const motion::JointFrames frames = forward_kinematics(skeleton, pose);
      const auto [excess, joint] = max_excess(frames);
      EXPECT_LE(excess, 0.05F) << joint << " in clip " << character.clip() << ", frame " << i;
      EXPECT_GE(min_sole_height(frames), -0.015F) << "clip " << character.clip() << ", frame " << i;
      max_step = std::max(max_step, max_velocity_step(before, now, pose));
      before = now;
      now = pose;
    }
  }
  EXPECT_LT(max_step, 60);
  EXPECT_GT(answered, samples(3000));
}

}  // namespace
}  // namespace flinch::runtime
