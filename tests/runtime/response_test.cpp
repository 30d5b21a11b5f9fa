// SPDX-License-Identifier: MIT
#include "runtime/response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "motion/default_character.h"
#include "motion/interpolation.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/allocation_count.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;
using tests::allocation_count;
using tests::distance;

constexpr int kIdle = 0;
constexpr int kDuck = 1;
constexpr int kStep = 2;
constexpr int kUnannotated = 3;

Pose stance(float pelvis_yaw) {
  Pose pose = motion::rest_pose(motion::default_character().skeleton);
  pose.rotation[Role::pelvis] = Eigen::AngleAxisf(pelvis_yaw, Eigen::Vector3f::UnitZ());
  pose.rotation[Role::left_upper_arm] = Eigen::AngleAxisf(-1.3F, Eigen::Vector3f::UnitX());
  pose.rotation[Role::right_upper_arm] = Eigen::AngleAxisf(1.3F, Eigen::Vector3f::UnitX());
  return pose;
}

// Goes from one pose by a cosine to another and back, `seconds` in all.
motion::Motion there_and_back(const Pose& from, const Pose& to, float seconds, bool back = true) {
  motion::Motion motion;
  const int last = static_cast<int>(seconds * 60);
  for (int i = 0; i <= last; ++i) {
    const float phase = 3.14159265F * static_cast<float>(i) / static_cast<float>(last);
    const float weight = 0.5F - 0.5F * std::cos(back ? 2 * phase : phase);
    motion.poses.push_back(motion::blend(from, to, weight));
  }
  return motion;
}

// An idle that sways; a duck by a boxer whose pelvis is turned from his facing; a side step of
// 0.6 m; a clip that nobody annotated.
database::Library make_library() {
  database::Library library;
  library.character = motion::default_character();
  library.idle = kIdle;
  library.clips.resize(4);

  Pose swayed = stance(0);
  swayed.root_position += Eigen::Vector3f(0.01F, 0.04F, -0.01F);
  swayed.rotation[Role::chest] = Eigen::AngleAxisf(0.1F, Eigen::Vector3f::UnitX());
  library.clips[kIdle].purpose = motion::Purpose::idle;
  library.clips[kIdle].motion = there_and_back(stance(0), swayed, 3);

  Pose ducked = stance(-0.4F);
  ducked.root_position += Eigen::Vector3f(-0.05F, 0.1F, -0.35F);
  ducked.rotation[Role::abdomen] = Eigen::AngleAxisf(0.7F, Eigen::Vector3f::UnitY());
  ducked.rotation[Role::left_upper_arm] = Eigen::AngleAxisf(2.0F, Eigen::Vector3f::UnitX());
  library.clips[kDuck].annotation =
      motion::Annotation{.onset_s = 0.1F, .peak_s = 0.6F, .end_s = 1.0F};
  library.clips[kDuck].motion = there_and_back(stance(-0.4F), ducked, 1.2F);

  Pose stepped = stance(-0.2F);
  stepped.root_position.y() += 0.6F;
  library.clips[kStep].annotation =
      motion::Annotation{.onset_s = 0.2F, .peak_s = 0.9F, .end_s = 1.1F};
  library.clips[kStep].motion = there_and_back(stance(-0.2F), stepped, 1.2F, false);

  library.clips[kUnannotated].motion = library.clips[kDuck].motion;
  return library;
}

const features::CharacterState kState{.idle_time_s = 0.7F, .position = {2, -1}, .facing = 0.9F};

Pose idle_at(const database::Library& library, const features::CharacterState& state, float t) {
  return features::idle_pose(library.clips[kIdle].motion, state, t);
}

TEST(Response, PeaksAtTheImpactWhenThereIsTime) {
  const database::Library library = make_library();
  const motion::Clip& duck = library.clips[kDuck];
  for (float impact_s : {0.5F, 0.6F, 0.9F, 1.2F}) {
    const Response response = make_response(library, kState, kDuck, impact_s);
    EXPECT_EQ(response.playback_rate, 1);
    EXPECT_NEAR(response.begin_s, impact_s - 0.5F, 1e-6F);
    const Pose peak = motion::placed(motion::sample(duck.motion, duck.annotation->peak_s),
                                     response.yaw, response.translation);
    EXPECT_LT(distance(pose_at(response, impact_s), peak), 1e-4F);
  }
}

// The duck's 0.5 s to its peak: at 1.25 times the speed for 0.4 s, at most at 1.4 times, which
// takes 0.357 s even when the impact comes before.
TEST(Response, PlaysFasterUpToALimitWhenTimeIsShort) {
  const database::Library library = make_library();
  const Response fast = make_response(library, kState, kDuck, 0.4F);
  EXPECT_NEAR(fast.playback_rate, 1.25F, 1e-5F);
  EXPECT_EQ(fast.begin_s, 0);
  EXPECT_NEAR(fast.end_s, 0.9F / 1.25F, 1e-5F);
  const Response late = make_response(library, kState, kDuck, 0.1F);
  EXPECT_EQ(late.playback_rate, kMostPlaybackRate);
  EXPECT_EQ(late.begin_s, 0);
  const motion::Clip& duck = library.clips[kDuck];
  const Pose peak = motion::placed(motion::sample(duck.motion, 0.6F), late.yaw, late.translation);
  EXPECT_LT(distance(pose_at(late, 0.5F / 1.4F), peak), 1e-3F);
}

TEST(Response, IdlesUntilItBegins) {
  const database::Library library = make_library();
  const Response response = make_response(library, kState, kDuck, 1.2F);
  for (float t : {0.0F, 0.3F, 0.7F}) {
    EXPECT_EQ(distance(pose_at(response, t), idle_at(library, kState, t)), 0);
  }
  EXPECT_GT(distance(pose_at(response, 0.8F), idle_at(library, kState, 0.8F)), 0.05F);
}

TEST(Response, StartsFromTheIdlePoseEvenWithoutTime) {
  const database::Library library = make_library();
  const Response response = make_response(library, kState, kDuck, 0.05F);
  EXPECT_LT(distance(pose_at(response, 0), idle_at(library, kState, 0)), 1e-6F);
  EXPECT_LT(distance(pose_at(response, 1e-4F), idle_at(library, kState, 0)), 1e-3F);
}

// The clip's forward axis on the character's facing, whatever way its pelvis is turned; its pelvis
// at onset over the idle one's at the beginning.
TEST(Response, AlignsFacingWithFacingAndPelvisOverPelvis) {
  const database::Library library = make_library();
  const Response response = make_response(library, kState, kDuck, 1.0F);
  EXPECT_EQ(response.yaw, kState.facing);
  const Pose onset = motion::placed(motion::sample(library.clips[kDuck].motion, 0.1F), response.yaw,
                                    response.translation);
  const Pose idle = idle_at(library, kState, response.begin_s);
  EXPECT_LT((onset.root_position - idle.root_position).head<2>().norm(), 1e-5F);
  EXPECT_NEAR(motion::facing(onset), kState.facing - 0.4F, 1e-4F);
  EXPECT_EQ(response.translation.z(), 0);
}

// The largest speed that anything here has: of the clip and the idle, quickened, and of crossing
// over from one to the other (a whole turn of a joint at most, weights changing by 1.5 / blend).
TEST(Response, NeverJumps) {
  const database::Library library = make_library();
  constexpr float kStep_s = 1e-3F;
  int cases = 0;
  for (int clip : {kDuck, kStep}) {
    for (float impact_s : {0.15F, 0.4F, 0.55F, 0.7F, 1.2F}) {
      const Response response = make_response(library, kState, clip, impact_s);
      const float turn = 2 * 3.15F;
      const float most_speed = 1.5F * turn / response.blend_s + kMostPlaybackRate * 20;
      Pose last = pose_at(response, 0);
      for (float t = kStep_s; t < duration_s(response) + 0.5F; t += kStep_s) {
        const Pose pose = pose_at(response, t);
        ASSERT_LT(distance(pose, last), most_speed * kStep_s) << clip << " at " << t;
        last = pose;
        ++cases;
      }
    }
  }
  EXPECT_GT(cases, 10000);
}

// Where the phases meet, the poses on either side are the same.
TEST(Response, PhasesMeetWithoutASeam) {
  const database::Library library = make_library();
  for (int clip : {kDuck, kStep}) {
    for (float impact_s : {0.2F, 0.8F, 1.2F}) {
      const Response r = make_response(library, kState, clip, impact_s);
      for (float seam : {r.begin_s, r.begin_s + r.blend_s, r.end_s, duration_s(r)}) {
        const float before = std::max(seam - 1e-4F, 0.0F);
        EXPECT_LT(distance(pose_at(r, before), pose_at(r, seam + 1e-4F)), 5e-3F) << seam;
      }
    }
  }
}

TEST(Response, ComesBackToIdleAndKeepsIdling) {
  const database::Library library = make_library();
  const Response response = make_response(library, kState, kDuck, 0.8F);
  for (float later_s : {0.0F, 0.5F, 10.0F}) {
    const float t = duration_s(response) + later_s;
    Pose idle = idle_at(library, kState, t);
    idle.root_position += response.travel;
    EXPECT_LT(distance(pose_at(response, t), idle), 1e-5F);
  }
  EXPECT_NEAR(duration_s(response), response.end_s + kBlend, 1e-6F);
}

// The step ends 0.6 m to the left of where it began, less what it had gone by its onset; left of a
// character that faces 0.9 rad is (-sin, cos).
TEST(Response, StaysWhereAStepLedAndTheNextStateGoesOnThere) {
  const database::Library library = make_library();
  const Response response = make_response(library, kState, kStep, 1.0F);
  const Pose end = pose_at(response, duration_s(response));
  const Pose begin = pose_at(response, response.begin_s);
  const float gone = library.clips[kStep].motion.poses[12].root_position.y();
  const Eigen::Vector2f left(-std::sin(0.9F), std::cos(0.9F));
  EXPECT_LT(((end.root_position - begin.root_position).head<2>() - (0.6F - gone) * left).norm(),
            1e-4F);
  EXPECT_EQ(response.travel.z(), 0);
  features::CharacterState next = kState;
  next.position += response.travel.head<2>();
  const float t = duration_s(response) + 0.4F;
  EXPECT_LT(distance(pose_at(response, t), idle_at(library, next, t)), 1e-5F);
}

TEST(Response, TurnsAndMovesWithTheWorld) {
  std::mt19937 random(1);
  const database::Library library = make_library();
  for (int i = 0; i < 50; ++i) {
    const float yaw = tests::uniform(random, -3, 3);
    Eigen::Vector3f move = tests::random_vector(random, 5);
    move.z() = 0;
    const Eigen::AngleAxisf turn(yaw, Eigen::Vector3f::UnitZ());
    features::CharacterState moved = kState;
    moved.facing += yaw;
    moved.position =
        (turn * Eigen::Vector3f(kState.position.x(), kState.position.y(), 0) + move).head<2>();
    const int clip = i % 2 == 0 ? kDuck : kStep;
    const float impact_s = tests::uniform(random, 0.2F, 1.2F);
    const float t = tests::uniform(random, 0, 2);
    const Pose pose = pose_at(make_response(library, kState, clip, impact_s), t);
    const Pose there = pose_at(make_response(library, moved, clip, impact_s), t);
    EXPECT_LT(distance(motion::placed(pose, yaw, move), there), 1e-3F);
  }
}

// Asking at 24, 60 or 1000 Hz, or backwards, gives the same poses to the bit.
TEST(Response, DoesNotDependOnWhenItIsAsked) {
  const database::Library library = make_library();
  const Response asked_often = make_response(library, kState, kDuck, 0.7F);
  const Response asked_once = asked_often;
  for (int i = 2000; i >= 0; --i) pose_at(asked_often, static_cast<float>(i) * 1e-3F);
  for (float t : {0.1F, 0.25F, 0.5F, 0.7F, 1.3F}) {
    EXPECT_EQ(distance(pose_at(asked_often, t), pose_at(asked_once, t)), 0);
  }
}

TEST(Response, OfTheIdleClipIsIdling) {
  const database::Library library = make_library();
  const Response response = make_response(library, kState, kIdle, 0.5F);
  EXPECT_TRUE(is_valid(response));
  EXPECT_EQ(duration_s(response), 0);
  for (float t : {0.0F, 0.5F, 7.0F}) {
    EXPECT_EQ(distance(pose_at(response, t), idle_at(library, kState, t)), 0);
  }
}

TEST(Response, OfUnusableInputIsInvalidAndHarmless) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const database::Library library = make_library();
  features::CharacterState lost = kState;
  lost.position.x() = kNan;
  database::Library disordered = make_library();
  disordered.clips[kDuck].annotation->peak_s = 0.05F;
  database::Library without_poses = make_library();
  without_poses.clips[kDuck].motion.poses.clear();
  database::Library without_idle = make_library();
  without_idle.idle = 9;
  for (const Response& response :
       {make_response(library, kState, -1, 0.5F), make_response(library, kState, 4, 0.5F),
        make_response(library, kState, kUnannotated, 0.5F),
        make_response(library, kState, kDuck, 0), make_response(library, kState, kDuck, kNan),
        make_response(library, kState, kDuck, kInfinity), make_response(library, lost, kDuck, 0.5F),
        make_response(disordered, kState, kDuck, 0.5F),
        make_response(without_poses, kState, kDuck, 0.5F),
        make_response(without_idle, kState, kDuck, 0.5F),
        make_response(database::Library{}, kState, 0, 0.5F), Response{}}) {
    EXPECT_FALSE(is_valid(response));
    EXPECT_EQ(duration_s(response), 0);
    EXPECT_EQ(distance(pose_at(response, 0.3F), Pose()), 0);
  }
}

TEST(Response, TakesTimesThatAreNoTimesAsPerception) {
  const database::Library library = make_library();
  const Response response = make_response(library, kState, kDuck, 0.5F);
  for (float t :
       {-1.0F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(distance(pose_at(response, t), pose_at(response, 0)), 0);
  }
}

TEST(Response, AllocatesNothing) {
  const database::Library library = make_library();
  const std::size_t before_copy = allocation_count();
  const database::Library copy = library;
  ASSERT_GT(allocation_count(), before_copy);  // the count counts
  const std::size_t before = allocation_count();
  float sum = 0;
  for (int i = 0; i < 20; ++i) {
    const Response response = make_response(library, kState, i % 3, 0.6F);
    for (float t = 0; t < 2; t += 0.01F) sum += pose_at(response, t).root_position.x();
  }
  EXPECT_EQ(allocation_count(), before);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace flinch::runtime
