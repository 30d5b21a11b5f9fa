// SPDX-License-Identifier: MIT
#include "sim/figure/figure_rows.h"

#include <algorithm>

#include "features/ball.h"
#include "motion/rotation.h"

namespace flinch::sim {
namespace {

using motion::Body;

// Stiffness of a joint's limit relative to the joint's own spring: stiff enough to hold, soft
// enough to solve.
constexpr double kNoSpringSoftness = 1e30;  // of a limp joint, rad/s/(N·m)
// A joint bent by at most this angle counts as straight.
constexpr double kStraight_rad = 0.1;
// The force and torque that return the pelvis grow up to this distance only.
constexpr double kMaxPelvisError_m = 0.1;
constexpr double kMaxPelvisError_rad = 0.35;
// Rad/s, natural frequency of the hold of a standing foot.
constexpr double kFootFrequency = 60;
constexpr double kSoleFriction = 0.8;  // friction coefficient of a sole

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
// blow from the side. A joint whose twist is damped or rigid has the axes of the child, of which
// the bone is the last.
JointAxes axes_of(const FigureModel& figure_model, Body body, const Eigen::Quaterniond& now,
                  const Eigen::Quaterniond& reference) {
  const JointKind kind = figure_model.kinds[body];
  const JointRange& limits = figure_model.limits[body];
  if (kind == JointKind::fixed) return {Eigen::Matrix3d::Identity(), 0};
  if (has_bone_axes(figure_model, body)) {
    const Eigen::Matrix3d turn = now.toRotationMatrix();
    const int bone_at = bone_index(limits);
    JointAxes along_bone;
    along_bone.frame << turn.col((bone_at + 1) % 3), turn.col((bone_at + 2) % 3), turn.col(bone_at);
    along_bone.free = kind == JointKind::saddle ? 2 : 3;
    return along_bone;
  }
  if (kind == JointKind::ball) return {};
  const Eigen::Vector3d& anatomical = figure_model.hinge[body];
  const Eigen::Vector3d angles = joint_angles(limits, reference);
  const Eigen::Vector3d& bone = limits.bone;
  const Eigen::Vector3d bend = angles - angles.dot(bone) * bone;
  const double side = bend.dot(anatomical) < 0 ? -1.0 : 1.0;
  const Eigen::Vector3d hinge = (side * bend + kStraight_rad * anatomical).normalized();
  JointAxes axes;
  axes.frame << hinge, bone, hinge.cross(bone);
  axes.free = kind == JointKind::elbow ? 2 : 1;
  return axes;
}

/// Returns softer gains where f = k e + c (w_d - w) is beyond a limit: the force scales with them.
Gains limited(const Gains& gains, const Eigen::Vector3d& error, const Eigen::Vector3d& velocity,
              double max_force_n) {
  const double force_n = (gains.stiffness * error + gains.damping * velocity).norm();
  if (force_n <= max_force_n) return gains;
  const double share = max_force_n / force_n;
  return {share * gains.stiffness, share * gains.damping};
}

AnchorRows anchor_rows(const Gains& moving, const Eigen::Vector3d& shift, const Gains& angular,
                       const Eigen::Vector3d& turn, const BodyState& target, double step_s) {
  AnchorRows rows;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    rows.linear[at] =
        spring_row(moving, moving.stiffness * shift[axis], target.velocity[axis], step_s);
    rows.angular[at] =
        spring_row(angular, angular.stiffness * turn[axis], target.angular_velocity[axis], step_s);
  }
  return rows;
}

}  // namespace

AnchorRows pelvis_rows(const FigureModel& figure_model, const BodyState& now,
                       const BodyState& target, double step_s, const MotorStrength& strength) {
  const Gains angular = scaled_gains(figure_model.gains[Body::pelvis], strength.pelvis);
  Gains moving = scaled_gains(figure_model.pelvis_gains, strength.pelvis);
  const Eigen::Vector3d turn =
      clamped_length(motion::rotation_vector(target.orientation * now.orientation.conjugate()),
                     kMaxPelvisError_rad);
  const Eigen::Vector3d shift = clamped_length(target.position - now.position, kMaxPelvisError_m);
  moving = limited(moving, shift, target.velocity - now.velocity, strength.max_pelvis_force_n);
  return anchor_rows(moving, shift, angular, turn, target, step_s);
}

// Friction bounds the force that holds a foot: beyond it the foot slides.
AnchorRows foot_rows(const FigureModel& figure_model, Body foot, const BodyState& now,
                     const BodyState& target, double standing_feet, double step_s, double share) {
  const double load_kg = figure_model.mass_kg / standing_feet;
  const Eigen::Vector3d shift = target.position - now.position;
  const Eigen::Vector3d turn =
      motion::rotation_vector(target.orientation * now.orientation.conjugate());
  const Gains angular = scaled_gains(figure_model.gains[foot], share);
  const Gains moving =
      limited(scaled_gains(critically_damped(load_kg, kFootFrequency), share), shift,
              target.velocity - now.velocity, kSoleFriction * features::kGravity_mps2 * load_kg);
  return anchor_rows(moving, shift, angular, turn, target, step_s);
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
  const JointAxes axes = axes_of(figure_model, body, now, reference);
  const ServoLaw& law = figure_model.laws[body];
  Eigen::Vector3d error = motion::rotation_vector(reference * now.conjugate());
  Eigen::Vector3d velocity = to_parent * (wanted.angular_velocity - wanted_parent.angular_velocity);
  Eigen::Vector3d back = limit_violation(figure_model.limits[body], now, reference);
  JointRows rows;
  rows.socket = target.socket[body];
  rows.axes = parent_now.toRotationMatrix();
  if (!axes.frame.isIdentity(0)) {
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
      const double stop = law.limit_stiffness * back[axis] * back[axis] / way;
      spring_force += stop * back[axis];
      gains.stiffness += stop;
      gains.damping += law.limit_damping * back[axis] * back[axis] / way;
    }
    if (axis == 2 && law.twist_share != 1) {
      spring_force *= law.twist_share;
      gains = {law.twist_share * gains.stiffness, law.twist_share * gains.damping};
    }
    if (gains.stiffness + gains.damping > 0) {
      row = spring_row(gains, spring_force, law.follows_velocity ? velocity[axis] : 0, step_s);
    } else {
      row = {0, kNoSpringSoftness};
    }
  }
  return rows;
}

FigureAnchors figure_anchors(const FigureModel& figure_model, const motion::PerBody<BodyState>& now,
                             const ReferenceState& target, double step_s, const Drive& drive) {
  FigureAnchors rows;
  if (!drive.is_falling) {
    rows.pelvis = pelvis_rows(figure_model, now[Body::pelvis], target.body[Body::pelvis], step_s,
                              drive.strength);
  }
  const motion::PerSide<bool> held = held_feet(figure_model, target, drive);
  const auto standing_feet = static_cast<double>(std::ranges::count(held, true));
  for (motion::Side side : motion::kSides) {
    if (!held[side]) continue;
    const Body foot = foot_of(side);
    rows.feet[side] = foot_rows(figure_model, foot, now[foot], target.body[foot], standing_feet,
                                step_s, drive.foot_hold);
  }
  return rows;
}

FigureRows figure_rows(const FigureModel& figure_model, const motion::PerBody<BodyState>& now,
                       const ReferenceState& target, double step_s, const Drive& drive) {
  FigureRows rows{figure_anchors(figure_model, now, target, step_s, drive), {}};
  for (Body body : motion::kBodies) {
    const auto parent = parent_of(body);
    if (!parent) continue;
    rows.joints[body] = joint_rows(figure_model, body, now[body].orientation,
                                   now[*parent].orientation, target, step_s, drive.strength.joints);
  }
  return rows;
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
