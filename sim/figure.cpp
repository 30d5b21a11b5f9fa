// SPDX-License-Identifier: MIT
#include "sim/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/rotation.h"

namespace flinch::sim {
namespace {

using motion::Body;

// A joint's stop against its own spring: stiff enough to hold, soft enough to solve.
constexpr double kStopStiffening = 20;
// A joint bent by no more than this is as good as straight.
constexpr double kStraight_rad = 0.1;
// The pelvis is pulled and turned back as from no farther than this: what pulls it has a limit.
constexpr double kMostPelvisError_m = 0.1;
constexpr double kMostPelvisError_rad = 0.35;
// Of a fallen figure: how many points share its weight, and how soon the ground stops a part.
constexpr double kLyingPoints = 12;
constexpr double kGroundDrag_hz = 10;

/// The axes of a joint's motor in the parent's frame; the first `free` are driven by springs, the
/// others are rigid.
struct JointAxes {
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  int free = 3;
};

// A recorded knee or elbow is no pure hinge, and which way it bends depends on how the skeleton
// shares twist along the limb. So the hinge's axis is the one about which the reference bends the
// joint, or for a straight joint the anatomical one; across it the joint rigidly follows the
// reference, which loses nothing of the recording and still carries a blow from the side on.
JointAxes axes_of(JointKind kind, const JointLimits& limits, const Eigen::Quaterniond& reference) {
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

dJointID make_ball_joint(dWorldID world, dBodyID child, dBodyID parent,
                         const Eigen::Vector3d& place) {
  const dJointID joint = dJointCreateBall(world, nullptr);
  dJointAttach(joint, child, parent);
  dJointSetBallAnchor(joint, place.x(), place.y(), place.z());
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

/// Heel and toe, on the sole's middle, in the frame of the foot's centre of mass, m. Two points a
/// foot, not its corners: each costs the solver a pivot, and a foot's roll is its ankle's matter.
std::array<Eigen::Vector3d, 2> sole_ends(const MovingShape& foot) {
  const Eigen::Vector3d heel = foot.half_extents.cwiseProduct(Eigen::Vector3d(-1, 0, -1));
  const Eigen::Vector3d toe = foot.half_extents.cwiseProduct(Eigen::Vector3d(1, 0, -1));
  return {foot.centre + foot.orientation * heel, foot.centre + foot.orientation * toe};
}

/// Where a part would touch the ground first, at either end: of a box, those of the largest capsule
/// along its longest axis.
std::array<Eigen::Vector3d, 2> low_points(const MovingShape& shape) {
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

Figure::Figure(const FigurePlan& plan, dWorldID world, const ReferenceState& start) : plan_(plan) {
  for (Body body : motion::kBodies) {
    bodies_[body] =
        make_body(world, static_cast<double>(plan.model[body].mass_kg), plan.inertia[body]);
    set_state(bodies_[body], start.body[body]);
  }
  joints_[Body::pelvis] = make_linear_motor(world, bodies_[Body::pelvis]);
  motors_[Body::pelvis] =
      make_motor(world, bodies_[Body::pelvis], nullptr, Eigen::Matrix3d::Identity());
  for (Body body : motion::kBodies) {
    const auto parent = parent_of(body);
    if (!parent) continue;
    const BodyState& holder = start.body[*parent];
    joints_[body] = make_ball_joint(world, bodies_[body], bodies_[*parent],
                                    holder.position + holder.orientation * start.socket[body]);
    const Eigen::Quaterniond reference =
        holder.orientation.conjugate() * start.body[body].orientation;
    const JointAxes axes = axes_of(plan.kinds[body], plan.limits[body], reference);
    motors_[body] = make_motor(world, bodies_[body], bodies_[*parent],
                               holder.orientation.toRotationMatrix() * axes.frame);
  }
}

void Figure::drive(const ReferenceState& target, double step_s, const Drive& drive) {
  if (!fallen_) drive_pelvis(target.body[Body::pelvis], step_s, drive);
  for (Body body : motion::kBodies) {
    if (parent_of(body)) drive_joint(body, target, step_s, drive.joints);
  }
}

// A pull beyond the limit is one of softer gains: f = k e + c (w_d - w) scales with them.
void Figure::drive_pelvis(const BodyState& target, double step_s, const Drive& drive) {
  const BodyState now = state_of(bodies_[Body::pelvis]);
  const Gains turning = weakened(plan_.gains[Body::pelvis], drive.pelvis);
  Gains moving = weakened(plan_.pelvis_gains, drive.pelvis);
  const Eigen::Vector3d turn =
      shortened(motion::rotation_vector(target.orientation * now.orientation.conjugate()),
                kMostPelvisError_rad);
  const Eigen::Vector3d shift = shortened(target.position - now.position, kMostPelvisError_m);
  const double force_n =
      (moving.stiffness * shift + moving.damping * (target.velocity - now.velocity)).norm();
  if (force_n > drive.most_pelvis_force_n) {
    const double share = drive.most_pelvis_force_n / force_n;
    moving = {share * moving.stiffness, share * moving.damping};
  }
  for (int axis = 0; axis < 3; ++axis) {
    set_spring(joints_[Body::pelvis], axis, moving, moving.stiffness * shift[axis],
               target.velocity[axis], step_s, dJointSetLMotorParam);
    set_spring(motors_[Body::pelvis], axis, turning, turning.stiffness * turn[axis],
               target.angular_velocity[axis], step_s, dJointSetAMotorParam);
  }
}

// In the axes that the joint's motor has: F's columns, in the parent's frame. At a stop the springs
// along the way back stiffen, each axis by its share of that way; a stop never weakens.
void Figure::drive_joint(Body body, const ReferenceState& target, double step_s, double share) {
  const Body parent = *parent_of(body);
  const BodyState& wanted = target.body[body];
  const BodyState& wanted_parent = target.body[parent];
  const Eigen::Quaterniond to_parent = wanted_parent.orientation.conjugate();
  const Eigen::Quaterniond reference = to_parent * wanted.orientation;
  const Eigen::Quaterniond parent_now = orientation_of(bodies_[parent]);
  const Eigen::Quaterniond now = parent_now.conjugate() * orientation_of(bodies_[body]);
  const JointAxes axes = axes_of(plan_.kinds[body], plan_.limits[body], reference);
  const Eigen::Matrix3d into_axes = axes.frame.transpose();
  const Eigen::Vector3d error = into_axes * motion::rotation_vector(reference * now.conjugate());
  const Eigen::Vector3d velocity =
      into_axes * (to_parent * (wanted.angular_velocity - wanted_parent.angular_velocity));
  const Eigen::Vector3d back = into_axes * beyond_limits(plan_.limits[body], now, reference);
  const double way = back.squaredNorm();

  const dJointID motor = motors_[body];
  if (plan_.kinds[body] != JointKind::ball) {
    set_axes(motor, bodies_[parent], parent_now.toRotationMatrix() * axes.frame);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (axis >= axes.free) {
      set_rigid(motor, axis, error[axis], velocity[axis], step_s);
      continue;
    }
    Gains gains = weakened(plan_.gains[body], share);
    double pull = gains.stiffness * error[axis];
    if (way > 0) {
      const double stop =
          kStopStiffening * plan_.gains[body].stiffness * back[axis] * back[axis] / way;
      pull += stop * back[axis];
      gains.stiffness += stop;
    }
    set_spring(motor, axis, gains, pull, velocity[axis], step_s, dJointSetAMotorParam);
  }
  const Eigen::Vector3d& socket = target.socket[body];
  dJointSetBallAnchor2(joints_[body], socket.x(), socket.y(), socket.z());
  dJointSetBallParam(joints_[body], dParamERP, joint_error_reduction(step_s));
}

// Where the reference itself sinks a sole into the ground, the ground gives way that far: a fault
// of the recording must not become a force.
void Figure::stand(Contacts& contacts, const ReferenceState& target, double step_s) const {
  for (Body foot : {Body::left_foot, Body::right_foot}) {
    if (held_[foot]) continue;
    const BodyState now = state_of(bodies_[foot]);
    const BodyState& wanted = target.body[foot];
    for (const Eigen::Vector3d& end : sole_ends(plan_.outline[foot])) {
      const Eigen::Vector3d point = now.position + now.orientation * end;
      const double ground = std::min(0.0, (wanted.position + wanted.orientation * end).z());
      if (point.z() >= ground) continue;
      contacts.add_support(bodies_[foot], point, ground - point.z(), plan_.mass_kg / 4, step_s);
    }
  }
}

// What each part needs to change its momentum and its angular momentum as the reference does,
//   F = m (v_1 - v_0) / h,   T = (L_1 - L_0) / h,   L = R I R^T w,
// so that the joints bear nothing (d'Alembert).
void Figure::carry(const ReferenceState& before, const ReferenceState& after, double step_s) {
  for (Body body : motion::kBodies) {
    const BodyState& from = before.body[body];
    const BodyState& to = after.body[body];
    const auto angular_momentum = [&](const BodyState& state) {
      const Eigen::Quaterniond& turn = state.orientation;
      const Eigen::Vector3d local = turn.conjugate() * state.angular_velocity;
      return Eigen::Vector3d(turn * (plan_.inertia[body] * local));
    };
    const double mass_kg = static_cast<double>(plan_.model[body].mass_kg);
    const Eigen::Vector3d force = mass_kg / step_s * (to.velocity - from.velocity);
    const Eigen::Vector3d torque = (angular_momentum(to) - angular_momentum(from)) / step_s;
    dBodySetGravityMode(bodies_[body], 0);
    dBodyAddForce(bodies_[body], force.x(), force.y(), force.z());
    dBodyAddTorque(bodies_[body], torque.x(), torque.y(), torque.z());
  }
}

void Figure::let_fall() {
  fallen_ = true;
  dJointDisable(joints_[Body::pelvis]);
  dJointDisable(motors_[Body::pelvis]);
  for (dBodyID body : bodies_) dBodySetGravityMode(body, 1);
}

void Figure::freeze() {
  for (dBodyID body : bodies_) dBodyDisable(body);
}

// Instead of friction, which would cost the solver
// two bounded rows a point, a part that touches is slowed down as if in mud.
void Figure::lie(Contacts& contacts, double step_s) const {
  const motion::PerBody<MovingShape> outlines = shapes();
  for (Body body : motion::kBodies) {
    bool touches = false;
    for (const Eigen::Vector3d& point : low_points(outlines[body])) {
      if (point.z() >= 0) continue;
      contacts.add_support(bodies_[body], point, -point.z(), plan_.mass_kg / kLyingPoints, step_s);
      touches = true;
    }
    if (!touches) continue;
    const double drag = kGroundDrag_hz * static_cast<double>(plan_.model[body].mass_kg);
    const Eigen::Vector3d velocity = velocity_of(bodies_[body]);
    dBodyAddForce(bodies_[body], -drag * velocity.x(), -drag * velocity.y(), 0);
  }
}

motion::PerBody<MovingShape> Figure::shapes() const {
  motion::PerBody<MovingShape> result;
  for (Body body : motion::kBodies) {
    const BodyState state = state_of(bodies_[body]);
    MovingShape shape = plan_.outline[body];
    shape.centre = state.position + state.orientation * shape.centre;
    shape.orientation = state.orientation * shape.orientation;
    shape.angular_velocity = state.angular_velocity;
    shape.velocity = state.velocity + state.angular_velocity.cross(shape.centre - state.position);
    result[body] = shape;
  }
  return result;
}

}  // namespace flinch::sim
