// SPDX-License-Identifier: MIT
#include "sim/ode/figure.h"

namespace flinch::sim {
namespace {

using motion::Body;

dJointID make_ball_joint(dWorldID world, dBodyID child, dBodyID parent,
                         const Eigen::Vector3d& place) {
  const dJointID joint = dJointCreateBall(world, nullptr);
  dJointAttach(joint, child, parent);
  dJointSetBallAnchor(joint, place.x(), place.y(), place.z());
  // The constraints of a tree of joints are independent, so they need no softness to be solvable.
  dJointSetBallParam(joint, dParamCFM, 0);
  return joint;
}

dBodyID make_body(dWorldID world, double mass_kg, const Eigen::Matrix3d& inertia) {
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  dMassSetParameters(&mass, mass_kg, 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2),
                     inertia(0, 1), inertia(0, 2), inertia(1, 2));
  dBodySetMass(body, &mass);
  return body;
}

}  // namespace

Figure::Figure(const FigureModel& figure_model, dWorldID world, const ReferenceState& start)
    : figure_model_(figure_model) {
  for (Body body : motion::kBodies) {
    bodies_[body] = make_body(world, static_cast<double>(figure_model.model[body].mass_kg),
                              figure_model.inertia[body]);
    set_state(bodies_[body], start.body[body]);
  }
  pelvis_ = make_anchor(world, bodies_[Body::pelvis]);
  for (Body body : motion::kBodies) {
    const auto parent = parent_of(body);
    if (!parent) continue;
    const BodyState& parent_state = start.body[*parent];
    joints_[body] =
        make_ball_joint(world, bodies_[body], bodies_[*parent],
                        parent_state.position + parent_state.orientation * start.socket[body]);
    motors_[body] =
        make_motor(world, bodies_[body], bodies_[*parent],
                   parent_state.orientation.toRotationMatrix());  // others: see set_joint_motor
  }
  for (motion::Side side : motion::kSides) feet_[side] = make_anchor(world, bodies_[foot_of(side)]);
}

void Figure::place(const motion::PerBody<BodyState>& figure) {
  for (Body body : motion::kBodies) set_state(bodies_[body], figure[body]);
}

Figure::Anchor Figure::make_anchor(dWorldID world, dBodyID body) {
  return {make_linear_motor(world, body),
          make_motor(world, body, nullptr, Eigen::Matrix3d::Identity())};
}

void Figure::set_anchor(const Anchor& anchor, const std::optional<AnchorRows>& rows) {
  const auto set = rows ? dJointEnable : dJointDisable;
  set(anchor.linear);
  set(anchor.angular);
  if (!rows) return;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    set_row(anchor.linear, axis, rows->linear[at], dJointSetLMotorParam);
    set_row(anchor.angular, axis, rows->angular[at], dJointSetAMotorParam);
  }
}

void Figure::drive(const ReferenceState& target, double step_s, const Drive& drive) {
  const FigureRows rows = figure_rows(figure_model_, states(), target, step_s, drive);
  set_anchor(pelvis_, rows.pelvis);
  for (motion::Side side : motion::kSides) set_anchor(feet_[side], rows.feet[side]);
  for (Body body : motion::kBodies) {
    if (parent_of(body)) set_joint_motor(body, rows.joints[body], step_s);
  }
  set_forces(target, step_s, drive);
}

void Figure::set_joint_motor(Body body, const JointRows& rows, double step_s) {
  const dJointID motor = motors_[body];
  if (figure_model_.kinds[body] != JointKind::ball || has_bone_axes(figure_model_, body)) {
    set_axes(motor, bodies_[*parent_of(body)], rows.axes);
  }
  for (int axis = 0; axis < 3; ++axis) {
    set_row(motor, axis, rows.angular[static_cast<std::size_t>(axis)], dJointSetAMotorParam);
  }
  dJointSetBallAnchor2(joints_[body], rows.socket.x(), rows.socket.y(), rows.socket.z());
  dJointSetBallParam(joints_[body], dParamERP, joint_error_reduction(step_s));
}

void Figure::set_forces(const ReferenceState& target, double step_s, const Drive& drive) {
  for (Body body : motion::kBodies) {
    dBodySetGravityMode(bodies_[body], drive.feedforward_from ? 0 : 1);
    if (!drive.feedforward_from) continue;
    const Twist impulse = feedforward_impulse(
        figure_model_, body, drive.feedforward_from->body[body], target.body[body]);
    const Eigen::Vector3d force = impulse.linear / step_s;
    const Eigen::Vector3d torque = impulse.angular / step_s;
    dBodyAddForce(bodies_[body], force.x(), force.y(), force.z());
    dBodyAddTorque(bodies_[body], torque.x(), torque.y(), torque.z());
  }
}

void Figure::add_supports(Contacts& contacts, const ReferenceState& target, double step_s,
                          const Drive& drive) const {
  const motion::PerSide<bool> held = held_feet(figure_model_, target, drive);
  for_each_body(supported_bodies(drive), [&](Body body) {
    const BodyState now = state_of(bodies_[body]);
    const Support support = support_of(figure_model_, body, now, target.body[body], drive, held);
    for (std::size_t i = 0; i < support.count; ++i) {
      const SupportPoint& at = support.points[i];
      contacts.add_support(bodies_[body], at.point, at.depth_m, support.mass_kg, step_s);
    }
    if (!drive.is_falling || support.count == 0) return;
    const Eigen::Vector3d drag = ground_drag(figure_model_, body, now);
    dBodyAddForce(bodies_[body], drag.x(), drag.y(), drag.z());
  });
}

void Figure::set_frozen(bool frozen) {
  for (dBodyID body : bodies_) (frozen ? dBodyDisable : dBodyEnable)(body);
}

motion::PerBody<BodyState> Figure::states() const {
  motion::PerBody<BodyState> states;
  for (Body body : motion::kBodies) states[body] = state_of(bodies_[body]);
  return states;
}

motion::PerBody<MovingShape> Figure::shapes() const {
  motion::PerBody<MovingShape> result;
  for (Body body : motion::kBodies) {
    result[body] = placed_shape(figure_model_.outline[body], state_of(bodies_[body]));
  }
  return result;
}

}  // namespace flinch::sim
