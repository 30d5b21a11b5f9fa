// SPDX-License-Identifier: MIT
#include "sim/joint_limits.h"

#include <cmath>
#include <numbers>

#include "sim/reference.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kPlay = 5;  // degrees, where a joint has no freedom

struct Range {
  double low, high;  // degrees
};

// Ranges about X (forward), Y (left) and Z (up) from the T-pose, for the body's left side.
struct Entry {
  Eigen::Vector3d bone;
  Range x, y, z;
};

// American Academy of Orthopaedic Surgeons, "Joint Motion: Method of Measuring and Recording"
// (1965): thoracolumbar spine flexion 80, extension 25, to the side 35, rotation 45; neck 45, 45,
// 45, 60; shoulder abduction 180, horizontal flexion 135 and extension 45, rotation in 70, out 90;
// elbow 0 to 150, pronation and supination 80; wrist flexion 80, extension 70, radial 20, ulnar 30;
// hip flexion 120, extension 30, abduction 45, adduction 30, rotation 45 each way; knee flexion
// 135; ankle up 20, down 50, inversion 35, eversion 15. Spine and neck are two joints each here,
// which share their range equally. Adduction of the hanging arm across the body (30) and the
// turning of the foot (20) are estimates.
Entry left_entry(Body body) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  switch (body) {
    case Body::abdomen:
    case Body::chest:
      return {z, {-17.5, 17.5}, {-12.5, 40}, {-22.5, 22.5}};
    case Body::neck:
    case Body::head:
      return {z, {-22.5, 22.5}, {-22.5, 22.5}, {-30, 30}};
    case Body::left_upper_arm:
      return {y, {-120, 90}, {-90, 70}, {-135, 45}};
    case Body::left_forearm:
      return {y, {-kPlay, kPlay}, {-80, 80}, {-150, 0}};
    case Body::left_hand:
      return {y, {-80, 70}, {-kPlay, kPlay}, {-20, 30}};
    case Body::left_thigh:
      return {-z, {-30, 45}, {-120, 30}, {-45, 45}};
    case Body::left_shin:
      return {-z, {-kPlay, kPlay}, {0, 135}, {-kPlay, kPlay}};
    case Body::left_foot:
      return {x, {-35, 15}, {-20, 50}, {-20, 20}};
    default:
      return {z, {0, 0}, {0, 0}, {0, 0}};
  }
}

// Mirrored in the plane of X and Z, angles about X and Z change sign.
Entry mirrored(const Entry& left) {
  return {{left.bone.x(), -left.bone.y(), left.bone.z()},
          {-left.x.high, -left.x.low},
          left.y,
          {-left.z.high, -left.z.low}};
}

}  // namespace

JointLimits limits_of(Body body) {
  const motion::Role role = role_of(body);
  const Body other = body_of(motion::mirrored(role));
  const bool right = other < body;  // left sides come first
  const Entry entry = right ? mirrored(left_entry(other)) : left_entry(body);
  return {entry.bone, kDegree * Eigen::Vector3d(entry.x.low, entry.y.low, entry.z.low),
          kDegree * Eigen::Vector3d(entry.x.high, entry.y.high, entry.z.high)};
}

JointKind kind_of(Body body) {
  switch (body) {
    case Body::left_forearm:
    case Body::right_forearm:
      return JointKind::elbow;
    case Body::left_shin:
    case Body::right_shin:
      return JointKind::hinge;
    default:
      return JointKind::ball;
  }
}

// q = swing twist, with twist the part of q about the bone.
Eigen::Vector3d joint_angles(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& bone) {
  const double along = rotation.vec().dot(bone);
  Eigen::Quaterniond twist(rotation.w(), along * bone.x(), along * bone.y(), along * bone.z());
  const double norm = twist.norm();
  if (norm < 1e-9) return rotation_vector(rotation);  // turned right round: no twist to speak of
  twist.coeffs() /= norm;
  const Eigen::Vector3d swing = rotation_vector(rotation * twist.conjugate());
  return swing + rotation_vector(twist);
}

Eigen::Quaterniond joint_rotation(const Eigen::Vector3d& angles, const Eigen::Vector3d& bone) {
  const Eigen::Vector3d twist = angles.dot(bone) * bone;
  return rotation_by(angles - twist) * rotation_by(twist);
}

Eigen::Vector3d beyond_limits(const JointLimits& limits, const Eigen::Quaterniond& rotation,
                              const Eigen::Quaterniond& reference) {
  const Eigen::Vector3d angles = joint_angles(rotation, limits.bone);
  const auto within = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    return Eigen::Vector3d(angles.cwiseMax(low).cwiseMin(high));
  };
  if (within(limits.low, limits.high) == angles) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d wanted = joint_angles(reference, limits.bone);
  const Eigen::Vector3d nearest = within(limits.low.cwiseMin(wanted), limits.high.cwiseMax(wanted));
  if (nearest == angles) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d back =
      rotation_vector(joint_rotation(nearest, limits.bone) * rotation.conjugate());
  // The reference is within these limits, so that no way back is longer than the way to it; where
  // angles jump, at half a turn, they would say otherwise.
  const Eigen::Vector3d to_reference = rotation_vector(reference * rotation.conjugate());
  return back.squaredNorm() < to_reference.squaredNorm() ? back : to_reference;
}

}  // namespace flinch::sim
