// SPDX-License-Identifier: MIT
#include "database/author/transition.h"

#include <algorithm>
#include <cmath>

#include "motion/body_distance.h"
#include "motion/interpolation.h"
#include "motion/joint_limits.h"
#include "motion/rotation.h"
#include "motion/support_polygon.h"

namespace flinch::database {
namespace {

using motion::clamp_arm_to_limits;
using motion::JointFrames;
using motion::LimbRoles;
using motion::Pose;
using motion::radians;
using motion::Role;
using motion::Side;
using motion::Skeleton;

// Body parts do not all start at once: the head leads, the hands follow.
constexpr float kHeadLead = 0.1F;
constexpr float kHandLag = 0.06F;

float eased_between(float s, float begin, float end) {
  return motion::ease_in_ease_out((s - begin) / (end - begin));
}

Eigen::Vector3f lerp(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float weight) {
  return a + weight * (b - a);
}

// The pole of both arms, from which swivels are interpolated: downwards and backwards from the
// chest, where no arm points.
Eigen::Vector3f arm_pole(const JointFrames& frames) {
  return frames.orientation[Role::chest] * Eigen::Vector3f(-1, 0, -1).normalized();
}

bool differ(const motion::FootPose& a, const motion::FootPose& b) {
  constexpr float kNear = 0.005F;  // m
  return (a.ankle - b.ankle).norm() > kNear ||
         a.orientation.angularDistance(b.orientation) > radians(1);
}

float lift_of(const FootStep& step) {
  const bool lands = std::abs(step.from.ankle.z() - step.to.ankle.z()) < 0.01F;
  const float length = (step.to.ankle - step.from.ankle).norm();
  return lands ? std::clamp(0.25F * length, 0.03F, 0.09F) : 0;
}

motion::PerSide<FootStep> steps_of(const JointFrames& from, const JointFrames& to,
                                   const Eigen::Vector3f& travel) {
  motion::PerSide<FootStep> steps;
  for (Side side : motion::kSides) {
    FootStep& step = steps[side];
    step.from = foot_pose(from, side);
    step.to = foot_pose(to, side);
    step.moves = differ(step.from, step.to);
    if (!step.moves) step.to = step.from;
    step.lift_m = step.moves ? lift_of(step) : 0;
    step.begin = 0.04F;
    step.end = 0.86F;
  }
  const FootStep& left = steps[Side::left];
  const FootStep& right = steps[Side::right];
  if (left.moves && right.moves) {
    const Side leading =
        (left.from.ankle - right.from.ankle).dot(travel) > 0 ? Side::left : Side::right;
    FootStep& first = steps[leading];
    FootStep& second = steps[other(leading)];
    first.begin = 0.02F;
    first.end = 0.5F;
    second.begin = 0.5F;
    second.end = 0.98F;
  }
  return steps;
}

std::optional<Side> support_of(const motion::PerSide<FootStep>& steps,
                               const Eigen::Vector3f& centre) {
  return motion::support_foot(
      centre, [&](Side side) { return !steps[side].moves; },
      [&](Side side) { return steps[side].from.ankle; });
}

motion::FootPose foot_pose_in_step(const FootStep& step, float s) {
  if (!step.moves) return step.from;
  const float u = std::clamp((s - step.begin) / (step.end - step.begin), 0.0F, 1.0F);
  // The foot is lifted before it travels, and has arrived before it is put down.
  constexpr float kOnlyLift = 0.1F;
  const float weight = eased_between(u, kOnlyLift, 1 - kOnlyLift);
  motion::FootPose place = blend(step.from, step.to, weight);
  // 16 u^2 (1-u)^2 has zero velocity at both ends, so the foot leaves and meets the ground
  // smoothly.
  place.ankle.z() += step.lift_m * 16 * u * u * (1 - u) * (1 - u);
  return place;
}

// Positions the pelvis so that the foot is at its place, given the rotations of the leg.
void hang_from_foot(const Skeleton& skeleton, Side side, const motion::FootPose& place,
                    Pose& pose) {
  const LimbRoles leg = motion::roles_of(leg_of(side));
  const Eigen::Quaternionf shin = place.orientation * pose.rotation[leg.end].conjugate();
  const Eigen::Quaternionf thigh = shin * pose.rotation[leg.lower].conjugate();
  const Eigen::Quaternionf pelvis = (thigh * pose.rotation[leg.upper].conjugate()).normalized();
  pose.rotation[Role::pelvis] = pelvis;
  pose.root_position = place.ankle - shin * skeleton.offset[leg.end] -
                       thigh * skeleton.offset[leg.lower] - pelvis * skeleton.offset[leg.upper];
}

void slerp_joint(const Transition& transition, Role role, float weight, Pose& pose) {
  pose.rotation[role] =
      motion::slerp(transition.from.rotation[role], transition.to.rotation[role], weight);
}

// First pass: every joint is interpolated by itself, relative to the support foot.
Pose first_pass(const motion::Figure& figure, const Transition& transition, float s) {
  const float weight = motion::ease_in_ease_out(s);
  Pose pose = motion::blend(transition.from, transition.to, weight);
  const float head_weight = eased_between(s, 0, 1 - kHeadLead);
  slerp_joint(transition, Role::neck, head_weight, pose);
  slerp_joint(transition, Role::head, head_weight, pose);
  const float hand_weight = eased_between(s, kHandLag, 1);
  for (Side side : motion::kSides) {
    const LimbRoles arm = motion::roles_of(arm_of(side));
    for (Role role : {arm.upper, arm.lower, arm.end}) {
      slerp_joint(transition, role, hand_weight, pose);
    }
  }
  if (transition.support) {
    const FootStep& step = transition.steps[*transition.support];
    hang_from_foot(figure.skeleton(), *transition.support, step.from, pose);
  }
  return pose;
}

motion::PerSide<motion::HandGoal> hands_at(const Transition& transition, const JointFrames& frames,
                                           float s) {
  const float weight = eased_between(s, kHandLag, 1);
  motion::PerSide<motion::HandGoal> hands;
  for (Side side : motion::kSides) {
    const Role hand = motion::roles_of(arm_of(side)).end;
    const float turn =
        motion::wrapped_to_pi(transition.to_swivel[side] - transition.from_swivel[side]);
    hands[side] = {
        lerp(transition.from_frames.position[hand], transition.to_frames.position[hand], weight),
        arm_pole(frames), transition.from_swivel[side] + weight * turn};
  }
  return hands;
}

// Returns which hands, moved on straight lines, would come too close to head or trunk, or so close
// to the shoulder that the arm would have to fold. The end poses themselves are not tested.
motion::PerSide<bool> blocked_hands(const motion::Figure& figure, const Transition& transition) {
  constexpr float kNearBody = 0.015F;
  constexpr float kNearShoulder = 0.4F;  // of the arm's length
  constexpr int kSamples = 12;
  motion::PerSide<bool> blocked{};
  for (int k = 2; k < kSamples - 1; ++k) {
    const JointFrames frames = motion::forward_kinematics(
        figure.skeleton(),
        pose_at(figure, transition, static_cast<float>(k) / static_cast<float>(kSamples)));
    for (Side side : motion::kSides) {
      bool& is_blocked = blocked[side];
      const LimbRoles arm = motion::roles_of(arm_of(side));
      const float reach = (frames.position[arm.end] - frames.position[arm.upper]).norm();
      is_blocked = is_blocked ||
                   reach < kNearShoulder * motion::limb_length(figure.skeleton(), arm_of(side));
      const motion::Capsule hand = capsule_of(figure, frames, motion::body_of(arm.end));
      for (motion::Body body : motion::kCoreBodies) {
        is_blocked = is_blocked || distance_between(figure, frames, body, hand) < kNearBody;
      }
    }
  }
  return blocked;
}

}  // namespace

Transition make_transition(const motion::Figure& figure, const Pose& from, const Pose& to) {
  const Skeleton& skeleton = figure.skeleton();
  Transition transition;
  transition.from = from;
  transition.to = to;
  transition.from_frames = motion::forward_kinematics(skeleton, from);
  transition.to_frames = motion::forward_kinematics(skeleton, to);
  transition.from_centre = motion::centre_of_mass(figure.bodies, transition.from_frames);
  transition.to_centre = motion::centre_of_mass(figure.bodies, transition.to_frames);
  transition.steps = steps_of(transition.from_frames, transition.to_frames,
                              transition.to_centre - transition.from_centre);
  transition.support = support_of(transition.steps, transition.from_centre);
  for (Side side : motion::kSides) {
    transition.from_swivel[side] =
        swivel_of(transition.from_frames, side, arm_pole(transition.from_frames));
    transition.to_swivel[side] =
        swivel_of(transition.to_frames, side, arm_pole(transition.to_frames));
  }
  transition.hand_swings = blocked_hands(figure, transition);
  return transition;
}

// Second pass. Pelvis and waist are corrected in turn: moving the pelvis by the error of the centre
// of mass puts it above its line; raising it by the neck's error and bending the waist puts the
// neck on its own. A few rounds bring all three to well below a millimetre.
Pose pose_at(const motion::Figure& figure, const Transition& transition, float s) {
  constexpr int kRounds = 6;
  const Skeleton& skeleton = figure.skeleton();
  const float part = std::clamp(s, 0.0F, 1.0F);
  const float weight = motion::ease_in_ease_out(part);
  const motion::PerSide<motion::FootPose> feet{
      foot_pose_in_step(transition.steps[Side::left], part),
      foot_pose_in_step(transition.steps[Side::right], part)};
  const Eigen::Vector3f centre = lerp(transition.from_centre, transition.to_centre, weight);
  const Eigen::Vector3f neck = lerp(transition.from_frames.position[Role::neck],
                                    transition.to_frames.position[Role::neck], weight);
  Pose pose = first_pass(figure, transition, part);
  for (int round = 0; round < kRounds; ++round) {
    JointFrames trunk = motion::forward_kinematics(skeleton, pose);
    const float lower =
        std::min(max_pelvis_height(skeleton, trunk, feet) - pose.root_position.z(), 0.0F);
    pose.root_position.z() += lower;
    for (Eigen::Vector3f& position : trunk.position) position.z() += lower;
    solve_legs(skeleton, trunk, feet, pose);
    const motion::PerSide<motion::HandGoal> hands = hands_at(transition, trunk, part);
    for (Side side : motion::kSides) {
      if (!transition.hand_swings[side]) solve_arm(skeleton, trunk, side, hands[side], pose);
      clamp_arm_to_limits(pose, side);
    }
    if (round + 1 == kRounds) break;
    const JointFrames frames = motion::forward_kinematics(skeleton, pose);
    const Eigen::Vector3f error = centre - motion::centre_of_mass(figure.bodies, frames);
    const Eigen::Vector3f rise(0, 0, neck.z() - frames.position[Role::neck].z());
    const Eigen::Vector3f move = Eigen::Vector3f(error.x(), error.y(), 0) + rise;
    pose.root_position += move;
    const Eigen::Vector3f waist = frames.position[Role::abdomen] + move;
    const Eigen::Quaternionf swing =
        motion::rotation_between<float>(frames.position[Role::neck] + move - waist, neck - waist);
    pose.rotation[Role::abdomen] =
        (pose.rotation[Role::pelvis].conjugate() * swing * frames.orientation[Role::abdomen])
            .normalized();
  }
  return pose;
}

}  // namespace flinch::database
