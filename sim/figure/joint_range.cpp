// SPDX-License-Identifier: MIT
#include "sim/figure/joint_range.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/joint_limits.h"
#include "motion/rotation.h"

namespace flinch::sim {
namespace {

using motion::Body;

// A row of the human limits and the share of it that one joint has.
struct LimitSource {
  std::string_view name;  // of the left side, or of the middle
  double share = 1;
};

// Spine and neck have two joints each here, which share their range equally.
LimitSource limit_source_of(Body body) {
  switch (body) {
    case Body::abdomen:
    case Body::chest:
      return {"trunk", 0.5};
    case Body::neck:
    case Body::head:
      return {"neck", 0.5};
    case Body::left_upper_arm:
      return {"left_shoulder"};
    case Body::left_forearm:
      return {"left_elbow"};
    case Body::left_hand:
      return {"left_wrist"};
    case Body::left_thigh:
      return {"left_hip"};
    case Body::left_shin:
      return {"left_knee"};
    case Body::left_foot:
      return {"left_ankle"};
    default:
      return {};
  }
}

JointRange limits_from(const LimitSource& source) {
  if (source.name.empty()) return {};
  const motion::JointLimits& human = motion::joint_limits_named(source.name);
  return {human.reference.cast<double>(), human.axis.cast<double>(),
          source.share * human.min.cast<double>(), source.share * human.max.cast<double>()};
}

// Under reflection in the XZ plane, angles about X and Z change sign.
JointRange mirrored(const JointRange& left) {
  const Eigen::Vector3d same(0, 1, 0);
  const Eigen::Vector3d turned(-1, 0, -1);
  const Eigen::Quaterniond& q = left.reference;
  return {{q.w(), -q.x(), q.y(), -q.z()},
          left.bone.cwiseProduct(Eigen::Vector3d(1, -1, 1)),
          left.min.cwiseProduct(same) + left.max.cwiseProduct(turned),
          left.max.cwiseProduct(same) + left.min.cwiseProduct(turned)};
}

// A rotation vector is 2 f(c) times the quaternion's vector part, where c = |w| is its cosine and
//
//   f(c) = acos(c) / sqrt(1 - c^2),   convex and falling from pi/2 at c = 0 to 1 at c = 1.
//
// So f lies above its tangent at 1 and below the chord:
//
//   (4 - c) / 3 <= f(c) <= pi/2 - (pi/2 - 1) c.

/// Bounds of each angle of a rotation, at some distance from an estimate.
struct AngleBounds {
  Eigen::Vector3d guess;
  Eigen::Vector3d error;

  void add(const Eigen::Quaterniond& rotation) {
    const double cosine = std::min(std::abs(rotation.w()), 1.0);
    const double min = (4 - cosine) / 3;
    const double max = std::numbers::pi / 2 - (std::numbers::pi / 2 - 1) * cosine;
    guess += (rotation.w() < 0 ? -1 : 1) * (min + max) * rotation.vec();
    error += (max - min) * rotation.vec().cwiseAbs();
  }
};

/// Returns true only if a rotation is certainly within the limits. Most are, and this finds it
/// without the arctangents of joint_angles.
bool is_well_within(const JointRange& limits, const Eigen::Quaterniond& rotation) {
  constexpr double kMargin_rad = 1e-9;  // for rounding errors
  const auto [swing, twist] =
      motion::decompose_swing_twist<double>(limits.reference.conjugate() * rotation, limits.bone);
  AngleBounds angles{Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(kMargin_rad)};
  angles.add(swing);
  angles.add(twist);
  return (angles.guess - angles.error - limits.min).minCoeff() >= 0 &&
         (limits.max - angles.guess - angles.error).minCoeff() >= 0;
}

}  // namespace

JointRange limits_of(Body body) {
  const Body other = body_of(motion::mirrored(role_of(body)));
  const bool right = other < body;  // left sides come first
  return right ? mirrored(limits_from(limit_source_of(other))) : limits_from(limit_source_of(body));
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

Eigen::Vector3d hinge_axis(JointKind kind) {
  switch (kind) {
    case JointKind::elbow:
      return Eigen::Vector3d::UnitZ();
    case JointKind::hinge:
      return Eigen::Vector3d::UnitY();
    default:
      return Eigen::Vector3d::Zero();
  }
}

Eigen::Vector3d joint_angles(const JointRange& limits, const Eigen::Quaterniond& rotation) {
  return motion::swing_twist_vector<double>(limits.reference.conjugate() * rotation, limits.bone);
}

Eigen::Quaterniond joint_rotation(const JointRange& limits, const Eigen::Vector3d& angles) {
  return limits.reference * motion::rotation_from_swing_twist(angles, limits.bone);
}

Eigen::Vector3d limit_violation(const JointRange& limits, const Eigen::Quaterniond& rotation,
                                const Eigen::Quaterniond& reference) {
  if (is_well_within(limits, rotation)) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d angles = joint_angles(limits, rotation);
  const auto within = [&](const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
    return Eigen::Vector3d(angles.cwiseMax(min).cwiseMin(max));
  };
  if (within(limits.min, limits.max) == angles) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d wanted = joint_angles(limits, reference);
  const Eigen::Vector3d nearest = within(limits.min.cwiseMin(wanted), limits.max.cwiseMax(wanted));
  if (nearest == angles) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d back =
      motion::rotation_vector(joint_rotation(limits, nearest) * rotation.conjugate());
  // The reference lies within these limits, so the rotation back to them is at most as long as the
  // rotation to it. Where angles jump, at half a turn, the clamped angles would say otherwise.
  const Eigen::Vector3d to_reference = motion::rotation_vector(reference * rotation.conjugate());
  return back.squaredNorm() < to_reference.squaredNorm() ? back : to_reference;
}

}  // namespace flinch::sim
