// SPDX-License-Identifier: MIT
// Responses that begin while others play: joints stay within their limits, feet above the ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
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

/// The joint that exceeds its limits most, and by how much, radians.
std::pair<float, std::string_view> max_excess(const motion::JointFrames& frames) {
  std::pair<float, std::string_view> max;
  for (const motion::JointLimits& limits : motion::human_joint_limits()) {
    const Eigen::Quaternionf rotation = motion::relative_rotation(frames, limits.from, limits.to);
    max = std::max(max, {limit_excess(limits, rotation), limits.name});
  }
  return max;
}

float min_sole_height(const Library& library, const motion::JointFrames& frames) {
  const motion::PerSide<Sole>& soles = library.prepared().soles;
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

/// What a character that is interrupted again and again did at worst.
struct Worst {
  float excess = 0;  // of a joint beyond its limits, radians
  std::string where;
  float depth_m = 0;        // of a sole under the ground
  float velocity_step = 0;  // of a joint, from one frame to the next, rad/s
};

/// Interrupts a character every 0.1 to 0.6 s for `frame_count` frames: `interrupt` gives it
/// something else to do.
template <class Interrupt>
Worst interrupted(const Library& library, std::mt19937& random, int frame_count,
                  Interrupt interrupt) {
  Character character(library);
  Worst worst;
  motion::Pose before = character.pose();
  motion::Pose now = before;
  int frames_left = frame_count;
  while (frames_left > 0) {
    interrupt(character);
    const int length = static_cast<int>(uniform(random, 0.1F, 0.6F) / kFrame_s);
    for (int i = 0; i < length; ++i, --frames_left) {
      if (character.update(kFrame_s) != Status::ok) worst.excess = 10;
      const motion::Pose pose = character.pose();
      const motion::JointFrames frames = forward_kinematics(library.prepared().skeleton(), pose);
      const auto [excess, joint] = max_excess(frames);
      const float depth_m = -min_sole_height(library, frames);
      if (excess > worst.excess || depth_m > worst.depth_m)
        worst.where += std::string(joint) + " in clip " + std::to_string(character.clip()) + "; ";
      worst.excess = std::max(worst.excess, excess);
      worst.depth_m = std::max(worst.depth_m, depth_m);
      worst.velocity_step = std::max(worst.velocity_step, max_velocity_step(before, now, pose));
      before = now;
      now = pose;
    }
  }
  return worst;
}

void expect_human(const Worst& worst) {
  EXPECT_LE(worst.excess, 0.05F) << worst.where;
  EXPECT_LE(worst.depth_m, 0.006F) << worst.where;
  EXPECT_LT(worst.velocity_step, 65);
}

// A ball every 0.1 to 0.6 s, for half an hour each: hardly any response is ever finished. Selectors
// that were fitted to other observations choose other clips one after the other.
TEST(Interruption, BallsLeaveJointsWithinTheirLimitsAndFeetAboveTheGround) {
  for (const std::uint64_t seed : {1U, 3U, 4U}) {
    SCOPED_TRACE("selector " + std::to_string(seed));
    const Library library = tests::loaded_selector(60, tests::ModelKind::knn, seed);
    Workspace workspace;
    ASSERT_EQ(workspace.reserve_memory(library.selection_bytes()), database::LoadStatus::ok);
    std::mt19937 random(3);
    int answered = 0;
    expect_human(interrupted(library, random, samples(100000), [&](Character& character) {
      const features::Threat ball = random_ball(random, character.state().position);
      answered += character.perceive(ball, workspace) == Status::ok ? 1 : 0;
    }));
    EXPECT_GT(answered, samples(3000));
  }
}

// Any clip after any other, as a game that chooses by itself may ask.
TEST(Interruption, AnyClipLeavesJointsWithinTheirLimitsAndFeetAboveTheGround) {
  const Library library = tests::loaded_selector(60, tests::ModelKind::knn);
  const std::vector<motion::Clip>& clips = library.clip_library().clips;
  std::mt19937 random(3);
  int answered = 0;
  expect_human(interrupted(library, random, samples(200000), [&](Character& character) {
    const auto clip = static_cast<int>(random() % clips.size());
    const float left_s = uniform(random, 0.25F, 1.2F);
    answered += character.respond(clip, left_s) == Status::ok ? 1 : 0;
  }));
  EXPECT_GT(answered, samples(9000));
}

}  // namespace
}  // namespace flinch::runtime
