// SPDX-License-Identifier: MIT
#include "runtime/push/push_motion.h"

#include <algorithm>
#include <array>

#include "motion/interpolation.h"
#include "motion/limb_ik.h"
#include "motion/offset_spring.h"
#include "motion/push_measurement.h"
#include "motion/rotation.h"
#include "runtime/push/push_deformation.h"
#include "runtime/push/push_responses.h"

namespace flinch::runtime {
namespace {

using motion::FootPose;
using motion::Pose;
using motion::Role;
using motion::Side;

constexpr float kStandingHeight_m = 0.02F;      // of a sole on a game's ground
constexpr float kMaxStandingSpeed_mps = 0.25F;  // of a foot that only rolls
constexpr float kShortestFade_s = 0.25F;
constexpr float kReachShare = 0.9995F;  // of a leg: nearly straight

constexpr std::array kLegs{Role::pelvis,      Role::left_thigh, Role::left_shin, Role::left_foot,
                           Role::right_thigh, Role::right_shin, Role::right_foot};

Pose clip_pose(const PushMotion& motion, float time_s,
               std::span<const Role> roles = motion::kRoles) {
  return motion::placed(
      motion::sample(motion.library->clip(motion.clip).motion, motion.contact_s + time_s, roles),
      motion.yaw, motion.translation);
}

Eigen::Vector3f rotation_from(const Eigen::Quaternionf& from, const Eigen::Quaternionf& to) {
  return motion::rotation_vector<float>(to * from.conjugate());
}

// Vectors of almost half a turn may change sides between two poses: that is no velocity.
Eigen::Vector3f turn_velocity(const Eigen::Vector3f& now, const Eigen::Vector3f& before,
                              float dt_s) {
  const Eigen::Vector3f change = now - before;
  return change.norm() < std::numbers::pi_v<float> ? Eigen::Vector3f(change / dt_s)
                                                   : Eigen::Vector3f::Zero();
}

/// A pose, the one before it and the time between them.
struct Moving {
  Pose before;
  Pose now;
  float dt_s;
};

/// When the response lifts this foot and sets it down, s after the push; infinite where it never
/// does. A foot that is in the air at the push lifts at 0.
Interval first_swing(const PushMotion& motion, Side side) {
  const Footwork& footwork = motion.library->footwork[static_cast<std::size_t>(motion.clip)];
  for (const Swing& swing : footwork.swings[side]) {
    if (swing.end_s <= motion.contact_s) continue;
    return {std::max(swing.begin_s - motion.contact_s, 0.0F), swing.end_s - motion.contact_s};
  }
  return {};
}

PushFoot make_foot(const PushMotion& motion, const Moving& shown, const Moving& clip, Side side) {
  const PreparedLibrary& library = *motion.library;
  const motion::Skeleton& skeleton = library.skeleton();
  const motion::JointFrames frames = motion::forward_kinematics(skeleton, shown.now);
  const FootPose now = motion::foot_pose(frames, side);
  const FootPose before = foot_of(skeleton, shown.before, side);
  const FootPose clip_now = foot_of(skeleton, clip.now, side);
  const FootPose clip_before = foot_of(skeleton, clip.before, side);
  PushFoot foot;
  foot.offset = now.ankle - clip_now.ankle;
  const motion::Limb leg = motion::leg_of(side);
  foot.reach_m = std::max(kReachShare * motion::limb_length(skeleton, leg),
                          (now.ankle - frames.position[motion::roles_of(leg).upper]).norm());
  const bool is_down = min_height(library.soles[side], frames, side) < kStandingHeight_m &&
                       (now.ankle - before.ankle).norm() < kMaxStandingSpeed_mps * shown.dt_s;
  const Interval swing = first_swing(motion, side);
  foot.stands = is_down && swing.begin_s > 0;
  if (foot.stands) {
    const Eigen::Quaternionf turn = now.orientation * clip_now.orientation.conjugate();
    const auto [tilt, about_vertical] =
        motion::decompose_swing_twist<float>(turn, Eigen::Vector3f::UnitZ());
    foot.yaw = motion::rotation_vector(about_vertical).z();
    foot.turn = motion::rotation_vector(tilt);
    foot.pivot = clip_now.ankle;
    foot.fade = swing;
    return foot;
  }
  foot.turn = rotation_from(clip_now.orientation, now.orientation);
  foot.offset_velocity = (foot.offset - (before.ankle - clip_before.ankle)) / shown.dt_s;
  foot.turn_velocity = turn_velocity(
      foot.turn, rotation_from(clip_before.orientation, before.orientation), shown.dt_s);
  foot.fade = {0, swing.begin_s > 0 ? kShortestFade_s : std::max(swing.end_s, kShortestFade_s)};
  return foot;
}

FootPose foot_at(const PushFoot& foot, const FootPose& clip, float time_s) {
  if (time_s >= foot.fade.end_s) return clip;
  const float weight = time_s <= foot.fade.begin_s
                           ? 1
                           : 1 - motion::minimum_jerk((time_s - foot.fade.begin_s) /
                                                      (foot.fade.end_s - foot.fade.begin_s));
  const motion::OffsetSpring spring = motion::offset_spring(time_s);
  const auto left = [&](const Eigen::Vector3f& x, const Eigen::Vector3f& v) -> Eigen::Vector3f {
    return weight * (spring.position * x + spring.velocity * v);
  };
  const Eigen::Quaternionf turn =
      motion::rotation_from_vector<float>(left(foot.turn, foot.turn_velocity));
  if (!foot.stands) {
    return {clip.ankle + left(foot.offset, foot.offset_velocity), turn * clip.orientation};
  }
  const Eigen::Quaternionf yaw =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), weight * foot.yaw);
  const Eigen::Vector3f shift(foot.offset.x(), foot.offset.y(), spring.position * foot.offset.z());
  return {foot.pivot + yaw * (clip.ankle - foot.pivot) + weight * shift,
          turn * yaw * clip.orientation};
}

/// The response with what is left of the character's difference.
Pose transition_pose(const PushMotion& motion, const Pose& clip, float time_s,
                     std::span<const Role> roles = motion::kRoles) {
  const motion::OffsetSpring spring = motion::offset_spring(time_s);
  Pose pose = clip;
  pose.root_position += spring.position * motion.root + spring.velocity * motion.root_velocity;
  for (const Role role : roles) {
    const Eigen::Vector3f turn =
        spring.position * motion.rotation[role] + spring.velocity * motion.rotation_velocity[role];
    pose.rotation[role] =
        (motion::rotation_from_vector<float>(turn) * clip.rotation[role]).normalized();
  }
  return pose;
}

/// Lowers the pelvis until both legs reach, and puts the feet where they should be.
void place_feet(const PushMotion& motion, const motion::PerSide<FootPose>& feet, Pose& pose) {
  const motion::Skeleton& skeleton = motion.library->skeleton();
  motion::JointFrames frames = motion::forward_kinematics(skeleton, pose, kLegs);
  float drop_m = 0;
  for (const Side side : motion::kSides) {
    const Eigen::Vector3f& hip = frames.position[motion::roles_of(motion::leg_of(side)).upper];
    const float height = motion::max_upper_height(hip, feet[side].ankle, motion.feet[side].reach_m);
    drop_m = std::max(drop_m, hip.z() - height);
  }
  pose.root_position.z() -= drop_m;
  for (const Role role : kLegs) frames.position[role].z() -= drop_m;
  for (const Side side : motion::kSides) {
    motion::move_limb_end(frames, motion::leg_of(side), feet[side].ankle, feet[side].orientation,
                          pose);
  }
}

motion::PerRole<Eigen::Vector3f> shifts_at(const PushMotion& motion, float time_s) {
  const Eigen::Vector3f offset = deformation_offset(motion.rise_s, time_s) * motion.deformation;
  motion::PerRole<Eigen::Vector3f> shifts;
  for (const Role role : motion::kRoles) shifts[role] = motion.share[role] * offset;
  return shifts;
}

/// Where the pushed joint is, but for its height: the pelvis is not lowered to where legs reach.
Eigen::Vector3f pushed_joint(const PushMotion& motion, float time_s) {
  const motion::Skeleton& skeleton = motion.library->skeleton();
  const float time = std::min(time_s, motion.duration_s);
  Pose pose = transition_pose(motion, clip_pose(motion, time, kTrunkRoles), time, kTrunkRoles);
  shift_trunk(skeleton, motion::forward_kinematics(skeleton, pose, kTrunkRoles),
              shifts_at(motion, time), pose);
  return motion::forward_kinematics(skeleton, pose, kTrunkRoles).position[motion.place];
}

/// Lays the clip so that at contact it faces `facing` where the character is, and measures what the
/// character differs by.
void begin_clip(float facing, float clip_facing, const Moving& shown, PushMotion& motion) {
  const Eigen::Vector3f& now = shown.now.root_position;
  motion.yaw = facing - clip_facing;
  const Eigen::Vector3f turned =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), motion.yaw) *
      motion::sample(motion.library->clip(motion.clip).motion, motion.contact_s).root_position;
  motion.translation = {now.x() - turned.x(), now.y() - turned.y(), 0};

  const float dt_s = shown.dt_s;
  const Moving clip{clip_pose(motion, -dt_s), clip_pose(motion, 0), dt_s};
  motion.root = now - clip.now.root_position;
  motion.root_velocity =
      (motion.root - (shown.before.root_position - clip.before.root_position)) / dt_s;
  for (const Role role : motion::kRoles) {
    motion.rotation[role] = rotation_from(clip.now.rotation[role], shown.now.rotation[role]);
    motion.rotation_velocity[role] =
        turn_velocity(motion.rotation[role],
                      rotation_from(clip.before.rotation[role], shown.before.rotation[role]), dt_s);
  }
  for (const Side side : motion::kSides) motion.feet[side] = make_foot(motion, shown, clip, side);
}

}  // namespace

PushMotion make_push_motion(const PushResponses& responses, std::size_t response, float turn,
                            const PushDeformation& deformation, const Pose& before, const Pose& now,
                            float dt_s) noexcept {
  const PushResponse& recorded = responses.responses[response];
  PushMotion motion;
  motion.library = responses.library;
  motion.clip = recorded.clip;
  motion.contact_s = recorded.contact_s;
  motion.duration_s = recorded.duration_s;
  begin_clip(motion::facing(now) + turn, recorded.facing, {before, now, dt_s}, motion);
  motion.rise_s = deformation.rise_s;
  motion.place = deformation.place;
  motion.deformation = deformation.velocity;
  motion.share = deformation_shares(deformation,
                                    motion::forward_kinematics(responses.library->skeleton(), now));
  return motion;
}

PushMotion make_transition(const PreparedLibrary& library, int clip, float time_s,
                           const Pose& before, const Pose& now, float dt_s) noexcept {
  const motion::Motion& clip_motion = library.clip(clip).motion;
  PushMotion motion;
  motion.library = &library;
  motion.clip = clip;
  motion.contact_s = time_s;
  motion.duration_s = clip_motion.duration_s() - time_s;
  begin_clip(motion::facing(now), motion::facing(motion::sample(clip_motion, time_s)),
             {before, now, dt_s}, motion);
  return motion;
}

Pose pose_at(const PushMotion& motion, float time_s) noexcept {
  const motion::Skeleton& skeleton = motion.library->skeleton();
  const float time = std::min(time_s, motion.duration_s);
  const Pose clip = clip_pose(motion, time);
  Pose pose = transition_pose(motion, clip, time);
  shift_joints(skeleton, motion::forward_kinematics(skeleton, pose), shifts_at(motion, time), pose);
  motion::PerSide<FootPose> feet;
  for (const Side side : motion::kSides)
    feet[side] = foot_at(motion.feet[side], foot_of(skeleton, clip, side), time);
  place_feet(motion, feet, pose);
  return pose;
}

Eigen::Vector3f velocity_at_peak(const PushMotion& motion) noexcept {
  const float from_s = std::max(motion.rise_s - kClipVelocityInterval_s / 2, 0.0F);
  const float to_s = std::min(motion.rise_s + kClipVelocityInterval_s / 2, motion.duration_s);
  Eigen::Vector3f velocity =
      (pushed_joint(motion, to_s) - pushed_joint(motion, from_s)) / (to_s - from_s);
  velocity.z() = 0;
  return velocity;
}

Eigen::Vector3f peak_velocity(const PushMotion& motion, const Eigen::Vector3f& wanted) noexcept {
  constexpr std::size_t kSteps = 4;  // of which the interval of the velocity consists
  constexpr float kStep_s = kClipVelocityInterval_s / kSteps;
  Eigen::Vector3f fastest = Eigen::Vector3f::Zero();
  std::array<Eigen::Vector3f, kSteps> last;  // places of the joint, in a ring
  std::size_t k = 0;
  for (float time_s = 0; time_s <= motion::kMaxPushRise_s;
       time_s = static_cast<float>(k) * kStep_s) {
    const Eigen::Vector3f now = pushed_joint(motion, time_s);
    Eigen::Vector3f& before = last[k % kSteps];
    if (k >= kSteps) {
      Eigen::Vector3f velocity = (now - before) / kClipVelocityInterval_s;
      velocity.z() = 0;
      if (velocity.dot(wanted) > fastest.dot(wanted)) fastest = velocity;
    }
    before = now;
    ++k;
  }
  return fastest;
}

bool is_faithful(const Eigen::Vector3f& reached, const Eigen::Vector3f& wanted) noexcept {
  constexpr float kMaxError = 0.1F;
  constexpr float kLeastCosine = 0.9659258F;  // of 15 degrees
  const Eigen::Vector2f level = reached.head<2>();
  const Eigen::Vector2f asked = wanted.head<2>();
  return std::abs(level.norm() - asked.norm()) <= kMaxError * asked.norm() &&
         level.dot(asked) >= kLeastCosine * level.norm() * asked.norm();
}

void match_velocity(const Eigen::Vector3f& wanted, PushMotion& motion) noexcept {
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Vector3f missing = wanted - velocity_at_peak(motion);
    if (missing.norm() < 0.01F * wanted.norm()) return;
    motion.deformation += missing;
  }
}

}  // namespace flinch::runtime
