// SPDX-License-Identifier: MIT
#include "sim/figure/figure_rows.h"

#include <algorithm>

#include "motion/rotation.h"

namespace flinch::sim {
namespace {

using motion::Body;

// Stiffness of a joint's limit relative to the joint's own spring: stiff enough to hold, soft
// enough to solve.
constexpr double kLimitStiffnessRatio = 20;
// A joint bent by at most this angle counts as straight.
constexpr double kStraight_rad = 0.1;
// The force and torque that return the pelvis grow up to this distance only.
constexpr double kMaxPelvisError_m = 0.1;
constexpr double kMaxPelvisError_rad = 0.35;

/// The axes of a joint's motor in the parent's frame. Springs drive the first `free` axes; the
/// others are rigid.
struct JointAxes {
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  int free = 3;
};

// A recorded knee or elbow is no pure hinge, and its bending axis depends on how the skeleton
// distributes twist along the limb. So the hinge's axis is the axis about which the reference bends
// the joint or, for a straight joint, the anatomical axis. About the axes across it the joint
// follows the reference rigidly, which keeps every detail of the recording and still transmits a
// blow from the side.
JointAxes axes_of(JointKind kind, const JointRange& limits, const Eigen::Quaterniond& reference) {
  if (kind == JointKind::ball) return {};
  const bool elbow = kind == JointKind::elbow;
  const Eigen::Vector3d anatomical = elbow ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d angles = joint_angles(limits, reference);
  const Eigen::Vector3d& bone = limits.bone;
  const Eigen::Vector3d bend = angles - angles.dot(bone) * bone;
  const double side = bend.dot(anatomical) < 0 ? -1.0 : 1.0;
  const Eigen::Vector3d hinge = (side * bend + kStraight_rad * anatomical).normalized();
  JointAxes axes;
  axes.frame << hinge, bone, hinge.cross(bone);
  axes.free = elbow ? 2 : 1;
  return axes;
}

/// Heel and toe on the sole's centre line, in the frame of the foot's centre of mass, m. Two points
/// per foot instead of its corners, because each point costs the solver a pivot; the ankle controls
/// the foot's roll.
std::array<Eigen::Vector3d, 2> heel_and_toe(const MovingShape& foot) {
  return {sole_point(foot, -1, 0), sole_point(foot, 1, 0)};
}

}  // namespace

// A force beyond the limit acts as softer gains do: f = k e + c (w_d - w) scales with them.
PelvisRows pelvis_rows(const FigureModel& figure_model, const BodyState& now,
                       const BodyState& target, double step_s, const MotorStrength& strength) {
  const Gains angular = scaled_gains(figure_model.gains[Body::pelvis], strength.pelvis);
  Gains moving = scaled_gains(figure_model.pelvis_gains, strength.pelvis);
  const Eigen::Vector3d turn =
      clamped_length(motion::rotation_vector(target.orientation * now.orientation.conjugate()),
                     kMaxPelvisError_rad);
  const Eigen::Vector3d shift = clamped_length(target.position - now.position, kMaxPelvisError_m);
  const double force_n =
      (moving.stiffness * shift + moving.damping * (target.velocity - now.velocity)).norm();
  if (force_n > strength.max_pelvis_force_n) {
    const double share = strength.max_pelvis_force_n / force_n;
    moving = {share * moving.stiffness, share * moving.damping};
  }
  PelvisRows rows;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    rows.linear[at] =
        spring_row(moving, moving.stiffness * shift[axis], target.velocity[axis], step_s);
    rows.angular[at] =
        spring_row(angular, angular.stiffness * turn[axis], target.angular_velocity[axis], step_s);
  }
  return rows;
}

// Works in the axes of the joint's motor: the columns of F, in the parent's frame. At a limit the
// springs along the direction back to the range stiffen, each axis by its share of that direction;
// a limit never weakens a spring.
JointRows joint_rows(const FigureModel& figure_model, Body body,
                     const Eigen::Quaterniond& now_world, const Eigen::Quaterniond& parent_now,
                     const ReferenceState& target, double step_s, double share) {
  const BodyState& wanted = target.body[body];
  const BodyState& wanted_parent = target.body[*parent_of(body)];
  const Eigen::Quaterniond to_parent = wanted_parent.orientation.conjugate();
  const Eigen::Quaterniond reference = to_parent * wanted.orientation;
  const Eigen::Quaterniond now = parent_now.conjugate() * now_world;
  const JointAxes axes = axes_of(figure_model.kinds[body], figure_model.limits[body], reference);
  Eigen::Vector3d error = motion::rotation_vector(reference * now.conjugate());
  Eigen::Vector3d velocity = to_parent * (wanted.angular_velocity - wanted_parent.angular_velocity);
  Eigen::Vector3d back = limit_violation(figure_model.limits[body], now, reference);
  JointRows rows;
  rows.socket = target.socket[body];
  rows.axes = parent_now.toRotationMatrix();
  if (figure_model.kinds[body] != JointKind::ball) {
    for (Eigen::Vector3d* vector : {&error, &velocity, &back}) {
      *vector = (axes.frame.transpose() * *vector).eval();
    }
    rows.axes *= axes.frame;
  }
  const double way = back.squaredNorm();
  const Gains weak = scaled_gains(figure_model.gains[body], share);
  for (int axis = 0; axis < 3; ++axis) {
    AxisRow& row = rows.angular[static_cast<std::size_t>(axis)];
    if (axis >= axes.free) {
      row = rigid_row(error[axis], velocity[axis], step_s);
      continue;
    }
    Gains gains = weak;
    double spring_force = gains.stiffness * error[axis];
    if (way > 0) {
      const double stop =
          kLimitStiffnessRatio * figure_model.gains[body].stiffness * back[axis] * back[axis] / way;
      spring_force += stop * back[axis];
      gains.stiffness += stop;
    }
    row = spring_row(gains, spring_force, velocity[axis], step_s);
  }
  return rows;
}

Eigen::Vector3d joint_offset(const FigureModel& figure_model, Body body) {
  return -figure_model.model[body].centre_of_mass.cast<double>();
}

FootSupport foot_support(const FigureModel& figure_model, Body foot, const BodyState& now,
                         const BodyState& target) {
  FootSupport support;
  for (const Eigen::Vector3d& end : heel_and_toe(figure_model.outline[foot])) {
    const Eigen::Vector3d point = now.position + now.orientation * end;
    const double ground = std::min(0.0, (target.position + target.orientation * end).z());
    if (point.z() >= ground) continue;
    support.points[support.count++] = {foot, point, ground - point.z()};
  }
  return support;
}

MovingShape placed_shape(const MovingShape& outline, const BodyState& state) {
  MovingShape shape = outline;
  shape.centre = state.position + state.orientation * shape.centre;
  shape.orientation = state.orientation * shape.orientation;
  shape.angular_velocity = state.angular_velocity;
  shape.velocity = state.velocity + state.angular_velocity.cross(shape.centre - state.position);
  return shape;
}

}  // namespace flinch::sim
