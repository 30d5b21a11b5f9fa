// SPDX-License-Identifier: MIT
// Responses of characters that walk or stand on guard.
#include <gtest/gtest.h>

#include <random>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "motion/rotation.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/response/foot_slide.h"
#include "tests/scenes/walk.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;
using motion::Side;

constexpr int kGuard = 1;
constexpr int kWalk = 2;
constexpr float kFrame_s = 1.0F / 60;

const database::ClipLibrary& clips() {
  static const database::ClipLibrary library =
      tests::with_walk(database::authored_library(motion::default_character()));
  return library;
}

const PreparedLibrary& walkers() {
  static const PreparedLibrary library = prepare(clips());
  return library;
}

features::CharacterState random_state(std::mt19937& random, int stance) {
  return {tests::uniform(random, 0, 2),
          {tests::uniform(random, -1, 1), tests::uniform(random, -1, 1)},
          tests::uniform(random, -3, 3),
          stance};
}

Pose goes_on(const features::CharacterState& state, float time_s) {
  return features::idle_pose(walkers().stance_of(state).loop, state, time_s);
}

/// A response from this stance with a clip and a time to impact drawn at random.
Response random_response(std::mt19937& random, int stance) {
  for (;;) {
    const auto clip = static_cast<int>(random() % clips().clips.size());
    if (!clips().clip(clip).annotation) continue;
    const features::CharacterState state = random_state(random, stance);
    const float time_to_impact_s = tests::uniform(random, 0.25F, 1.2F);
    return make_response(walkers(), state, clip, time_to_impact_s);
  }
}

/// The largest angle, radians, by which a joint's turn in one frame differs from that in the next.
float velocity_step(const Pose& a, const Pose& b, const Pose& c) {
  float most = 0;
  for (Role role : motion::kRoles) {
    const auto turn = [role](const Pose& from, const Pose& to) {
      return motion::rotation_vector(to.rotation[role] * from.rotation[role].conjugate());
    };
    most = std::max(most, (turn(b, c) - turn(a, b)).norm());
  }
  return most;
}

TEST(Stance, AWalkerWalksOnUntilItMustAnswer) {
  std::mt19937 random(1);
  int walked = 0;
  for (int i = 0; i < 60; ++i) {
    const Response r = random_response(random, kWalk);
    ASSERT_TRUE(is_valid(r));
    for (float t = 0; t < r.leave_s; t += kFrame_s)
      ASSERT_LT(tests::distance(pose_at(r, t), goes_on(r.state, t)), 1e-5F);
    EXPECT_LE(r.begin_s - r.leave_s, 0.5F);
    walked += r.leave_s > 0.3F ? 1 : 0;
  }
  EXPECT_GT(walked, 15);
}

// A pelvis comes down at once where a leg is straight and its foot stays.
TEST(Stance, AResponseBeginsInTheMovingPoseWithItsVelocities) {
  constexpr float kStep_s = 1e-3F;
  std::mt19937 random(2);
  for (int i = 0; i < 60; ++i) {
    const Response r = random_response(random, i % 2 == 0 ? kWalk : kGuard);
    const float at_s = r.leave_s;
    EXPECT_LT(tests::distance(pose_at(r, at_s), goes_on(r.state, at_s)), 2e-3F) << i;
    const Pose before = goes_on(r.state, at_s - kStep_s);
    const Pose after = pose_at(r, at_s + kStep_s);
    const Eigen::Vector3f change = (after.root_position - pose_at(r, at_s).root_position) -
                                   (goes_on(r.state, at_s).root_position - before.root_position);
    EXPECT_LT(change.head<2>().norm() / kStep_s, 0.1F) << i;
  }
}

TEST(Stance, AWalkerWalksOnAfterwards) {
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    const Response r = random_response(random, kWalk);
    const float end_s = duration_s(r);
    features::CharacterState after = r.home;
    after.position += r.idle_displacement.head<2>();
    EXPECT_EQ(after.stance, kWalk);
    EXPECT_EQ(after.facing, r.state.facing);
    for (float t = end_s; t < end_s + 1.5F; t += kFrame_s)
      ASSERT_LT(tests::distance(pose_at(r, t), goes_on(after, home_time_s(r, t))), 1e-4F);
    const float full_s = end_s + kWalkOn_s;
    EXPECT_NEAR(home_time_s(r, full_s + 1) - home_time_s(r, full_s), 1, 1e-4F);
  }
}

/// The longest slides of 400 responses from a stance and a second of it afterwards, sorted, m.
std::vector<float> sorted_slides_m(int stance) {
  std::mt19937 random(4);
  std::vector<float> slides_m;
  for (int i = 0; i < 400; ++i) {
    const Response r = random_response(random, stance);
    slides_m.push_back(tests::longest_slide(r, 0, duration_s(r) + 1).way_m);
  }
  std::ranges::sort(slides_m);
  return slides_m;
}

// The walk's own feet do not slide.
TEST(Stance, NoStandingFootSlides) {
  const std::vector<float> slides_m = sorted_slides_m(kWalk);
  EXPECT_LT(slides_m[slides_m.size() / 2], 0.006F);
  EXPECT_LT(slides_m[slides_m.size() * 95 / 100], 0.01F);
  EXPECT_LT(slides_m.back(), 0.02F);
}

// The feet of a guard are far apart and turned out. The rear one turns on its heel while the hips
// turn to the front, its heel rises where the body ducks, and it lifts its toes before it steps.
TEST(Stance, NoFootOfAGuardSlides) {
  const std::vector<float> slides_m = sorted_slides_m(kGuard);
  EXPECT_LT(slides_m[slides_m.size() / 2], 0.01F);
  EXPECT_LT(slides_m[slides_m.size() * 95 / 100], 0.018F);
  EXPECT_LT(slides_m.back(), 0.03F);
}

// From where it swings, with its velocity, and above the ground.
TEST(Stance, ASwingingFootLandsWithoutAJolt) {
  constexpr float kStep_s = 1e-3F;
  std::mt19937 random(8);
  int landings = 0;
  for (int i = 0; i < 200; ++i) {
    const Response r = random_response(random, kWalk);
    for (Side side : motion::kSides) {
      const Landing& landing = r.landings[side];
      if (!std::isfinite(landing.interval.end_s)) continue;
      ++landings;
      const auto foot_at = [&](float t) {
        return foot_of(walkers().skeleton(), pose_at(r, t), side).ankle;
      };
      const auto walking_foot_at = [&](float t) {
        return foot_of(walkers().skeleton(), goes_on(r.state, t), side).ankle;
      };
      const float at_s = r.leave_s;
      EXPECT_LT((foot_at(at_s) - walking_foot_at(at_s)).norm(), 2e-3F) << i;
      const Eigen::Vector3f velocity =
          (foot_at(at_s + 2 * kStep_s) - foot_at(at_s + kStep_s)) / kStep_s;
      const Eigen::Vector3f walks =
          (walking_foot_at(at_s) - walking_foot_at(at_s - kStep_s)) / kStep_s;
      EXPECT_LT((velocity - walks).norm(), 0.6F) << i;  // m/s, of up to 4
      EXPECT_GT(landing.interval.end_s, at_s);
      EXPECT_LT(landing.interval.end_s, at_s + 0.25F);
    }
  }
  EXPECT_GT(landings, 60);
}

TEST(Stance, NoSeamIsMoreAbruptThanTheMotionsThemselves) {
  std::mt19937 random(5);
  float most = 0;
  for (int i = 0; i < 60; ++i) {
    const Response r = random_response(random, i % 2 == 0 ? kWalk : kGuard);
    for (const float seam_s :
         {r.leave_s, r.begin_s, r.begin_s + r.blend_duration_s, r.end_s, duration_s(r)}) {
      if (seam_s < kFrame_s) continue;
      most = std::max(most, velocity_step(pose_at(r, seam_s - kFrame_s), pose_at(r, seam_s),
                                          pose_at(r, seam_s + kFrame_s)));
    }
  }
  EXPECT_LT(most / kFrame_s, 17.0F);  // rad/s
}

TEST(Stance, ACharacterThatDoesNothingGoesOn) {
  std::mt19937 random(6);
  for (const int stance : {0, kGuard, kWalk}) {
    const features::CharacterState state = random_state(random, stance);
    const Response r = make_response(walkers(), state, clips().idle, 0.7F);
    ASSERT_TRUE(is_valid(r));
    EXPECT_EQ(duration_s(r), 0);
    for (float t = 0; t < 3; t += 0.1F)
      EXPECT_EQ(tests::distance(pose_at(r, t), goes_on(state, t)), 0);
  }
}

TEST(Stance, AStateLaterIsTheSameMotion) {
  std::mt19937 random(7);
  for (const int stance : {0, kGuard, kWalk}) {
    const features::CharacterState state = random_state(random, stance);
    const motion::Loop& loop = walkers().stance_of(state).loop;
    for (float later_s : {0.2F, 1.3F, 4.9F}) {
      const features::CharacterState then = features::later(loop, state, later_s);
      EXPECT_LT(
          tests::distance(features::idle_pose(loop, then, 0.4F), goes_on(state, later_s + 0.4F)),
          1e-3F);
      if (stance != 0) {
        EXPECT_LT(then.idle_time_s, loop.period_s());
      }
    }
  }
}

TEST(Stance, AnUnknownStanceIsNoInput) {
  for (const int stance : {-1, 3}) {
    features::CharacterState state;
    state.stance = stance;
    EXPECT_FALSE(is_valid(make_response(walkers(), state, 0, 0.5F)));
  }
}

}  // namespace
}  // namespace flinch::runtime
