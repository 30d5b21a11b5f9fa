// SPDX-License-Identifier: MIT
#include "sim/joint_tree.h"

namespace flinch::sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using motion::Body;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// An impulse at a point that is `arm` from where `impulse` is taken.
Twist moved_to(const Twist& impulse, const Vector3d& arm) {
  return {impulse.linear, impulse.angular - arm.cross(impulse.linear)};
}

Twist sum(const Twist& first, const Twist& second) {
  return {first.linear + second.linear, first.angular + second.angular};
}

// The torque of a spinning body on itself, w' taken at the end of the step h (Lacoursiere 2006), in
// the body's frame, in which its inertia I stays as it is:
//
//   I (w' - w) = h L x w',  L = I w   <=>   (I - h [L]x) w' = L
Vector3d spun(const Matrix3d& inertia, const Vector3d& angular_velocity, double step_s) {
  const Vector3d momentum = inertia * angular_velocity;
  const Matrix3d equations = inertia - step_s * cross_matrix(momentum);
  return inertia * (equations.inverse() * momentum);
}

// [A B; B^T C]^-1 with the Schur complement S = C - B^T A^-1 B:
//   [A^-1 + G S^-1 G^T, -G S^-1; -S^-1 G^T, S^-1],  G = A^-1 B.
Eigen::Matrix<double, 6, 6> inverse(const Matrix3d& mass, const Matrix3d& coupling,
                                    const Matrix3d& inertia) {
  const Matrix3d free = mass.inverse();
  const Matrix3d lever = free * coupling;
  const Matrix3d turning = (inertia - coupling.transpose() * lever).inverse();
  const Matrix3d across = -lever * turning;
  Eigen::Matrix<double, 6, 6> result;
  result << free - across * lever.transpose(), across, across.transpose(), turning;
  return result;
}

}  // namespace

FigureRows figure_rows(const FigurePlan& plan, const motion::PerBody<BodyState>& now,
                       const ReferenceState& target, double step_s) {
  FigureRows rows;
  rows.pelvis = pelvis_rows(plan, now[Body::pelvis], target.body[Body::pelvis], step_s, {});
  for (Body body : motion::kBodies) {
    const auto parent = parent_of(body);
    if (!parent) continue;
    rows.joints[body] =
        joint_rows(plan, body, now[body].orientation, now[*parent].orientation, target, step_s, 1);
  }
  return rows;
}

JointTree::JointTree(const FigurePlan& plan) : plan_(plan) {
  for (Body body : motion::kBodies) {
    Link& link = links_[body];
    link.joint_local = joint_of(plan, body);
    link.chain = set_of(body);
    if (const auto parent = parent_of(body)) {
      link.parent = *parent;
      link.chain |= links_[*parent].chain;
    }
  }
}

// With velocities v' after the step and impulses p of the rows, a body obeys
//
//   M v' = b + sum J^T p,   b = M v + h f,
//
// and a joint's rows between a child's twist u and its parent's u_p, both at the joint,
//
//   u - u_p + S p = c,   S = softness / h,
//
// three of them rigid (S = 0) and three that turn about the axes F, of which some are rigid too.
// Eliminated from the leaves to the root (Baraff, "Linear-time dynamics using Lagrange
// multipliers", 1996; with springs in the rows it is Featherstone's articulated-body recursion): if
// a child with all beyond it obeys M u = b + p, M = [A B; B^T C], then with U = [B; C]
//
//   E = F (F^T C F + D)^-1 F^T,  e = F (F^T C F + D)^-1 D c_F,  D = 1/S,  on the axes that give,
//   N = M - U E U^T,   c_0 = c on the rigid rows, else 0,
//
// its parent gains the inertia N and the impulse b - U E b_w - U e - N c_0, and on the way back
//
//   u = u_p + c_0 + (0, q),   q = E (b_w - U^T (u_p + c_0)) + e,
//
// b_w being the moment in b.
void JointTree::set_step(const motion::PerBody<BodyState>& now, const FigureRows& rows,
                         double step_s, double gravity_mps2) {
  for (Body body : motion::kBodies) {
    const BodyState& state = now[body];
    const Matrix3d turn = state.orientation.toRotationMatrix();
    const double mass_kg = static_cast<double>(plan_.model[body].mass_kg);
    mass_[body] = mass_kg * Matrix3d::Identity();
    coupling_[body].setZero();
    inertia_[body] = turn * plan_.inertia[body] * turn.transpose();
    momentum_[body].linear = mass_kg * (state.velocity - step_s * gravity_mps2 * Vector3d::UnitZ());
    momentum_[body].angular =
        turn * spun(plan_.inertia[body], turn.transpose() * state.angular_velocity, step_s);
    links_[body].to_joint = turn * links_[body].joint_local;
    if (body != Body::pelvis) {
      links_[body].parent_to_joint =
          now[links_[body].parent].orientation * rows.joints[body].socket;
    }
  }
  for (std::size_t i = motion::kBodyCount - 1; i > 0; --i) {
    const Body body = motion::kBodies[i];
    factor(rows.joints[body], now, body, step_s);
    add_to_parent(links_[body]);
  }
  Matrix3d mass = mass_[Body::pelvis];
  Matrix3d inertia = inertia_[Body::pelvis];
  Twist& momentum = momentum_[Body::pelvis];
  for (int axis = 0; axis < 3; ++axis) {
    const AxisRow& moving = rows.pelvis.moving[static_cast<std::size_t>(axis)];
    const AxisRow& turning = rows.pelvis.turning[static_cast<std::size_t>(axis)];
    mass(axis, axis) += step_s / moving.softness;
    inertia(axis, axis) += step_s / turning.softness;
    momentum.linear[axis] += step_s / moving.softness * moving.velocity;
    momentum.angular[axis] += step_s / turning.softness * turning.velocity;
  }
  root_ = inverse(mass, coupling_[Body::pelvis], inertia);
}

/// E, e and the turning part of c_0.
void JointTree::set_give(const JointRows& rows, double step_s, Link& link) {
  const auto& [first, second, third] = rows.turning;
  if (first.softness > 0 && first.softness == second.softness &&
      first.softness == third.softness) {  // the same about any axis
    const double stiffness = step_s / first.softness;
    link.give = (link.inertia + stiffness * Matrix3d::Identity()).inverse();
    link.driven =
        link.give *
        (rows.axes * (stiffness * Vector3d(first.velocity, second.velocity, third.velocity)));
    link.forced.angular.setZero();
    return;
  }
  int free = 0;
  while (free < 3 && rows.turning[static_cast<std::size_t>(free)].softness > 0) ++free;
  const Matrix3d in_axes = rows.axes.transpose() * link.inertia * rows.axes;
  Matrix3d equations = Matrix3d::Identity();
  Vector3d drive = Vector3d::Zero();
  Vector3d rigid = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const AxisRow& row = rows.turning[static_cast<std::size_t>(i)];
    if (i >= free) {
      rigid[i] = row.velocity;
      continue;
    }
    for (int j = 0; j < free; ++j) equations(i, j) = in_axes(i, j);
    equations(i, i) += step_s / row.softness;
    drive[i] = step_s / row.softness * row.velocity;
  }
  Matrix3d give = equations.inverse();
  for (int i = free; i < 3; ++i) give(i, i) = 0;
  link.give = rows.axes * give * rows.axes.transpose();
  link.driven = rows.axes * (give * drive);
  link.forced.angular = rows.axes * rigid;
}

void JointTree::factor(const JointRows& rows, const motion::PerBody<BodyState>& now, Body body,
                       double step_s) {
  Link& link = links_[body];
  // At the joint: v = v_joint + [r]x w, and the inertia with it.
  const Matrix3d arm = cross_matrix(link.to_joint);
  link.mass = mass_[body];
  link.coupling = coupling_[body] + mass_[body] * arm;
  link.inertia = inertia_[body] + coupling_[body].transpose() * arm - arm * link.coupling;

  set_give(rows, step_s, link);
  link.coupling_give = link.coupling * link.give;
  link.inertia_give = link.inertia * link.give;

  const Vector3d gap =
      now[link.parent].position + link.parent_to_joint - now[body].position - link.to_joint;
  link.forced.linear = joint_error_reduction(step_s) / step_s * gap;
}

/// N and N c_0 + U e.
void JointTree::add_to_parent(Link& link) {
  const Matrix3d mass = link.mass - link.coupling_give * link.coupling.transpose();
  const Matrix3d coupling = link.coupling - link.coupling_give * link.inertia;
  const Matrix3d inertia = link.inertia - link.inertia_give * link.inertia;
  const Twist& forced = link.forced;
  link.forced_impulse = {
      mass * forced.linear + coupling * forced.angular + link.coupling * link.driven,
      coupling.transpose() * forced.linear + inertia * forced.angular + link.inertia * link.driven};
  // At the parent's centre of mass.
  const Matrix3d arm = cross_matrix(link.parent_to_joint);
  const Matrix3d moved = coupling - mass * arm;
  mass_[link.parent] += mass;
  coupling_[link.parent] += moved;
  inertia_[link.parent] += inertia + arm * moved - coupling.transpose() * arm;
}

/// What the parent takes, at its centre of mass, of the impulse that a child has at the joint.
Twist JointTree::carried(const Link& link, const Twist& at_joint) {
  const Twist passed{at_joint.linear - link.coupling_give * at_joint.angular,
                     at_joint.angular - link.inertia_give * at_joint.angular};
  return moved_to(passed, -link.parent_to_joint);
}

motion::PerBody<Twist> JointTree::velocities(const motion::PerBody<Twist>& impulses) const {
  motion::PerBody<Twist> own;        // at the centres of mass
  motion::PerBody<Vector3d> moment;  // b_w
  for (Body body : motion::kBodies) own[body] = sum(momentum_[body], impulses[body]);
  for (std::size_t i = motion::kBodyCount - 1; i > 0; --i) {
    const Body body = motion::kBodies[i];
    const Link& link = links_[body];
    const Twist at_joint = moved_to(own[body], link.to_joint);
    moment[body] = at_joint.angular;
    Twist& parent = own[link.parent];
    parent = sum(parent, carried(link, at_joint));
    const Twist forced = moved_to(link.forced_impulse, -link.parent_to_joint);
    parent.linear -= forced.linear;
    parent.angular -= forced.angular;
  }
  motion::PerBody<Twist> after;
  Eigen::Matrix<double, 6, 1> root;
  root << own[Body::pelvis].linear, own[Body::pelvis].angular;
  root = root_ * root;
  after[Body::pelvis] = {root.head<3>(), root.tail<3>()};
  for (std::size_t i = 1; i < motion::kBodyCount; ++i) {
    const Body body = motion::kBodies[i];
    const Link& link = links_[body];
    const Twist& parent = after[link.parent];
    const Vector3d linear =
        parent.linear + parent.angular.cross(link.parent_to_joint) + link.forced.linear;
    const Vector3d angular = parent.angular + link.forced.angular;
    const Vector3d turning =
        link.give * (moment[body] - link.coupling.transpose() * linear - link.inertia * angular) +
        link.driven;
    after[body].angular = angular + turning;
    after[body].linear = linear + link.to_joint.cross(after[body].angular);
  }
  return after;
}

void JointTree::response(std::span<const Load> loads, BodySet wanted,
                         motion::PerBody<Twist>& change) const {
  motion::PerBody<Twist> own;
  motion::PerBody<Vector3d> moment;
  BodySet loaded = 0;
  for (const Load& load : loads) {
    own[load.body] = sum(own[load.body], load.impulse);
    loaded |= links_[load.body].chain;
  }
  for (std::size_t i = motion::kBodyCount - 1; i > 0; --i) {
    const Body body = motion::kBodies[i];
    if (!(loaded & set_of(body))) {
      moment[body].setZero();
      continue;
    }
    const Link& link = links_[body];
    const Twist at_joint = moved_to(own[body], link.to_joint);
    moment[body] = at_joint.angular;
    own[link.parent] = sum(own[link.parent], carried(link, at_joint));
  }
  Eigen::Matrix<double, 6, 1> root;
  root << own[Body::pelvis].linear, own[Body::pelvis].angular;
  root = root_ * root;
  change[Body::pelvis] = {root.head<3>(), root.tail<3>()};
  for (std::size_t i = 1; i < motion::kBodyCount; ++i) {
    const Body body = motion::kBodies[i];
    if (!(wanted & set_of(body))) continue;
    const Link& link = links_[body];
    const Twist& parent = change[link.parent];
    const Vector3d linear = parent.linear + parent.angular.cross(link.parent_to_joint);
    const Vector3d turning = link.give * (moment[body] - link.coupling.transpose() * linear -
                                          link.inertia * parent.angular);
    change[body].angular = parent.angular + turning;
    change[body].linear = linear + link.to_joint.cross(change[body].angular);
  }
}

}  // namespace flinch::sim
