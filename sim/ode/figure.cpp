// SPDX-License-Identifier: MIT
#include "sim/ode/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flinch::sim {
namespace {

using motion::Body;

// Of a fallen figure: number of points that share its weight, and how fast the ground stops a part.
constexpr double kFallenContactPoints = 12;
constexpr double kGroundDrag_hz = 10;

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

/// Points at either end of a part that would touch the ground first; for a box, those of the
/// largest capsule along its longest axis.
std::array<Eigen::Vector3d, 2> lowest_end_points(const MovingShape& shape) {
  double radius = shape.radius;
  Eigen::Vector3d end(0, 0, shape.half_length);
  if (shape.kind == motion::Shape::Kind::box) {
    int longest = 0;
    const double half_length = shape.half_extents.maxCoeff(&longest);
    radius = shape.half_extents.minCoeff();
    end = (half_length - radius) * Eigen::Vector3d::Unit(longest);
  }
  const Eigen::Vector3d low = shape.centre - radius * Eigen::Vector3d::UnitZ();
  return {low + shape.orientation * end, low - shape.orientation * end};
}

}  // namespace

Figure::Figure(const FigureModel& figure_model, dWorldID world, const ReferenceState& start)
    : figure_model_(figure_model) {
  for (Body body : motion::kBodies) {
    bodies_[body] = make_body(world, static_cast<double>(figure_model.model[body].mass_kg),
                              figure_model.inertia[body]);
    set_state(bodies_[body], start.body[body]);
  }
  joints_[Body::pelvis] = make_linear_motor(world, bodies_[Body::pelvis]);
  motors_[Body::pelvis] =
      make_motor(world, bodies_[Body::pelvis], nullptr, Eigen::Matrix3d::Identity());
  for (Body body : motion::kBodies) {
    const auto parent = parent_of(body);
    if (!parent) continue;
    const BodyState& parent_state = start.body[*parent];
    joints_[body] =
        make_ball_joint(world, bodies_[body], bodies_[*parent],
                        parent_state.position + parent_state.orientation * start.socket[body]);
    motors_[body] =
        make_motor(world, bodies_[body], bodies_[*parent],
                   parent_state.orientation.toRotationMatrix());  // others: see set_motors
  }
}

void Figure::set_motors(const ReferenceState& target, double step_s,
                        const MotorStrength& strength) {
  if (!fallen_) set_pelvis_motor(target.body[Body::pelvis], step_s, strength);
  for (Body body : motion::kBodies) {
    if (parent_of(body)) set_joint_motor(body, target, step_s, strength.joints);
  }
}

void Figure::set_pelvis_motor(const BodyState& target, double step_s,
                              const MotorStrength& strength) {
  const PelvisRows rows =
      pelvis_rows(figure_model_, state_of(bodies_[Body::pelvis]), target, step_s, strength);
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    set_row(joints_[Body::pelvis], axis, rows.linear[at], dJointSetLMotorParam);
    set_row(motors_[Body::pelvis], axis, rows.angular[at], dJointSetAMotorParam);
  }
}

void Figure::set_joint_motor(Body body, const ReferenceState& target, double step_s, double share) {
  const dBodyID parent = bodies_[*parent_of(body)];
  const JointRows rows = joint_rows(figure_model_, body, orientation_of(bodies_[body]),
                                    orientation_of(parent), target, step_s, share);
  const dJointID motor = motors_[body];
  if (figure_model_.kinds[body] != JointKind::ball) set_axes(motor, parent, rows.axes);
  for (int axis = 0; axis < 3; ++axis) {
    set_row(motor, axis, rows.angular[static_cast<std::size_t>(axis)], dJointSetAMotorParam);
  }
  dJointSetBallAnchor2(joints_[body], rows.socket.x(), rows.socket.y(), rows.socket.z());
  dJointSetBallParam(joints_[body], dParamERP, joint_error_reduction(step_s));
}

void Figure::add_foot_support(Contacts& contacts, const ReferenceState& target,
                              double step_s) const {
  for (Body foot : {Body::left_foot, Body::right_foot}) {
    if (locked_[foot]) continue;
    const FootSupport support =
        foot_support(figure_model_, foot, state_of(bodies_[foot]), target.body[foot]);
    for (std::size_t i = 0; i < support.count; ++i) {
      const auto& [body, point, depth_m] = support.points[i];
      contacts.add_support(bodies_[body], point, depth_m, figure_model_.mass_kg / 4, step_s);
    }
  }
}

// Force and torque that change each part's momentum and angular momentum as the reference does,
//   F = m (v_1 - v_0) / h,   T = (L_1 - L_0) / h,   L = R I R^T w,
// so that the joints carry no load (d'Alembert's principle).
void Figure::add_feedforward(const ReferenceState& before, const ReferenceState& after,
                             double step_s) {
  for (Body body : motion::kBodies) {
    const BodyState& from = before.body[body];
    const BodyState& to = after.body[body];
    const auto angular_momentum = [&](const BodyState& state) {
      const Eigen::Quaterniond& turn = state.orientation;
      const Eigen::Vector3d local = turn.conjugate() * state.angular_velocity;
      return Eigen::Vector3d(turn * (figure_model_.inertia[body] * local));
    };
    const double mass_kg = static_cast<double>(figure_model_.model[body].mass_kg);
    const Eigen::Vector3d force = mass_kg / step_s * (to.velocity - from.velocity);
    const Eigen::Vector3d torque = (angular_momentum(to) - angular_momentum(from)) / step_s;
    dBodySetGravityMode(bodies_[body], 0);
    dBodyAddForce(bodies_[body], force.x(), force.y(), force.z());
    dBodyAddTorque(bodies_[body], torque.x(), torque.y(), torque.z());
  }
}

void Figure::start_falling() {
  fallen_ = true;
  dJointDisable(joints_[Body::pelvis]);
  dJointDisable(motors_[Body::pelvis]);
  for (dBodyID body : bodies_) dBodySetGravityMode(body, 1);
}

void Figure::freeze() {
  for (dBodyID body : bodies_) dBodyDisable(body);
}

// Viscous damping of the parts that touch replaces friction, which would cost the solver two
// bounded rows per point.
void Figure::add_fallen_support(Contacts& contacts, double step_s) const {
  const motion::PerBody<MovingShape> outlines = shapes();
  for (Body body : motion::kBodies) {
    bool touches = false;
    for (const Eigen::Vector3d& point : lowest_end_points(outlines[body])) {
      if (point.z() >= 0) continue;
      contacts.add_support(bodies_[body], point, -point.z(),
                           figure_model_.mass_kg / kFallenContactPoints, step_s);
      touches = true;
    }
    if (!touches) continue;
    const double drag = kGroundDrag_hz * static_cast<double>(figure_model_.model[body].mass_kg);
    const Eigen::Vector3d velocity = velocity_of(bodies_[body]);
    dBodyAddForce(bodies_[body], -drag * velocity.x(), -drag * velocity.y(), 0);
  }
}

motion::PerBody<MovingShape> Figure::shapes() const {
  motion::PerBody<MovingShape> result;
  for (Body body : motion::kBodies) {
    result[body] = placed_shape(figure_model_.outline[body], state_of(bodies_[body]));
  }
  return result;
}

}  // namespace flinch::sim
