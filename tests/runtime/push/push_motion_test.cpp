// SPDX-License-Identifier: MIT
#include "runtime/push/push_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/rotation.h"
#include "runtime/push/push_deformation.h"
#include "runtime/push/push_search.h"
#include "tests/motion/random_motion.h"
#include "tests/runtime/push/push_scene.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;
using motion::Side;

constexpr float kStep_s = 1.0F / 240;

const tests::PushScene& scene() {
  static const tests::PushScene one;
  return one;
}

/// A character in a clip, somewhere in the world, that is pushed at `time_s`.
struct Shown {
  Pose before;
  Pose now;
};
Shown shown(const std::string& clip_name, float time_s) {
  for (const motion::Clip& clip : scene().library.clips) {
    if (clip.name != clip_name) continue;
    const auto pose = [&](float at_s) {
      return motion::placed(motion::sample(clip.motion, at_s), 0.7F, {3, -2, 0});
    };
    return {pose(time_s - kStep_s), pose(time_s)};
  }
  ADD_FAILURE() << clip_name;
  return {};
}

PushMotion pushed(const Shown& state, std::size_t response, const Eigen::Vector3f& m,
                  float taper = 3, float turn = 0, Role place = Role::chest) {
  const PushDeformation deformation{place, taper, m, scene().responses.responses[response].rise_s};
  return make_push_motion(scene().responses, response, turn, deformation, state.before, state.now,
                          kStep_s);
}

motion::JointFrames joints(const Pose& pose) {
  return motion::forward_kinematics(scene().library.character.skeleton, pose);
}

// Whatever the character does, its pose and the velocities of its joints go on without a step. Its
// legs are bent: the knee of a straight leg leaves its place like a square root of time.
TEST(PushMotion, BeginsWithTheShownPoseAndVelocities) {
  int cases = 0;
  for (const auto& [clip, time_s] :
       {std::pair{"idle", 0.7F}, std::pair{"duck", 0.3F}, std::pair{"idle", 1.6F},
        std::pair{"from_front", 0.9F}, std::pair{"from_left", 0.3F}}) {
    for (std::size_t response = 0; response < scene().responses.responses.size(); ++response) {
      const Shown state = shown(clip, time_s);
      const PushMotion motion = pushed(state, response, {0.5F, -0.3F, 0}, 3, 0.4F);
      EXPECT_LT(tests::distance(pose_at(motion, 0), state.now), 2e-3F) << clip << response;
      const auto then = joints(pose_at(motion, 0));
      const auto next = joints(pose_at(motion, kStep_s));
      const auto before = joints(state.before);
      const auto now = joints(state.now);
      for (const Role role : motion::kRoles) {
        const Eigen::Vector3f step = (next.position[role] - then.position[role]) -
                                     (now.position[role] - before.position[role]);
        EXPECT_LT(step.norm() / kStep_s, 0.25F) << clip << response << motion::name_of(role);
      }
      ++cases;
    }
  }
  EXPECT_EQ(cases, 30);
}

TEST(PushMotion, StandingFootStaysUntilTheResponseLiftsIt) {
  int standing = 0;
  for (std::size_t response = 0; response < scene().responses.responses.size(); ++response) {
    const PushMotion motion = pushed(shown("idle", 0.7F), response, {0.4F, 0.4F, 0}, 1, 0.3F);
    for (const Side side : motion::kSides) {
      const PushFoot& foot = motion.feet[side];
      ASSERT_TRUE(foot.stands);
      const Role ankle = motion::roles_of(side).foot;
      const Eigen::Vector3f first = joints(pose_at(motion, 0)).position[ankle];
      // The foot counts as lifted when it is 8 mm above the ground.
      const float lift_s = foot.fade.begin_s - 0.08F;
      for (float time_s = 0; time_s < std::min(lift_s, 0.8F); time_s += 0.02F) {
        const Eigen::Vector3f now = joints(pose_at(motion, time_s)).position[ankle];
        EXPECT_LT((now - first).norm(), 0.005F) << response << ' ' << time_s;
        ++standing;
      }
    }
  }
  EXPECT_GT(standing, 100);
}

/// The same as velocity_at_peak(), of the whole pose that is shown.
Eigen::Vector3f shown_velocity_at_peak(const PushMotion& motion) {
  const auto place_at = [&](float time_s) {
    return motion::forward_kinematics(scene().prepared.skeleton(), pose_at(motion, time_s))
        .position[motion.place];
  };
  const float from_s = std::max(motion.rise_s - kClipVelocityInterval_s / 2, 0.0F);
  const float to_s = std::min(motion.rise_s + kClipVelocityInterval_s / 2, motion.duration_s);
  return (place_at(to_s) - place_at(from_s)) / (to_s - from_s);
}

TEST(PushMotion, PushedJointReachesTheAskedVelocityAlsoFortyFiveDegreesOff) {
  for (std::size_t response = 0; response < scene().responses.responses.size(); ++response) {
    const Shown state = shown("idle", 0.7F);
    const Eigen::Quaternionf facing =
        motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::facing(state.now));
    for (const Role place : motion::kPushPlaces) {
      for (const float degrees : {-45.0F, 0.0F, 20.0F, 45.0F}) {
        const Eigen::Vector3f& own =
            scene().responses.responses[response].velocity[push_place_index(place)];
        const Eigen::Vector3f asked =
            motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::radians(degrees)) *
            Eigen::Vector3f(own.x(), own.y(), 0);
        const PushCandidate candidate =
            deformed_candidate(scene().responses, response, place, asked);
        EXPECT_LE(std::abs(candidate.turn), kMaxResponseTurn + 1e-6F);
        PushMotion motion =
            pushed(state, response, facing * candidate.deformation, 3, candidate.turn, place);
        const Eigen::Vector3f wanted = facing * asked;
        match_velocity(wanted, motion);
        const Eigen::Vector3f reached = velocity_at_peak(motion);
        EXPECT_LT((reached - wanted).head<2>().norm(), 0.02F * wanted.norm());
        EXPECT_LT((reached - shown_velocity_at_peak(motion)).head<2>().norm(), 1e-4F);
        EXPECT_TRUE(is_faithful(peak_velocity(motion, wanted), wanted))
            << response << motion::push_place_name(place) << degrees;
      }
    }
  }
}

TEST(PushMotion, EndsAsTheResponseDoes) {
  const std::size_t response = 1;
  const PushMotion motion = pushed(shown("idle", 0.7F), response, {0.3F, 0, 0});
  const motion::Clip& clip = scene().library.clip(motion.clip);
  const Pose last = motion::placed(clip.motion.poses.back(), motion.yaw, motion.translation);
  const Pose end = pose_at(motion, motion.duration_s);
  EXPECT_LT(tests::distance(end, last), 0.02F);
  EXPECT_EQ(tests::distance(pose_at(motion, motion.duration_s + 9), end), 0);
  EXPECT_TRUE(is_sound(end));
}

TEST(DeformationOffset, IsTheIntegralOfItsVelocity) {
  // By the definition in push_deformation.h: grows as 3 s^2 - 2 s^3, then follows equation 1.
  constexpr float kRise_s = 0.4F;
  double x = 0;
  double v = 0;
  constexpr double kH = 1e-5;
  for (int k = 1; k <= 150'000; ++k) {
    const double t = k * kH;
    if (t <= double{kRise_s}) {
      const double s = t / double{kRise_s};
      v = s * s * (3 - 2 * s);
    } else {
      v += kH * (-50 * x - 10 * v);
    }
    x += kH * v;
    if (k % 10'000 == 0) {
      EXPECT_NEAR(double{deformation_offset(kRise_s, static_cast<float>(t))}, x, 1e-4) << t;
    }
  }
  EXPECT_EQ(deformation_offset(kRise_s, 0), 0);
  EXPECT_EQ(deformation_offset(kRise_s, -1), 0);
  // The paper's impulse moves a joint by at most 0.064 m per m/s, after pi/20 s.
  EXPECT_NEAR(deformation_offset(0, 0.15708F), std::exp(-0.7854F) * std::sin(0.7854F) / 5, 1e-5F);
}

TEST(DeformationShares, DeclineWithTheSquareOfTheDistance) {
  const motion::JointFrames frames = joints(shown("idle", 0.7F).now);
  for (const float taper : {1.0F, 30.0F}) {
    const auto shares = deformation_shares({Role::left_upper_arm, taper, {}, 0}, frames);
    EXPECT_EQ(shares[Role::left_upper_arm], 1);
    for (const Role role : motion::kRoles) {
      const double d =
          double{(frames.position[role] - frames.position[Role::left_upper_arm]).norm()};
      EXPECT_NEAR(double{shares[role]}, std::exp(-double{taper} * d * d), 1e-5);
    }
  }
}

TEST(ShiftJoints, ReachesSmallShiftsAndKeepsHeadAndHandsUpright) {
  const motion::Skeleton& skeleton = scene().library.character.skeleton;
  Pose pose = shown("raise_hands", 0.4F).now;
  const motion::JointFrames frames = joints(pose);
  motion::PerRole<Eigen::Vector3f> shifts;
  for (Eigen::Vector3f& shift : shifts) shift = {0.05F, 0.02F, 0};
  shift_joints(skeleton, frames, shifts, pose);
  const motion::JointFrames all = joints(pose);
  for (const Role role : motion::kRoles)
    EXPECT_LT((all.position[role] - frames.position[role] - shifts[role]).norm(), 1e-4F);
  for (const Role role : {Role::head, Role::left_hand, Role::right_hand})
    EXPECT_LT(all.orientation[role].angularDistance(frames.orientation[role]), 1e-3F);
}

TEST(ShiftJoints, TheChestTurnsWithTheShouldersAndNothingAboveItDoes) {
  const motion::Skeleton& skeleton = scene().library.character.skeleton;
  Pose pose = shown("raise_hands", 0.4F).now;
  const motion::JointFrames frames = joints(pose);
  const auto& at = frames.position;
  const Eigen::Vector3f axis = (at[Role::neck] - at[Role::chest]).normalized();
  const Eigen::Vector3f across = at[Role::left_upper_arm] - at[Role::right_upper_arm];
  const Eigen::Vector3f forward = 0.06F * axis.cross(across).normalized();
  motion::PerRole<Eigen::Vector3f> shifts;
  for (Eigen::Vector3f& shift : shifts) shift.setZero();
  shifts[Role::left_upper_arm] = forward;
  shifts[Role::right_upper_arm] = -forward;
  shift_joints(skeleton, frames, shifts, pose);
  // The line of the shoulders, seen along the axis, has 0.12 m across it more.
  const float turned = std::atan2(0.12F, (across - axis.dot(across) * axis).norm());
  const motion::JointFrames all = joints(pose);
  const auto turn_of = [&](Role role) {
    return all.orientation[role].angularDistance(frames.orientation[role]);
  };
  EXPECT_GT(turned, 0.2F);
  EXPECT_NEAR(turn_of(Role::chest), turned, 1e-3F);
  for (const Role role : {Role::pelvis, Role::abdomen, Role::neck, Role::head})
    EXPECT_LT(turn_of(role), 1e-3F);
}

}  // namespace
}  // namespace flinch::runtime
