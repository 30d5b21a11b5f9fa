// SPDX-License-Identifier: MIT
#include "database/author/authored_library.h"

#include <gmock/gmock.h>

#include <array>
#include <set>
#include <span>

#include "author_scene.h"
#include "database/author/character_toml.h"
#include "database/files/library_writer.h"
#include "database/quality/quality.h"
#include "motion/body_distance.h"
#include "motion/loop.h"
#include "tests/scenes/sample_count.h"

namespace flinch::database {
namespace {

using motion::Clip;
using motion::degrees;
using motion::JointFrames;
using motion::radians;
using motion::Target;
using test::AuthorScene;

const ClipLibrary& default_library() {
  static const ClipLibrary library = authored_library(motion::default_character());
  return library;
}

TEST(AuthoredLibrary, CoversEveryTargetDirectionAndDegree) {
  const ClipLibrary& library = default_library();
  EXPECT_GE(library.clips.size(), 110U);
  std::set<std::pair<int, int>> answered;
  std::set<int> degrees_of_targets;
  for (const Clip& clip : library.clips) {
    if (!clip.annotation) continue;
    const int target = static_cast<int>(clip.annotation->target);
    answered.insert({target, std::lround(degrees(clip.annotation->direction))});
    degrees_of_targets.insert(2 * target + static_cast<int>(clip.annotation->degree));
  }
  EXPECT_EQ(answered.size(), 32U);
  EXPECT_EQ(degrees_of_targets.size(), 8U);
}

TEST(AuthoredLibrary, IsReproducibleBitForBit) {
  if (tests::draws_fewer_samples()) GTEST_SKIP() << "twice the same code";
  const std::string once = library_bytes(default_library());
  EXPECT_EQ(once, library_bytes(authored_library(motion::default_character())));
}

TEST(AuthoredLibrary, StartsEveryClipFromTheIdlePose) {
  const ClipLibrary& library = default_library();
  const AuthorScene scene;
  const JointFrames idle =
      motion::forward_kinematics(scene.figure.skeleton(), library.idle_clip().motion.poses[0]);
  for (const Clip& clip : library.clips) {
    if (clip.purpose == motion::Purpose::stance) continue;
    const JointFrames first =
        motion::forward_kinematics(scene.figure.skeleton(), clip.motion.poses[0]);
    for (motion::Role role : motion::kRoles) {
      EXPECT_LT((first.position[role] - idle.position[role]).norm(), 2e-3F) << clip.name;
    }
  }
}

TEST(AuthoredLibrary, TheGuardStaysOnItsFeetWithFistsBeforeTheChin) {
  const AuthorScene scene;
  const Clip& guard = default_library().clips.back();
  ASSERT_EQ(guard.purpose, motion::Purpose::stance);
  EXPECT_FALSE(motion::Loop::in_cycles(guard.motion).travels());
  const JointFrames first =
      motion::forward_kinematics(scene.figure.skeleton(), guard.motion.poses.front());
  for (const motion::Pose& pose : guard.motion.poses) {
    const JointFrames frames = motion::forward_kinematics(scene.figure.skeleton(), pose);
    for (const motion::Side side : motion::kSides) {
      EXPECT_LT(
          (motion::foot_pose(frames, side).ankle - motion::foot_pose(first, side).ankle).norm(),
          1e-3F);
      const motion::Role hand = motion::roles_of(motion::arm_of(side)).end;
      const Eigen::Vector3f from_head = frames.position[hand] - frames.position[motion::Role::head];
      EXPECT_GT(from_head.x(), 0.15F);
      EXPECT_LT(std::abs(from_head.z()), 0.15F);
    }
  }
}

TEST(AuthoredLibrary, EveryClipMeetsTheQualityBounds) {
  const std::vector<ClipQuality> table = measure_quality(default_library());
  ASSERT_EQ(table.size(), default_library().clips.size());
  for (const ClipQuality& quality : table) {
    EXPECT_THAT(broken_bounds(quality), testing::IsEmpty()) << quality.name;
  }
}

// Sweeps a ball on a straight line at the centre of the idling figure's target against every body
// around the clip's peak.
bool avoids_ball(const AuthorScene& scene, const Clip& clip, float elevation, float speed_mps) {
  const float azimuth = clip.annotation->direction;
  const Eigen::Vector3f from(std::cos(azimuth) * std::cos(elevation),
                             std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
  const Eigen::Vector3f geometry =
      motion::target_centre(scene.figure.bodies, scene.frames, clip.annotation->target);
  for (float time = -0.12F; time < 0.12F; time += 0.005F) {
    const JointFrames frames = motion::forward_kinematics(
        scene.figure.skeleton(), motion::sample(clip.motion, clip.annotation->peak_s + time));
    if (distance_to_figure(scene.figure, frames, geometry - speed_mps * time * from) < 0.105F)
      return false;
  }
  return true;
}

TEST(AuthoredLibrary, AThirdOfTheClipsAvoidAWellAimedBall) {
  const AuthorScene scene;
  int clips = 0;
  int avoiding = 0;
  for (const Clip& clip : default_library().clips) {
    if (!clip.annotation || !clip.mirrored_from.empty()) continue;
    ++clips;
    avoiding +=
        avoids_ball(scene, clip, 0, 15) && avoids_ball(scene, clip, radians(25), 15) ? 1 : 0;
  }
  EXPECT_GE(3 * avoiding, clips) << avoiding << " of " << clips;
}

TEST(AuthoredLibrary, StartlesOnlyOnRequest) {
  const ClipLibrary startled = authored_library(motion::default_character(), true);
  ASSERT_EQ(startled.clips.size(), default_library().clips.size());
  for (std::size_t i = 0; i < startled.clips.size(); ++i) {
    const motion::Clip& clip = startled.clips[i];
    const motion::Pose with = sample(clip.motion, 0.125F);
    const motion::Pose without = sample(default_library().clips[i].motion, 0.125F);
    const bool differs = with.rotation[motion::Role::left_clavicle].angularDistance(
                             without.rotation[motion::Role::left_clavicle]) > 1e-3F;
    EXPECT_EQ(differs, clip.kind == "block") << clip.name;
  }
}

TEST(AuthoredLibrary, WorksForOtherPeople) {
  struct Person {
    float height_m, mass_kg;
    motion::Sex sex;
    Proportions proportions;
  };
  Proportions long_legs;
  long_legs.legs = 1.15F;
  long_legs.arms = 0.9F;
  const std::array people{Person{2.0F, 110, motion::Sex::male, long_legs},
                          Person{1.2F, 25, motion::Sex::female, {}},
                          Person{1.63F, 58, motion::Sex::female, {}}};
  const auto count = static_cast<std::size_t>(tests::samples(static_cast<int>(people.size())));
  for (const Person& person : std::span(people).first(count)) {
    const ClipLibrary library = authored_library(
        make_character(person.height_m, person.mass_kg, person.sex, person.proportions));
    EXPECT_NO_THROW(library_bytes(library));
    for (const ClipQuality& quality : measure_quality(library)) {
      EXPECT_LT(quality.limit_excess_deg, 5) << quality.name << " at " << person.height_m;
      EXPECT_LE(quality.support_drift_m, 0.002F) << quality.name << " at " << person.height_m;
      EXPECT_LE(quality.foot_below_ground_m, 0.002F) << quality.name << " at " << person.height_m;
    }
  }
}

}  // namespace
}  // namespace flinch::database
