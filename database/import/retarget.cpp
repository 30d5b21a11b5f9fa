// SPDX-License-Identifier: MIT
#include "database/import/retarget.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "database/import/ankle_goals.h"
#include "database/import/trunk_fit.h"
#include "motion/error.h"
#include "motion/interpolation.h"
#include "motion/limb_ik.h"
#include "motion/rotation.h"
#include "motion/support_polygon.h"

namespace flinch::database {
namespace {

using Eigen::Quaternionf;
using Eigen::Vector3f;
using motion::JointFrames;
using motion::kRoles;
using motion::Limb;
using motion::Pose;
using motion::Role;
using motion::Skeleton;

struct Leg {
  Limb limb;
  Role thigh, foot, toes;
  motion::Side side;
};
constexpr std::array<Leg, 2> kLegs{
    {{Limb::left_leg, Role::left_thigh, Role::left_foot, Role::left_toes, motion::Side::left},
     {Limb::right_leg, Role::right_thigh, Role::right_foot, Role::right_toes,
      motion::Side::right}}};

// Everything that is constant over the frames.
struct RetargetContext {
  const SourceMotion& source;
  const Skeleton& skeleton;
  float scale;
  TrunkFit trunk;
  JointFrames rest;
  motion::PerSide<motion::SoleOutline> sole;
};

RetargetContext make_retarget_context(const SourceMotion& source, const Skeleton& skeleton) {
  return {source,
          skeleton,
          leg_ratio(source, skeleton),
          TrunkFit(source, skeleton),
          forward_kinematics(skeleton, motion::rest_pose(skeleton)),
          motion::sole_outlines(skeleton)};
}

Vector3f between_hips(const Skeleton& skeleton) {
  return 0.5F * (skeleton.offset[Role::left_thigh] + skeleton.offset[Role::right_thigh]);
}

// Heights above a planted ankle are scaled; the planted ankle's own height is the skeleton's.
float planted_ankle_height(const SourceMotion& source) {
  return 0.5F * (source.ankle_height_m[0] + source.ankle_height_m[1]);
}

Pose transferred(const RetargetContext& context, const SourceFrame& frame) {
  JointFrames frames;
  frames.orientation = frame.orientation;
  context.trunk.bend(frame, frames.orientation);
  Vector3f hips = context.scale * frame.hip_centre;
  hips.z() = context.scale * (frame.hip_centre.z() - planted_ankle_height(context.source)) +
             context.rest.position[Role::left_foot].z();
  frames.position[Role::pelvis] =
      hips - frame.orientation[Role::pelvis] * between_hips(context.skeleton);
  return motion::pose_from_frames(frames);
}

// Returns by how much the pelvis must be lowered for a leg to reach, m. A hip at horizontal
// distance d from the ankle can be at most sqrt(L^2 - d^2) above it.
float sinking_needed(const RetargetContext& context, const Vector3f& hip, const Vector3f& ankle,
                     Limb leg) {
  constexpr float kNearlyStraight = 0.99998F;  // of the leg's length; within the hinge's limit
  const float reach = kNearlyStraight * motion::limb_length(context.skeleton, leg);
  const float across = (ankle - hip).head<2>().norm();
  if (across >= reach) return 0;  // lowering does not help
  return std::max(0.0F, hip.z() - motion::max_upper_height(hip, ankle, reach));
}

// Returns by how much the pelvis must be raised for a leg that cannot fold further, m. A hip at
// horizontal distance d from the ankle must be at least sqrt(l^2 - d^2) above it.
float raising_needed(const RetargetContext& context, const Vector3f& hip, const Vector3f& ankle,
                     Limb leg) {
  const float folded = motion::folded_limb_length(context.skeleton, leg);
  if ((ankle - hip).head<2>().norm() >= folded) return 0;
  return std::max(0.0F, motion::max_upper_height(hip, ankle, folded) - hip.z());
}

// 1 while a foot is down, falling smoothly to 0 while it is lifted: only supporting feet lower the
// pelvis.
float groundedness(const RetargetContext& context, const Vector3f& ankle, std::size_t side) {
  constexpr float kDown = 0.05F;  // m above the planted height
  constexpr float kUp = 0.20F;
  const float lift = ankle.z() - context.rest.position[kLegs[side].foot].z();
  return 1 - motion::ease_in_ease_out((lift - kDown) / (kUp - kDown));
}

// Returns the largest change of the pelvis' height that a leg needs whose foot is down.
template <class Needed>
float most_needed(const RetargetContext& context, const AnkleGoals& goals, const Pose& pose,
                  Needed needed) {
  const JointFrames frames = forward_kinematics(context.skeleton, pose);
  float most = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    const Leg& leg = kLegs[side];
    most = std::max(most, groundedness(context, goals[side], side) *
                              needed(context, frames.position[leg.thigh], goals[side], leg.limb));
  }
  return most;
}

// Lowers the pelvis where a leg is too short and raises it where one cannot fold enough, so that
// feet that are down keep their places.
void fit_pelvis_height(const RetargetContext& context, const AnkleGoals& goals, Pose& pose) {
  pose.root_position.z() -= most_needed(context, goals, pose, sinking_needed);
  pose.root_position.z() += most_needed(context, goals, pose, raising_needed);
}

// Bends toes up, about the foot's lateral axis, where they would be below the ground: as far as
// needed, or where that is not enough as far as it raises them noticeably.
void keep_toes_up(const RetargetContext& context, std::size_t side, Pose& pose) {
  constexpr float kMaxBend = 1.5F;   // radians
  constexpr float kMinGain = 0.02F;  // m/rad
  constexpr int kThirds = 20;        // of the range of angles: to less than 0.1 degrees
  constexpr int kHalvings = 12;
  const Leg& leg = kLegs[side];
  const JointFrames frames = forward_kinematics(context.skeleton, pose);
  const auto lowest = [&](float bend) {
    const Quaternionf bent =
        frames.orientation[leg.toes] * motion::rotation_about(Vector3f::UnitY(), -bend);
    return frames.position[leg.toes].z() + motion::min_height(context.sole[leg.side].toes, bent);
  };
  constexpr float kTouches = -1e-4F;  // m: flat feet are this near to the ground
  if (lowest(0) >= kTouches) return;
  float least = 0;
  float most = kMaxBend;
  for (int i = 0; i < kThirds; ++i) {
    const float third = (most - least) / 3;
    if (lowest(least + third) + kMinGain * third < lowest(most - third)) {
      least += third;
    } else {
      most -= third;
    }
  }
  if (lowest(most) > 0) {
    least = 0;
    for (int i = 0; i < kHalvings; ++i) {
      const float middle = 0.5F * (least + most);
      (lowest(middle) < 0 ? least : most) = middle;
    }
  }
  const Quaternionf bend = motion::rotation_about(Vector3f::UnitY(), -most);
  pose.rotation[leg.toes] = (pose.rotation[leg.toes] * bend).normalized();
}

// In a nearly straight leg, bow legs and noise determine the direction of the knee. There the knee
// bends by the same angle but about the hinge; the transition is smooth.
void straighten_bow_leg(Limb limb, Pose& pose) {
  constexpr float kStraight = 0.17F;  // radians, 10 degrees
  constexpr float kBent = 0.52F;      // 30 degrees
  Quaternionf& knee = pose.rotation[motion::roles_of(limb).lower];
  const float bend = std::acos(std::clamp((knee * Vector3f::UnitZ()).z(), -1.0F, 1.0F));
  const Quaternionf about_hinge(Eigen::AngleAxisf(bend, motion::hinge_axis(limb)));
  const float weight = motion::ease_in_ease_out((bend - kStraight) / (kBent - kStraight));
  knee = motion::slerp(about_hinge, knee, weight);
}

Pose retargeted(const RetargetContext& context, const SourceFrame& frame, const AnkleGoals& goals) {
  Pose pose = transferred(context, frame);
  for (const Leg& leg : kLegs) straighten_bow_leg(leg.limb, pose);
  fit_pelvis_height(context, goals, pose);
  for (std::size_t side = 0; side < 2; ++side) {
    const Leg& leg = kLegs[side];
    pose = motion::with_limb_end(context.skeleton, pose, leg.limb, goals[side],
                                 frame.orientation[leg.foot]);
    keep_toes_up(context, side, pose);
  }
  // The hands keep their positions; rotations of the elbows other than bending move to shoulder and
  // wrist.
  const JointFrames frames = forward_kinematics(context.skeleton, pose);
  for (Limb arm : {Limb::left_arm, Limb::right_arm}) {
    const Role hand = motion::roles_of(arm).end;
    pose = motion::with_limb_end(context.skeleton, pose, arm, frames.position[hand],
                                 frames.orientation[hand]);
  }
  return pose;
}

// q and -q are the same rotation: selects the one nearer to the previous frame.
void make_continuous(motion::Motion& motion) {
  for (std::size_t k = 1; k < motion.poses.size(); ++k) {
    for (Role role : kRoles) {
      Quaternionf& rotation = motion.poses[k].rotation[role];
      if (rotation.dot(motion.poses[k - 1].rotation[role]) < 0) rotation.coeffs() *= -1;
    }
  }
}

// Yaw of the horizontal normal to the line from the right hip to the left one.
float pelvis_facing(const SourceFrame& frame) {
  const Vector3f left = frame.orientation[Role::pelvis] * Vector3f::UnitY();
  return std::atan2(-left.x(), left.y());
}

}  // namespace

float leg_ratio(const SourceMotion& source, const Skeleton& skeleton) {
  return motion::limb_length(skeleton, kLegs[0].limb) / source.leg_length_m;
}

SourceFrame sample(const SourceMotion& source, double time_s) {
  const double last = static_cast<double>(source.frames.size() - 1);
  const double position = std::clamp(time_s / source.frame_time_s, 0.0, last);
  const auto index = static_cast<std::size_t>(position);
  const auto weight = static_cast<float>(position - static_cast<double>(index));
  if (weight == 0) return source.frames[index];
  const SourceFrame& from = source.frames[index];
  const SourceFrame& to = source.frames[index + 1];
  const auto mixed = [weight](const Vector3f& one, const Vector3f& other) -> Vector3f {
    return (1 - weight) * one + weight * other;
  };
  SourceFrame frame;
  for (Role role : kRoles) {
    frame.orientation[role] = motion::slerp(from.orientation[role], to.orientation[role], weight);
  }
  frame.hip_centre = mixed(from.hip_centre, to.hip_centre);
  for (auto point :
       {&SourceTrunk::abdomen, &SourceTrunk::chest, &SourceTrunk::shoulders,
        &SourceTrunk::left_shoulder, &SourceTrunk::right_shoulder, &SourceTrunk::head}) {
    frame.trunk.*point = mixed(from.trunk.*point, to.trunk.*point);
  }
  for (std::size_t side = 0; side < 2; ++side) {
    frame.foot[side].ankle = mixed(from.foot[side].ankle, to.foot[side].ankle);
    frame.foot[side].ball = mixed(from.foot[side].ball, to.foot[side].ball);
  }
  return frame;
}

Placement placement_of(const SourceMotion& source, const Skeleton& skeleton,
                       const Segment& segment) {
  const SourceFrame first = sample(source, segment.start_s);
  const Pose pose = transferred(make_retarget_context(source, skeleton), first);
  Placement placement;
  placement.yaw = -(pelvis_facing(first) + static_cast<float>(segment.heading));
  Vector3f start = pose.root_position;
  start.z() = 0;
  placement.shift = -(Eigen::AngleAxisf(placement.yaw, Vector3f::UnitZ()) * start);
  return placement;
}

void check_frame_count(const std::string& where, const Segment& segment, float rate_hz) {
  const double duration_s = segment.end_s - segment.start_s;
  if (std::round(duration_s * static_cast<double>(rate_hz)) + 1 <= kMaxFrames) return;
  char text[96];
  std::snprintf(text, sizeof text, "lasts %.6g s, which is more than %d frames at %g Hz",
                duration_s, kMaxFrames, static_cast<double>(rate_hz));
  throw Error(where, std::string(text) +
                         "; name a shorter part, or give the file's real frame rate with "
                         "--rate-of-file, or rate_of_file in a manifest");
}

motion::Motion retarget(const SourceMotion& source, const Skeleton& skeleton,
                        const Segment& segment, float rate_hz) {
  const RetargetContext context = make_retarget_context(source, skeleton);
  const Placement placement = placement_of(source, skeleton, segment);
  const auto intervals = static_cast<std::size_t>(
      std::lround((segment.end_s - segment.start_s) * static_cast<double>(rate_hz)));
  std::vector<SourceFrame> frames;
  for (std::size_t k = 0; k <= intervals; ++k) {
    const double time_s = segment.start_s + static_cast<double>(k) / static_cast<double>(rate_hz);
    frames.push_back(sample(source, std::min(time_s, segment.end_s)));
  }
  const std::vector<AnkleGoals> goals =
      compute_ankle_goals(source, skeleton, frames, 1 / rate_hz, context.scale);
  motion::Motion motion;
  motion.rate_hz = rate_hz;
  for (std::size_t k = 0; k <= intervals; ++k) {
    const Pose pose = retargeted(context, frames[k], goals[k]);
    motion.poses.push_back(motion::placed(pose, placement.yaw, placement.shift));
  }
  make_continuous(motion);
  return motion;
}

}  // namespace flinch::database
