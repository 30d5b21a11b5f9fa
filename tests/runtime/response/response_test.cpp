// SPDX-License-Identifier: MIT
#include "runtime/response/response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "motion/figure.h"
#include "motion/interpolation.h"
#include "motion/joint_limits.h"
#include "motion/limb_ik.h"
#include "motion/rotation.h"
#include "runtime/response/prepared_library.h"
#include "runtime/response/response_pose.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/response/response_quality.h"
#include "tests/scenes/allocation_count.h"
#include "tests/scenes/not_finite.h"
#include "tests/scenes/sample_count.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;
using motion::Side;
using tests::allocation_count;
using tests::distance;
using tests::kInfinity;
using tests::kNan;

const database::ClipLibrary& authored() {
  static const database::ClipLibrary library =
      database::authored_library(motion::default_character());
  return library;
}

const PreparedLibrary& prepared() {
  static const PreparedLibrary library = prepare(authored());
  return library;
}

int clip_named(const database::ClipLibrary& library, std::string_view name) {
  for (std::size_t i = 0; i < library.clips.size(); ++i) {
    if (library.clips[i].name == name) return static_cast<int>(i);
  }
  ADD_FAILURE() << "no clip " << name;
  return 0;
}

const int kIdle = 0;
const int kDuck = clip_named(authored(), "duck_head_front_exaggerated");
const int kBlock = clip_named(authored(), "block_head_front_left_mild");
const int kSidestep = clip_named(authored(), "sidestep_trunk_front_exaggerated");
const int kLift = clip_named(authored(), "lift_legs_front_exaggerated");

const features::CharacterState kState{.idle_time_s = 0.7F, .position = {2, -1}, .facing = 0.9F};

const motion::Annotation& annotation_of(int clip) {
  return *prepared().clip(clip).annotation;
}

float time_to_peak_s(int clip) {
  return annotation_of(clip).peak_s - annotation_of(clip).onset_s;
}

Pose idle_at(const features::CharacterState& state, float t) {
  return features::idle_pose(prepared().idle(), state, t);
}

// The library with only its idle clip and one other, modified, clip.
template <typename Change>
database::ClipLibrary with_changed(int clip, Change change) {
  database::ClipLibrary library = authored();
  const motion::Clip kept = library.clip(clip);
  library.clips.resize(1);
  library.clips.push_back(kept);
  change(library.clips[1]);
  return library;
}

// A clip that ends out of the threat's way, with both feet on the ground there.
database::ClipLibrary one_way_step() {
  return with_changed(kSidestep, [](motion::Clip& clip) {
    const float until_s = clip.annotation->peak_s + 0.2F;
    clip.motion.poses.resize(static_cast<std::size_t>(until_s * clip.motion.rate_hz));
    clip.annotation->end_s = clip.motion.duration_s();
  });
}

// A clip of another actor, with a wider stance, turned and elsewhere, that does not step.
database::ClipLibrary other_stance() {
  return with_changed(kBlock, [](motion::Clip& clip) {
    const motion::Skeleton& skeleton = motion::default_character().skeleton;
    for (Pose& pose : clip.motion.poses) {
      pose = motion::placed(pose, -0.5F, {0.3F, 0.1F, 0});
      const motion::JointFrames frames = motion::forward_kinematics(skeleton, pose);
      for (Side side : motion::kSides) {
        motion::FootPose foot = motion::foot_pose(frames, side);
        foot.ankle.y() += 0.09F * motion::sign_of(side);
        foot.ankle.x() -= 0.05F * motion::sign_of(side);
        motion::move_limb_end(frames, motion::leg_of(side), foot.ankle, foot.orientation, pose);
      }
    }
  });
}

TEST(Response, PeaksAtTheImpactWhenThereIsTime) {
  for (int clip : {kDuck, kBlock, kSidestep, kLift}) {
    for (float impact_s : {0.7F, 0.9F, 1.2F}) {
      const Response response = make_response(prepared(), kState, clip, impact_s);
      EXPECT_EQ(response.playback_rate, 1);
      EXPECT_NEAR(response.begin_s, impact_s - time_to_peak_s(clip), 1e-5F);
      EXPECT_NEAR(response.peak_s, impact_s, 1e-5F);
      const Pose at_peak = pose_at(response, impact_s);
      const Pose peak =
          motion::placed(motion::sample(prepared().clip(clip).motion, annotation_of(clip).peak_s),
                         response.yaw, response.translation);
      const bool weight_is_back =
          response.shifts[0].interval.end_s < impact_s || response.shifts[0].pelvis.isZero(0);
      EXPECT_TRUE(!weight_is_back || distance(at_peak, peak) < 2e-3F) << clip;
    }
  }
}

TEST(Response, PlaysFasterUpToALimitWhenTimeIsShort) {
  const float way_s = time_to_peak_s(kDuck);
  const Response fast = make_response(prepared(), kState, kDuck, 0.8F * way_s);
  EXPECT_NEAR(fast.playback_rate, 1.25F, 1e-4F);
  EXPECT_EQ(fast.begin_s, 0);
  EXPECT_NEAR(fast.peak_s, 0.8F * way_s, 1e-5F);
  const Response late = make_response(prepared(), kState, kDuck, 0.1F);
  EXPECT_EQ(late.playback_rate, kMaxPlaybackRate);
  EXPECT_EQ(late.begin_s, 0);
  EXPECT_NEAR(late.peak_s, way_s / kMaxPlaybackRate, 1e-5F);
}

TEST(Response, IdlesUntilItStarts) {
  for (int clip : {kDuck, kSidestep}) {
    const Response response = make_response(prepared(), kState, clip, 1.2F);
    EXPECT_GT(response.first_motion_s, 0.3F);
    for (float part : {0.0F, 0.4F, 1.0F}) {
      const float t = part * response.first_motion_s;
      EXPECT_EQ(distance(pose_at(response, t), idle_at(kState, t)), 0);
    }
    EXPECT_GT(distance(pose_at(response, 1.1F), idle_at(kState, 1.1F)), 0.05F);
  }
}

TEST(Response, StartsFromTheIdlePoseHoweverShortTheTime) {
  for (int clip : {kDuck, kBlock, kSidestep, kLift}) {
    const Response response = make_response(prepared(), kState, clip, 0.05F);
    EXPECT_LT(distance(pose_at(response, 0), idle_at(kState, 0)), 1e-6F);
    EXPECT_LT(distance(pose_at(response, 1e-4F), idle_at(kState, 0)), 2e-3F);
  }
}

TEST(Response, AlignsTheClipsFacingAndSupportFootWithTheCharacters) {
  const database::ClipLibrary library = other_stance();
  const PreparedLibrary other = prepare(library);
  const Response response = make_response(other, kState, 1, 1.0F);
  EXPECT_EQ(response.yaw, kState.facing);
  EXPECT_EQ(response.translation.z(), 0);
  const motion::FootPose before =
      foot_of(other.skeleton(), idle_at(kState, response.begin_s), response.support);
  for (float t = 0; t < response.end_s; t += 0.05F) {
    const motion::FootPose now = foot_of(other.skeleton(), pose_at(response, t), response.support);
    EXPECT_LT((now.ankle - before.ankle).norm(), 1e-3F) << t;
    EXPECT_LT(now.orientation.angularDistance(before.orientation), 5e-3F) << t;
  }
}

TEST(Response, StepsWithTheOtherFootToTheClipsPlace) {
  const database::ClipLibrary library = other_stance();
  const PreparedLibrary other = prepare(library);
  const Response response = make_response(other, kState, 1, 1.0F);
  const Side side = motion::other(response.support);
  const FootPlan& plan = response.feet[side];
  ASSERT_GT(plan.correction_lift_m, 0);
  const float t = plan.correction.end_s + 0.02F;
  const motion::FootPose clip_foot = foot_of(other.skeleton(), clip_pose_at(response, t), side);
  const motion::FootPose foot = foot_of(other.skeleton(), pose_at(response, t), side);
  EXPECT_LT((foot.ankle - clip_foot.ankle).norm(), 2e-3F);
  const float middle_s = 0.5F * (plan.correction.begin_s + plan.correction.end_s);
  EXPECT_GT(foot_of(other.skeleton(), pose_at(response, middle_s), side).ankle.z(),
            foot.ankle.z() + 0.5F * plan.correction_lift_m);
}

// The bound is the largest speed of clip and idle, sped up, plus that of blending from one to the
// other (at most a whole turn of a joint, with weights changing by 15/8 / blend).
TEST(Response, IsContinuous) {
  constexpr float kStep_s = 1e-3F;
  int cases = 0;
  for (int clip : {kDuck, kSidestep, kLift}) {
    for (float impact_s : {0.15F, 0.4F, 0.7F, 1.2F}) {
      const Response response = make_response(prepared(), kState, clip, impact_s);
      const float most_speed = 1.875F * 6.3F / response.blend_duration_s + kMaxPlaybackRate * 20;
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

TEST(Response, ReturnsToIdle) {
  const Response response = make_response(prepared(), kState, kDuck, 0.8F);
  for (float later_s : {0.0F, 0.5F, 10.0F}) {
    const float t = duration_s(response) + later_s;
    Pose idle = idle_at(kState, t);
    idle.root_position += response.idle_displacement;
    EXPECT_LT(distance(pose_at(response, t), idle), 1e-5F);
  }
  EXPECT_NEAR(duration_s(response), response.end_s + kMinBlend_s, 1e-6F);
}

// To the left of a character that faces 0.9 rad is (-sin, cos); the default library steps to the
// right.
TEST(Response, IdlesWhereItsStepEnded) {
  const database::ClipLibrary library = one_way_step();
  const PreparedLibrary stepping = prepare(library);
  const Response response = make_response(stepping, kState, 1, 1.0F);
  const Eigen::Vector3f right(std::sin(0.9F), -std::cos(0.9F), 0);
  EXPECT_GT(response.idle_displacement.dot(right), 0.3F);
  EXPECT_EQ(response.idle_displacement.z(), 0);
  features::CharacterState next = kState;
  next.position += response.idle_displacement.head<2>();
  const float t = duration_s(response) + 0.4F;
  EXPECT_LT(distance(pose_at(response, t), idle_at(next, t)), 1e-5F);
  // Feet that are not where the idle clip has them step home, and nothing jumps afterwards.
  const float seam = duration_s(response);
  EXPECT_LT(distance(pose_at(response, seam - 1e-4F), pose_at(response, seam + 1e-4F)), 5e-3F);
}

TEST(Response, IsInvariantToPositionAndFacing) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const float yaw = tests::uniform(random, -3, 3);
    Eigen::Vector3f move = tests::random_vector(random, 5);
    move.z() = 0;
    const Eigen::AngleAxisf turn(yaw, Eigen::Vector3f::UnitZ());
    features::CharacterState moved = kState;
    moved.facing += yaw;
    moved.position =
        (turn * Eigen::Vector3f(kState.position.x(), kState.position.y(), 0) + move).head<2>();
    const int clip = i % 2 == 0 ? kDuck : kSidestep;
    const float impact_s = tests::uniform(random, 0.2F, 1.2F);
    const float t = tests::uniform(random, 0, 2);
    const Pose pose = pose_at(make_response(prepared(), kState, clip, impact_s), t);
    const Pose there = pose_at(make_response(prepared(), moved, clip, impact_s), t);
    EXPECT_LT(distance(motion::placed(pose, yaw, move), there), 3e-3F);
  }
}

// Sampling at 24, 60 or 1000 Hz, or backwards, gives the same poses to the bit.
TEST(Response, PoseDependsOnTimeAlone) {
  const Response asked_often = make_response(prepared(), kState, kSidestep, 0.7F);
  const Response asked_once = asked_often;
  for (int i = 2000; i >= 0; --i) pose_at(asked_often, static_cast<float>(i) * 1e-3F);
  for (float t : {0.1F, 0.25F, 0.5F, 0.7F, 1.3F}) {
    EXPECT_EQ(distance(pose_at(asked_often, t), pose_at(asked_once, t)), 0);
  }
}

TEST(Response, OfTheIdleClipIsTheIdlePose) {
  const Response response = make_response(prepared(), kState, kIdle, 0.5F);
  EXPECT_TRUE(is_valid(response));
  EXPECT_EQ(duration_s(response), 0);
  for (float t : {0.0F, 0.5F, 7.0F}) {
    EXPECT_EQ(distance(pose_at(response, t), idle_at(kState, t)), 0);
  }
}

TEST(Response, OfBadInputIsInvalidAndSafe) {
  const database::ClipLibrary library = authored();
  features::CharacterState lost = kState;
  lost.position.x() = kNan;
  database::ClipLibrary disordered = authored();
  disordered.clips[static_cast<std::size_t>(kDuck)].annotation->peak_s = -0.05F;
  database::ClipLibrary without_poses = authored();
  without_poses.clips[static_cast<std::size_t>(kDuck)].motion.poses.clear();
  database::ClipLibrary without_idle = authored();
  without_idle.idle = 4000;
  const PreparedLibrary whole = prepare(library);
  const PreparedLibrary mixed_up = prepare(disordered);
  const PreparedLibrary poseless = prepare(without_poses);
  const PreparedLibrary idleless = prepare(without_idle);
  Inertialization nowhere;
  nowhere.is_zero = false;
  nowhere.root.x() = kNan;
  for (const Response& response :
       {make_response(whole, kState, kDuck, 0.5F, nowhere), make_response(whole, kState, -1, 0.5F),
        make_response(whole, kState, 4000, 0.5F), make_response(whole, kState, kDuck, 0),
        make_response(whole, kState, kDuck, kNan), make_response(whole, kState, kDuck, kInfinity),
        make_response(whole, lost, kDuck, 0.5F), make_response(mixed_up, kState, kDuck, 0.5F),
        make_response(poseless, kState, kDuck, 0.5F), make_response(idleless, kState, kDuck, 0.5F),
        make_response(PreparedLibrary{}, kState, 0, 0.5F), Response{}}) {
    EXPECT_FALSE(is_valid(response));
    EXPECT_EQ(duration_s(response), 0);
    EXPECT_EQ(distance(pose_at(response, 0.3F), Pose()), 0);
  }
}

TEST(Response, TreatsInvalidTimesAsZero) {
  const Response response = make_response(prepared(), kState, kDuck, 0.5F);
  for (float t : {-1.0F, kNan, kInfinity}) {
    EXPECT_EQ(distance(pose_at(response, t), pose_at(response, 0)), 0);
  }
}

TEST(Response, AllocatesNothing) {
  const std::size_t before_copy = allocation_count();
  const database::ClipLibrary copy = authored();
  ASSERT_GT(allocation_count(), before_copy);  // the allocation counter works
  prepared();
  const std::size_t before = allocation_count();
  float sum = 0;
  for (int clip : {kIdle, kDuck, kSidestep, kLift}) {
    const Response response = make_response(prepared(), kState, clip, 0.6F);
    for (float t = 0; t < 2; t += 0.01F) sum += pose_at(response, t).root_position.x();
  }
  EXPECT_EQ(allocation_count(), before);
  EXPECT_TRUE(std::isfinite(sum));
}

// The measures of docs/response.md over all clips, each with a few of the study's threats.
TEST(ResponseQuality, AllClipsMeetTheBounds) {
  std::mt19937 random(3);
  int lifts = 0;
  for (int clip = 1; clip < static_cast<int>(authored().clips.size()); ++clip) {
    if (!authored().clip(clip).annotation) continue;
    for (int i = 0; i < 4; ++i) {
      const float impact_s = tests::uniform(random, 0.25F, 1.2F);
      const features::CharacterState state{
          tests::uniform(random, 0, 8),
          {tests::uniform(random, -1, 1), tests::uniform(random, -1, 1)},
          tests::uniform(random, -3, 3)};
      const Response response = make_response(prepared(), state, clip, impact_s);
      const tests::ResponseQuality quality = tests::measure_response(response, impact_s);
      const std::string what = prepared().clip(clip).name + " at " + std::to_string(impact_s);
      EXPECT_LT(quality.support_slip_m, 1e-3F) << what;
      EXPECT_LT(quality.below_ground_m, 2e-3F) << what;
      EXPECT_GE(quality.lift_margin_m, 0) << what << " lifts at " << quality.lift_s;
      EXPECT_LE(quality.seam_share, 1) << what << ": " << quality.seam;
      EXPECT_LT(quality.peak_error_s.value_or(0), 1.0F / 60) << what;
      lifts += quality.lift_margin_m < 1 ? 1 : 0;
    }
  }
  EXPECT_GT(lifts, 100);
}

// A body that hurries into a side step leaves the foot behind on which it stands.
TEST(ResponseQuality, JointsStayWithinTheirLimitsHoweverShortTheTime) {
  std::mt19937 random(5);
  for (int clip = 1; clip < static_cast<int>(authored().clips.size()); ++clip) {
    if (!authored().clip(clip).annotation) continue;
    for (int i = 0; i < tests::samples(12); ++i) {
      const features::CharacterState state{tests::uniform(random, 0, 100), {0, 0}, 0};
      const float impact_s = tests::uniform(random, 0.01F, 0.5F);
      const Response response = make_response(prepared(), state, clip, impact_s);
      for (float t = 0; t < duration_s(response); t += 1.0F / 60) {
        const motion::JointFrames frames =
            forward_kinematics(prepared().skeleton(), pose_at(response, t));
        for (const motion::JointLimits& limits : motion::human_joint_limits()) {
          const Eigen::Quaternionf rotation =
              motion::relative_rotation(frames, limits.from, limits.to);
          ASSERT_LE(limit_excess(limits, rotation), 0.02F)
              << limits.name << " in " << prepared().clip(clip).name << " at " << t << " s of "
              << impact_s;
        }
      }
    }
  }
}

// A character that is interrupted in the middle of a response; its pose and velocities continue.
struct Interruption {
  Pose before;
  Pose now;
  features::CharacterState state;
  Inertialization inertialization;
};

Interruption interrupted(int clip, float at_s) {
  constexpr float kStep_s = 1e-3F;
  const Response response = make_response(prepared(), kState, clip, 0.6F);
  Interruption at{pose_at(response, at_s - kStep_s), pose_at(response, at_s), {}, {}};
  at.state = rest_state_at(prepared(), at.now, 0);
  at.inertialization = make_inertialization(prepared(), at.state, at.before, at.now, kStep_s);
  return at;
}

TEST(Inertialization, ContinuesPoseAndVelocity) {
  constexpr float kStep_s = 1e-3F;
  for (int clip : {kDuck, kBlock, kSidestep}) {
    for (float at_s : {0.35F, 0.5F, 0.7F}) {
      const Interruption from = interrupted(clip, at_s);
      for (int next : {kIdle, kDuck, kLift}) {
        const Response response =
            make_response(prepared(), from.state, next, 0.5F, from.inertialization);
        ASSERT_TRUE(is_valid(response));
        EXPECT_LT(distance(pose_at(response, 0), from.now), 2e-3F) << clip << " at " << at_s;
        const Pose after = pose_at(response, kStep_s);
        for (Role role : {Role::pelvis, Role::chest, Role::left_upper_arm, Role::head}) {
          const auto velocity = [&](const Pose& a, const Pose& b) {
            return Eigen::Vector3f(
                motion::rotation_vector(b.rotation[role] * a.rotation[role].conjugate()) / kStep_s);
          };
          EXPECT_LT((velocity(from.now, after) - velocity(from.before, from.now)).norm(), 0.8F)
              << clip << " at " << at_s << ", " << motion::name_of(role);
        }
      }
    }
  }
}

TEST(Inertialization, KeepsStandingFeetInPlaceAndEndsAtIdle) {
  for (float at_s : {0.45F, 0.6F, 0.75F}) {
    const Interruption from = interrupted(kDuck, at_s);
    const Response response =
        make_response(prepared(), from.state, kIdle, 0.5F, from.inertialization);
    const motion::JointFrames first =
        motion::forward_kinematics(prepared().skeleton(), pose_at(response, 0));
    for (float t = 0; t < 1; t += 0.05F) {
      const motion::JointFrames frames =
          motion::forward_kinematics(prepared().skeleton(), pose_at(response, t));
      for (Side side : motion::kSides) {
        EXPECT_LT(
            (motion::foot_pose(frames, side).ankle - motion::foot_pose(first, side).ankle).norm(),
            2e-3F);
      }
    }
    const float end_s = duration_s(response);
    EXPECT_GT(end_s, 0.3F);
    EXPECT_LT(distance(pose_at(response, end_s), idle_at(from.state, end_s)), 1e-5F);
    EXPECT_LT(distance(pose_at(response, end_s - 1e-3F), pose_at(response, end_s)), 1e-2F);
  }
}

}  // namespace
}  // namespace flinch::runtime
