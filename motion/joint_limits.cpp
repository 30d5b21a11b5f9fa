// SPDX-License-Identifier: MIT
#include "motion/joint_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion/error.h"
#include "motion/rotation.h"

namespace flinch::motion {
namespace {

// Ranges in degrees about x, y and z of the reference. Signs for the left side: an arm (+Y) rises
// with +x and comes forward with -z; a leg (-Z) comes forward with -y and goes outward with +x; a
// trunk (+Z) bends forward with +y and to the right with +x.
struct LimitsRow {
  std::string_view name;
  Role from;
  Role to;
  float reference_z;  // rotation about z from the rest pose to the reference
  int axis;           // of the twist: 0 x, 1 y, 2 z
  Eigen::Vector3f min;
  Eigen::Vector3f max;
};

// Sources.
//
// Trunk (thoracic and lumbar spine together): flexion 105, extension 60, bending 40, rotation 40
// (Kapandji, The Physiology of the Joints, volume 3).
// Neck: flexion 50, extension 60, bending 45, rotation 80 (AMA Guides to the Evaluation of
// Permanent Impairment, 5th edition, chapter 15).
// Clavicle: elevation 45 (35 in Hermens' table 3.2), depression 10, protraction 30, retraction 25,
// rotation 50 (Inman, Saunders and Abbott 1944; Ludewig et al. 2009).
// Shoulder (upper arm relative to the chest), measured from an arm 45 degrees forward of sideways:
// the Academy's abduction 180, flexion 180, extension 60, horizontal flexion 135, rotation 70
// inward and 90 outward (from this reference 135 with the arm down; extension by 30 makes it 108
// down).
// Elbow: flexion 150, forearm rotation 80 each way, whether it is counted at the wrist or the
// elbow.
// Wrist: flexion 80, extension 70, radial 20, ulnar 30, pronation and supination 80.
// Hip: flexion 120, extension 30, abduction 45, adduction 30, rotation 45 each way.
// Knee: flexion 135, or 150 in a crouch; rotation up to 30 where it is bent.
// Ankle: plantar flexion 50, inversion 35, eversion 20, and the dorsiflexion of a loaded foot, 40
// (weight-bearing lunge, Bennell et al. 1998; the Academy's 20 is for an unloaded foot).
// Toes: extension 70, flexion 45.
//
// Rows without a source: American Academy of Orthopaedic Surgeons, Joint Motion (1965).
std::array<LimitsRow, 2> middle_rows() {
  return {{
      {"trunk", Role::pelvis, Role::chest, 0, 2, {-40, -60, -40}, {40, 105, 40}},
      {"neck", Role::chest, Role::head, 0, 2, {-45, -60, -80}, {45, 50, 80}},
  }};
}

std::array<LimitsRow, 8> left_rows() {
  return {{
      {"clavicle", Role::chest, Role::left_clavicle, 0, 1, {-10, -50, -30}, {45, 50, 25}},
      {"shoulder", Role::chest, Role::left_upper_arm, -45, 1, {-108, -135, -95}, {95, 85, 100}},
      {"elbow", Role::left_upper_arm, Role::left_forearm, 0, 1, {-10, -80, -150}, {10, 80, 5}},
      {"wrist", Role::left_forearm, Role::left_hand, 0, 1, {-80, -80, -20}, {70, 80, 30}},
      {"hip", Role::pelvis, Role::left_thigh, 0, 2, {-30, -120, -45}, {45, 30, 45}},
      {"knee", Role::left_thigh, Role::left_shin, 0, 2, {-10, -5, -30}, {10, 150, 30}},
      {"ankle", Role::left_shin, Role::left_foot, 0, 2, {-35, -40, -30}, {20, 50, 30}},
      {"toes", Role::left_foot, Role::left_toes, 0, 2, {-15, -70, -15}, {15, 45, 15}},
  }};
}

constexpr std::array<std::string_view, 8> kLeftNames{"left_clavicle", "left_shoulder", "left_elbow",
                                                     "left_wrist",    "left_hip",      "left_knee",
                                                     "left_ankle",    "left_toes"};
constexpr std::array<std::string_view, 8> kRightNames{
    "right_clavicle", "right_shoulder", "right_elbow", "right_wrist",
    "right_hip",      "right_knee",     "right_ankle", "right_toes"};

JointLimits limits_of(const LimitsRow& row, std::string_view name, bool on_right_side) {
  JointLimits limits;
  limits.name = name;
  limits.from = on_right_side ? mirrored(row.from) : row.from;
  limits.to = on_right_side ? mirrored(row.to) : row.to;
  limits.reference = rotation_about(Eigen::Vector3f::UnitZ(), radians(row.reference_z));
  limits.axis = Eigen::Vector3f::Unit(row.axis);
  limits.min = row.min.unaryExpr([](float angle) { return radians(angle); });
  limits.max = row.max.unaryExpr([](float angle) { return radians(angle); });
  limits.on_right_side = on_right_side;
  return limits;
}

std::vector<JointLimits> make_table() {
  std::vector<JointLimits> table;
  for (const LimitsRow& row : middle_rows()) table.push_back(limits_of(row, row.name, false));
  const auto left = left_rows();
  for (std::size_t i = 0; i < left.size(); ++i) {
    table.push_back(limits_of(left[i], kLeftNames[i], false));
    table.push_back(limits_of(left[i], kRightNames[i], true));
  }
  return table;
}

}  // namespace

std::span<const JointLimits> human_joint_limits() {
  static const std::vector<JointLimits> table = make_table();
  return table;
}

const JointLimits& joint_limits_named(std::string_view name) {
  for (const JointLimits& limits : human_joint_limits()) {
    if (limits.name == name) return limits;
  }
  throw Error("", "there is no joint '" + std::string(name) + "' in the table of human limits");
}

// rotation = reference * swing * twist, with the twist about the axis.
Eigen::Vector3f joint_angles(const JointLimits& limits, const Eigen::Quaternionf& rotation) {
  const Eigen::Quaternionf seen = limits.on_right_side ? mirrored(rotation) : rotation;
  return swing_twist_vector<float>(limits.reference.conjugate() * seen, limits.axis);
}

// With the sine s of half an angle from 0 to pi, the angle is 2 asin(s), and
//
//     2 s <= 2 asin(s) <= 2 s (1 + (pi / 2 - 1) s^2),
//
// since asin(s) / s is convex in s^2: it lies below its chord from s = 0 to 1. So the angles about
// x, y and z are those vector parts of swing and twist times a factor that is at most the one on
// the right. Every range holds 0.
bool is_clearly_within(const JointLimits& limits, const Eigen::Quaternionf& rotation) {
  constexpr float kRise = std::numbers::pi_v<float> / 2 - 1;
  const Eigen::Quaternionf seen = limits.on_right_side ? mirrored(rotation) : rotation;
  const auto [swing, twist] =
      decompose_swing_twist<float>(limits.reference.conjugate() * seen, limits.axis);
  // The twist takes the shorter way round, as in rotation_vector(); a swing's scalar part is
  // positive.
  const Eigen::Vector3f along = twist.w() < 0 ? Eigen::Vector3f(-twist.vec()) : twist.vec();
  const Eigen::Vector3f most = 2 * (1 + kRise * swing.vec().squaredNorm()) * swing.vec() +
                               2 * (1 + kRise * along.squaredNorm()) * along;
  return (most.array() <= limits.max.array()).all() && (most.array() >= limits.min.array()).all();
}

Eigen::Quaternionf rotation_of_angles(const JointLimits& limits, const Eigen::Vector3f& angles) {
  const Eigen::Quaternionf rotation =
      limits.reference * rotation_from_swing_twist(angles, limits.axis);
  return limits.on_right_side ? mirrored(rotation) : rotation;
}

float limit_excess(const JointLimits& limits, const Eigen::Quaternionf& rotation) {
  const Eigen::Vector3f angles = joint_angles(limits, rotation);
  const float over = (angles - limits.max).maxCoeff();
  const float under = (limits.min - angles).maxCoeff();
  return std::max({over, under, 0.0F});
}

void clamp_arm_to_limits(Pose& pose, Side side) {
  const bool left = side == Side::left;
  const JointLimits& shoulder = joint_limits_named(left ? "left_shoulder" : "right_shoulder");
  const JointLimits& wrist = joint_limits_named(left ? "left_wrist" : "right_wrist");
  const Eigen::Quaternionf& clavicle =
      pose.rotation[left ? Role::left_clavicle : Role::right_clavicle];
  Eigen::Quaternionf& upper_arm = pose.rotation[shoulder.to];
  const Eigen::Quaternionf arm = clavicle * upper_arm;
  if (limit_excess(shoulder, arm) > 0) {
    upper_arm = (clavicle.conjugate() * clamp_to_limits(shoulder, arm)).normalized();
  }
  pose.rotation[wrist.to] = clamp_to_limits(wrist, pose.rotation[wrist.to]);
}

Eigen::Quaternionf clamp_to_limits(const JointLimits& limits, const Eigen::Quaternionf& rotation) {
  const Eigen::Vector3f angles = joint_angles(limits, rotation);
  return rotation_of_angles(limits, angles.cwiseMax(limits.min).cwiseMin(limits.max)).normalized();
}

Eigen::Quaternionf clamp_to_limits(const JointLimits& limits, const Eigen::Quaternionf& rotation,
                                   const Eigen::Quaternionf& motion) {
  if (is_clearly_within(limits, rotation) || limit_excess(limits, rotation) <= 0) return rotation;
  const Eigen::Vector3f angles = joint_angles(limits, rotation);
  const Eigen::Vector3f own = joint_angles(limits, motion);
  const Eigen::Vector3f clamped =
      angles.cwiseMax(limits.min.cwiseMin(own)).cwiseMin(limits.max.cwiseMax(own));
  if (clamped == angles) return rotation;
  return rotation_of_angles(limits, clamped).normalized();
}

}  // namespace flinch::motion
