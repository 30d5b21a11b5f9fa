// SPDX-License-Identifier: MIT
#include "database/rules/pose_rules.h"

#include <algorithm>
#include <cmath>

#include "motion/body_distance.h"
#include "motion/interpolation.h"
#include "motion/joint_limits.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

using motion::clamp_arm_to_limits;
using motion::clamp_to_limits;
using motion::degrees;
using motion::joint_limits_named;
using motion::JointFrames;
using motion::JointLimits;
using motion::limit_excess;
using motion::Pose;
using motion::radians;
using motion::Role;
using motion::rotation_about;
using motion::Side;

// Table 3.2, degrees. The thesis' neck is one joint: here neck and head share it evenly.
struct MaxAngles {
  float x, y, z;
};
constexpr MaxAngles kNeck{50, 50, 65};
constexpr MaxAngles kBack{25, 25, 8};
constexpr MaxAngles kWaist{10, 10, 12};
constexpr MaxAngles kPelvis{15, 15, 20};
constexpr float kClavicleX = 35;
constexpr float kClavicleY = 25;
constexpr float kShoulderX = 30;
constexpr float kElbowY = 150;

constexpr float kReferenceStature = 1.75F;  // m, of the figure that lengths are given for
struct Reach {
  float farthest, nearest;  // m
};
constexpr Reach kHeadReach{0.9F, 0.3F};
constexpr Reach kPelvisReach{0.5F, 0.4F};
constexpr float kMaxSwivel = 70;
constexpr float kMinSwivel = 10;

void turn_joint(Pose& pose, Role role, const Eigen::Quaternionf& turn) {
  pose.rotation[role] = (pose.rotation[role] * turn).normalized();
}

void turn_neck(Pose& pose, const Eigen::Vector3f& axis, float angle) {
  turn_joint(pose, Role::neck, rotation_about(axis, angle / 2));
  turn_joint(pose, Role::head, rotation_about(axis, angle / 2));
}

// Limits neck and head to the human range, which table 3.2 exceeds by 5 degrees sideways.
void limit_neck(Pose& pose) {
  const JointLimits& limits = joint_limits_named("neck");
  const Eigen::Quaternionf head = pose.rotation[Role::neck] * pose.rotation[Role::head];
  if (limit_excess(limits, head) <= 0) return;
  pose.rotation[Role::head] =
      (pose.rotation[Role::neck].conjugate() * clamp_to_limits(limits, head)).normalized();
}

// Targets of the hands in `block`.
struct Guard {
  motion::PerSide<Eigen::Vector3f> palm;    // world, m
  motion::PerSide<Eigen::Vector3f> pole;    // of the elbow
  motion::PerSide<float> swivel{};          // radians
  motion::PerSide<Eigen::Vector3f> facing;  // normal of the palm
  Eigen::Vector3f fingers;                  // preferred direction of the fingers
};

// Returns the point of the line p + s u, s >= min_s, at distance `reach` from the shoulder; the
// nearest point if there is none.
Eigen::Vector3f point_at_reach(const Eigen::Vector3f& on_line, const Eigen::Vector3f& direction,
                               const Eigen::Vector3f& shoulder, float reach, float min_s) {
  const Eigen::Vector3f to_line = on_line - shoulder;
  const float along = to_line.dot(direction);
  const float squared = along * along - to_line.squaredNorm() + reach * reach;
  const float s = -along + std::sqrt(std::max(squared, 0.0F));
  return on_line + std::max(s, min_s) * direction;
}

float hand_length(const motion::Figure& figure) {
  return figure.skeleton().tip[Role::left_hand].norm();
}

float scale_of(const motion::Figure& figure) {
  return stature(figure.skeleton()) / kReferenceStature;
}

// Limited to a straight arm, beyond which the control would have no effect.
float farthest_reach(const motion::Figure& figure, const TargetWeights& weights) {
  const float straight = 0.98F * motion::limb_length(figure.skeleton(), motion::Limb::left_arm) +
                         0.25F * hand_length(figure);
  const float scale = scale_of(figure);
  return weights.head * std::min(scale * kHeadReach.farthest, straight) +
         weights.pelvis * std::min(scale * kPelvisReach.farthest, straight);
}

Guard guard_in_front(const motion::Figure& figure, const JointFrames& frames,
                     const ThreatGeometry& geometry, const RuleControls& controls) {
  const Eigen::Vector3f& to_threat = geometry.to_threat;
  const Eigen::Vector3f chest_up = frames.orientation[Role::chest] * Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f leftward = chest_up.cross(to_threat);
  const Eigen::Vector3f aside =
      leftward.norm() > 0.1F
          ? Eigen::Vector3f(leftward.normalized())
          : Eigen::Vector3f(frames.orientation[Role::chest] * Eigen::Vector3f::UnitY());

  Guard guard;
  guard.fingers = chest_up;
  for (Side side : motion::kSides) {
    const float control = std::clamp(controls.reach[side], 0.0F, 1.0F);
    const float reach =
        farthest_reach(figure, geometry.weights) - control * reach_range(figure, geometry.weights);
    const Eigen::Vector3f& shoulder =
        frames.position[side == Side::left ? Role::left_upper_arm : Role::right_upper_arm];
    const Eigen::Vector3f beside =
        geometry.target_point + sign_of(side) * 0.25F * hand_length(figure) * aside;
    const float clear =
        clearance_along(figure, frames, beside, to_threat) + 0.68F * hand_length(figure);
    guard.palm[side] = point_at_reach(beside, to_threat, shoulder, reach, clear);
    guard.pole[side] = -chest_up;
    guard.swivel[side] = radians(kMaxSwivel + std::clamp(controls.swivel[side], 0.0F, 1.0F) *
                                                  (kMinSwivel - kMaxSwivel));
    guard.facing[side] = to_threat;
  }
  return guard;
}

// Palms on the back of the head, elbows forward beside the face.
Guard guard_behind_head(const motion::Figure& figure, const JointFrames& frames) {
  const motion::Shape& skull = figure.bodies[motion::Body::head].shape;
  const Eigen::Quaternionf& head = frames.orientation[Role::head];
  const Eigen::Quaternionf& chest = frames.orientation[Role::chest];
  const float palm_width = 0.25F * hand_length(figure);
  Guard guard;
  guard.fingers = head * Eigen::Vector3f::UnitZ();
  for (Side side : motion::kSides) {
    const Eigen::Vector3f outward = sign_of(side) * Eigen::Vector3f::UnitY();
    guard.palm[side] = frames.position[Role::head] +
                       head * (skull.centre - (skull.radius + 0.06F) * Eigen::Vector3f::UnitX() +
                               palm_width * outward);
    guard.pole[side] = chest * (Eigen::Vector3f::UnitX() + 1.2F * outward);
    guard.facing[side] = head * Eigen::Vector3f::UnitX();
  }
  return guard;
}

// A hand's frame has its fingers along +y on the left, -y on the right, and its palm at -z.
Eigen::Quaternionf hand_facing(Side side, const Eigen::Vector3f& palm_normal,
                               const Eigen::Vector3f& finger_hint) {
  const Eigen::Vector3f z = -palm_normal.normalized();
  const Eigen::Vector3f fingers = (finger_hint - finger_hint.dot(z) * z).normalized();
  const Eigen::Vector3f y = sign_of(side) * fingers;
  Eigen::Matrix3f frame;
  frame << y.cross(z), y, z;
  return Eigen::Quaternionf(frame);
}

// Moves the palms to their places. The wrist position depends on the hand's orientation, which the
// wrist's limits and so the forearm restrict; a few iterations solve for both.
void place_palms(const motion::Figure& figure, const JointFrames& trunk, const Guard& guard,
                 Pose& pose) {
  constexpr int kRounds = 3;
  for (Side side : motion::kSides) {
    const motion::LimbRoles roles = motion::roles_of(arm_of(side));
    const JointLimits& wrist =
        joint_limits_named(side == Side::left ? "left_wrist" : "right_wrist");
    Eigen::Vector3f to_palm = 0.4F * hand_length(figure) * guard.fingers;  // initial value
    for (int round = 0; round < kRounds; ++round) {
      const Eigen::Quaternionf forearm =
          solve_arm(figure.skeleton(), trunk, side,
                    {guard.palm[side] - to_palm, guard.pole[side], guard.swivel[side]}, pose);
      const Eigen::Vector3f along = (forearm * figure.skeleton().offset[roles.end]).normalized();
      const Eigen::Quaternionf wanted =
          hand_facing(side, guard.facing[side], along + 0.6F * guard.fingers);
      pose.rotation[roles.end] = clamp_to_limits(wrist, forearm.conjugate() * wanted);
      to_palm = forearm * (pose.rotation[roles.end] * (0.5F * figure.skeleton().tip[roles.end]));
    }
    clamp_arm_to_limits(pose, side);
  }
}

}  // namespace

float normalised(float value, float min, float max) {
  return std::clamp((value - min) / (max - min), 0.0F, 1.0F);
}

RuleControls rule_controls(const AimedThreat& aimed, const ThreatRange& range) {
  const float size = normalised(aimed.threat.radius, range.min_radius_m, range.max_radius_m);
  RuleControls controls;
  controls.lean =
      normalised(aimed.threat.velocity.norm(), range.min_speed_mps, range.max_speed_mps);
  controls.turn = size;
  controls.recoil = size;
  controls.reach = {size, size};
  controls.swivel = {size, size};
  return controls;
}

float time_to_contact_s(float normalised_speed, float cos_angle) {
  const float speed = std::clamp(normalised_speed, 0.0F, 1.0F);
  const float cosine = std::clamp(cos_angle, -1.0F, 1.0F);
  return (0.25F + 0.75F * (1 - speed)) * (1 + 0.2F * (1 - cosine));
}

TargetWeights target_weights(float distance_to_head_m, float distance_to_pelvis_m) {
  const float total = distance_to_head_m + distance_to_pelvis_m;
  if (!(total > 0)) return {0.5F, 0.5F};
  return {distance_to_pelvis_m / total, distance_to_head_m / total};
}

Pose lean_away(const Pose& pose, const Eigen::Vector3f& travel, float lean,
               const TargetWeights& weights) {
  const float amount = std::clamp(lean, 0.0F, 1.0F);
  const auto angles = [&](const MaxAngles& maxima, float weight) {
    const float share = amount * weight;
    return Eigen::Vector2f(-travel.y() * share * radians(maxima.x),
                           travel.x() * share * radians(maxima.y));
  };
  const auto lean_joint = [](Pose& leaned, Role role, const Eigen::Vector2f& angle) {
    turn_joint(leaned, role,
               rotation_about(Eigen::Vector3f::UnitX(), angle.x()) *
                   rotation_about(Eigen::Vector3f::UnitY(), angle.y()));
  };
  Pose result = pose;
  lean_joint(result, Role::pelvis, angles(kPelvis, weights.head - weights.pelvis));
  lean_joint(result, Role::abdomen, angles(kWaist, weights.head));
  lean_joint(result, Role::chest, angles(kBack, weights.head));
  lean_joint(result, Role::neck, angles(kNeck, weights.head / 2));
  lean_joint(result, Role::head, angles(kNeck, weights.head / 2));
  return result;
}

Pose turn_away(const Pose& pose, float azimuth, float turn) {
  const float amount = std::clamp(turn, 0.0F, 1.0F);
  const float from = motion::wrapped_to_pi(azimuth);
  // Facing away is half a turn from the threat, towards the side that it does not come from.
  const float sense = from >= 0 ? -1.0F : 1.0F;
  const float needed = std::numbers::pi_v<float> - std::abs(from);
  const float of_neck = std::min(needed, radians(kNeck.z));
  const float remainder = needed - of_neck;
  const auto turn_by = [&](float share, const MaxAngles& maxima) {
    return rotation_about(Eigen::Vector3f::UnitZ(),
                          sense * amount * std::min(share * remainder, radians(maxima.z)));
  };
  Pose result = pose;
  turn_neck(result, Eigen::Vector3f::UnitZ(), sense * amount * of_neck);
  turn_joint(result, Role::chest, turn_by(0.5F, kBack));
  turn_joint(result, Role::abdomen, turn_by(0.3F, kWaist));
  turn_joint(result, Role::pelvis, turn_by(0.2F, kPelvis));
  return result;
}

Pose recoil(const Pose& pose, float amount) {
  const float share = std::clamp(amount, 0.0F, 1.0F);
  const Eigen::Quaternionf left =
      rotation_about(Eigen::Vector3f::UnitX(), share * radians(kClavicleX)) *
      rotation_about(Eigen::Vector3f::UnitY(), -share * radians(kClavicleY));
  Pose result = pose;
  turn_joint(result, Role::left_clavicle, left);
  turn_joint(result, Role::right_clavicle, motion::mirrored(left));
  return result;
}

ThreatGeometry threat_geometry(const motion::Figure& figure, const Pose& pose,
                               const AimedThreat& aimed) {
  const JointFrames frames = motion::forward_kinematics(figure.skeleton(), pose);
  const auto distance = [&](Role role) {
    return (aimed.target_point - frames.position[role]).norm();
  };
  ThreatGeometry geometry;
  geometry.target_point = aimed.target_point;
  geometry.to_threat = (aimed.threat.position - aimed.target_point).normalized();
  geometry.travel =
      rotation_about(Eigen::Vector3f::UnitZ(), -motion::facing(pose)) * -geometry.to_threat;
  geometry.azimuth = motion::wrapped_to_pi(motion::yaw_of(geometry.to_threat) -
                                           motion::yaw_of(frames.orientation[Role::head]));
  geometry.weights = target_weights(distance(Role::head), distance(Role::pelvis));
  return geometry;
}

bool guards_head_from_behind(const JointFrames& trunk, const ThreatGeometry& geometry) {
  const Eigen::Vector3f forward = trunk.orientation[Role::chest] * Eigen::Vector3f::UnitX();
  return geometry.to_threat.dot(forward) < 0;
}

float reach_range(const motion::Figure& figure, const TargetWeights& weights) {
  return farthest_reach(figure, weights) -
         scale_of(figure) *
             (weights.head * kHeadReach.nearest + weights.pelvis * kPelvisReach.nearest);
}

void block(const motion::Figure& figure, const JointFrames& trunk, const ThreatGeometry& geometry,
           const RuleControls& controls, Pose& pose) {
  place_palms(figure, trunk,
              guards_head_from_behind(trunk, geometry)
                  ? guard_behind_head(figure, trunk)
                  : guard_in_front(figure, trunk, geometry, controls),
              pose);
}

Pose cover_head(const motion::Figure& figure, const Pose& pose) {
  const JointFrames frames = motion::forward_kinematics(figure.skeleton(), pose);
  Pose result = pose;
  place_palms(figure, frames, guard_behind_head(figure, frames), result);
  return result;
}

Pose apply_rules(const motion::Figure& figure, const Pose& pose, const ThreatGeometry& geometry,
                 const RuleControls& controls, const motion::PerSide<motion::FootPose>& feet,
                 bool* feet_reach) {
  Pose result = lean_away(pose, geometry.travel, controls.lean, geometry.weights);
  result = turn_away(result, geometry.azimuth, controls.turn);
  result = recoil(result, controls.recoil);
  limit_neck(result);
  JointFrames trunk = motion::forward_kinematics(figure.skeleton(), result);
  const float lower = std::min(
      max_pelvis_height(figure.skeleton(), trunk, feet) - trunk.position[Role::pelvis].z(), 0.0F);
  for (Eigen::Vector3f& position : trunk.position) position.z() += lower;
  result.root_position.z() += lower;
  const bool reached = solve_legs(figure.skeleton(), trunk, feet, result);
  if (feet_reach != nullptr) *feet_reach = reached;
  block(figure, trunk, geometry, controls, result);
  return result;
}

Pose startle(const motion::Figure& figure, const Pose& pose, const AimedThreat& threat) {
  Pose drawn_up = recoil(pose, 1);
  for (Side side : motion::kSides) {
    set_arm(drawn_up, side, {0, radians(kShoulderX), 0, radians(kElbowY)});
  }
  Pose result = motion::blend(pose, drawn_up, 0.2F);
  turn_neck(result, Eigen::Vector3f::UnitZ(), 0.4F * threat_geometry(figure, pose, threat).azimuth);
  limit_neck(result);
  return result;
}

}  // namespace flinch::database
