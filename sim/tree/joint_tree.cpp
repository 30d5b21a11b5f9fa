// SPDX-License-Identifier: MIT
#include "sim/tree/joint_tree.h"

namespace flinch::sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using motion::Body;

using Vector6d = Eigen::Vector<double, 6>;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// matrix [v]x
Matrix3d times_cross(const Matrix3d& matrix, const Vector3d& v) {
  Matrix3d product;
  product.col(0) = v.z() * matrix.col(1) - v.y() * matrix.col(2);
  product.col(1) = v.x() * matrix.col(2) - v.z() * matrix.col(0);
  product.col(2) = v.y() * matrix.col(0) - v.x() * matrix.col(1);
  return product;
}

/// first second^T, for a product that is known to be symmetric.
Matrix3d symmetric_product(const Matrix3d& first, const Matrix3d& second) {
  Matrix3d product;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i <= j; ++i) {
      product(i, j) =
          first(i, 0) * second(j, 0) + first(i, 1) * second(j, 1) + first(i, 2) * second(j, 2);
      product(j, i) = product(i, j);
    }
  }
  return product;
}

/// Inverse by cofactors, which are symmetric too.
Matrix3d symmetric_inverse(const Matrix3d& m) {
  const double xx = m(1, 1) * m(2, 2) - m(1, 2) * m(1, 2);
  const double xy = m(0, 2) * m(1, 2) - m(0, 1) * m(2, 2);
  const double xz = m(0, 1) * m(1, 2) - m(0, 2) * m(1, 1);
  const double share = 1 / (m(0, 0) * xx + m(0, 1) * xy + m(0, 2) * xz);
  Matrix3d inverse;
  inverse(0, 0) = share * xx;
  inverse(1, 1) = share * (m(0, 0) * m(2, 2) - m(0, 2) * m(0, 2));
  inverse(2, 2) = share * (m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1));
  inverse(0, 1) = inverse(1, 0) = share * xy;
  inverse(0, 2) = inverse(2, 0) = share * xz;
  inverse(1, 2) = inverse(2, 1) = share * (m(0, 1) * m(0, 2) - m(0, 0) * m(1, 2));
  return inverse;
}

// Moves an inertia to the point displaced by r, whose velocity is v' = v - [r]x w. With A
// symmetric,
//   B' = B + A [r]x,   C' = C + H^T [r]x + (H^T [r]x)^T,   H = B + A [r]x / 2.
SpatialInertia moved_to(const SpatialInertia& inertia, const Vector3d& arm) {
  const Matrix3d lever = times_cross(inertia.mass, arm);
  const Matrix3d half = inertia.coupling + 0.5 * lever;
  const Matrix3d turned = times_cross(half.transpose(), arm);
  return {inertia.mass, inertia.coupling + lever, inertia.angular + turned + turned.transpose()};
}

/// Moves an impulse to the point that is displaced by `arm`.
Twist moved_to(const Twist& impulse, const Vector3d& arm) {
  return {impulse.linear, impulse.angular - arm.cross(impulse.linear)};
}

Twist sum(const Twist& first, const Twist& second) {
  return {first.linear + second.linear, first.angular + second.angular};
}

Vector6d to_vector(const Twist& twist) {
  Vector6d both;
  both << twist.linear, twist.angular;
  return both;
}

// Gyroscopic torque of a rotating body, with w' at the end of the step h (Lacoursiere 2006). In the
// body's frame, where its inertia I is constant,
//
//   I (w' - w) = h L x w',  L = I w   <=>   (I - h [L]x) w' = L,
//
// which holds in the world's axes too if all terms are in them. Returns the angular momentum I w':
Vector3d momentum_with_gyroscopic_torque(const Matrix3d& inertia, const Vector3d& angular_velocity,
                                         double step_s) {
  const Vector3d momentum = inertia * angular_velocity;
  const Matrix3d equations = inertia - step_s * cross_matrix(momentum);
  return momentum + step_s * momentum.cross(equations.inverse() * momentum);
}

// Spatial inertia of a rigid body at a point r from its centre of mass:  [m, m [r]x; sym., I + m
// (r^2 - r r^T)].
SpatialInertia rigid_inertia(double mass_kg, const Matrix3d& inertia, const Vector3d& arm) {
  const Vector3d moment = mass_kg * arm;
  SpatialInertia rigid{mass_kg * Matrix3d::Identity(), cross_matrix(moment),
                       inertia - moment * arm.transpose()};
  rigid.angular.diagonal().array() += moment.dot(arm);
  return rigid;
}

// [A B; B^T C]^-1 by the Schur complement S = C - B^T A^-1 B:
//   [A^-1 + G S^-1 G^T, -G S^-1; -S^-1 G^T, S^-1],  G = A^-1 B.
Eigen::Matrix<double, 6, 6> inverse(const SpatialInertia& inertia) {
  const Matrix3d free = symmetric_inverse(inertia.mass);
  const Matrix3d lever = free * inertia.coupling;
  const Matrix3d angular = symmetric_inverse(
      inertia.angular - symmetric_product(inertia.coupling.transpose(), lever.transpose()));
  const Matrix3d across = -lever * angular;
  Eigen::Matrix<double, 6, 6> result;
  result << free - symmetric_product(across, lever), across, across.transpose(), angular;
  return result;
}

/// Response of a joint's rotation to moments, given its angular rows.
struct JointMobility {
  Matrix3d mobility;               ///< E
  Vector3d bias;                   ///< e
  Vector3d prescribed;             ///< the angular part of c_0
  double isotropic_stiffness = 0;  ///< D where it is the same about every axis; else 0
};

/// Mobility of a joint whose three axes have the same stiffness.
JointMobility isotropic_mobility(const JointRows& rows, double step_s, const Matrix3d& angular) {
  const auto& [first, second, third] = rows.angular;
  const double stiffness = step_s / first.softness;
  const Matrix3d share = symmetric_inverse(angular + stiffness * Matrix3d::Identity());
  const Vector3d wanted(first.velocity, second.velocity, third.velocity);
  return {share, share * (rows.axes * (stiffness * wanted)), Vector3d::Zero(), stiffness};
}

JointMobility joint_mobility(const JointRows& rows, double step_s, const Matrix3d& angular) {
  const auto& [first, second, third] = rows.angular;
  if (first.softness > 0 && first.softness == second.softness && first.softness == third.softness) {
    return isotropic_mobility(rows, step_s, angular);
  }
  int free = 0;
  while (free < 3 && rows.angular[static_cast<std::size_t>(free)].softness > 0) ++free;
  const Matrix3d in_axes = rows.axes.transpose() * angular * rows.axes;
  Matrix3d equations = Matrix3d::Identity();
  Vector3d drive = Vector3d::Zero();
  Vector3d rigid = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const AxisRow& row = rows.angular[static_cast<std::size_t>(i)];
    if (i >= free) {
      rigid[i] = row.velocity;
      continue;
    }
    for (int j = 0; j < free; ++j) equations(i, j) = in_axes(i, j);
    equations(i, i) += step_s / row.softness;
    drive[i] = step_s / row.softness * row.velocity;
  }
  Matrix3d share = symmetric_inverse(equations);
  for (int i = free; i < 3; ++i) share(i, i) = 0;
  return {symmetric_product(rows.axes * share, rows.axes), rows.axes * (share * drive),
          rows.axes * rigid, 0};
}

}  // namespace

JointTree::JointTree(const FigureModel& figure_model) : figure_model_(figure_model) {
  for (Body body : motion::kBodies) {
    Link& link = links_[body];
    link.chain = set_of(body);
    if (const auto parent = parent_of(body)) {
      link.joint_local = joint_offset(figure_model, body);
      link.parent = *parent;
      link.chain |= links_[*parent].chain;
    }
  }
}

// Featherstone's articulated-body algorithm, with springs in the joints and over a whole step. With
// velocities v' after the step and impulses p of the rows, a body obeys
//
//   M v' = b + sum J^T p,   b = M v + h f,
//
// and a joint's rows between a child's twist u and its parent's u_p, both at the joint,
//
//   u - u_p + S p = c,   S = softness / h,
//
// where three rows are linear and rigid (S = 0) and three are angular, about the axes F, some of
// them rigid too. The first pass eliminates the joints from the leaves to the root (Baraff,
// "Linear-time dynamics using Lagrange multipliers", 1996). Let a child and its descendants obey M
// u = b + M c_0 + p, where M = [A B; B^T C] is the articulated-body inertia, b the bias impulse,
// and c_0 = c on the rigid rows, else 0. With U = [B; C]
//
//   E = F (F^T C F + D)^-1 F^T,  e = F (F^T C F + D)^-1 D c_F,  D = 1/S,  on the axes that are not
//   rigid,
//   t = E b_w + e,
//
// its parent gains the articulated inertia and the bias impulse
//
//   N = M - U E U^T,   b - U t,
//
// The second pass, from the root to the leaves, gives
//
//   u = u_p + c_0 + (0, q),   q = t - (U E)^T u_p,
//
// where b_w is the moment in b. If D is the same about all three axes, 1 - E C = D E and so
//
//   N = [A - B E B^T, D B E; sym., D C E]
//
// where C E is symmetric. An impulse f on the bodies changes b, t and the root's velocity linearly:
// propagated alone, it leaves an impulse f_0 at the root and a moment m at each joint. So the
// inverse inertia is a sum of one term for the root and one per joint (inverse_inertia_product,
// propagate, add),
//
//   f^T M^-1 g = f_0^T M_0^-1 g_0 + sum m_f^T E m_g.
//
// A spring to the world has rows u + S p = c with the body's own twist u. Eliminated too, they add
// D to the body's inertia and D c to its bias impulse.
void JointTree::set_step(const motion::PerBody<BodyState>& now, const FigureRows& rows,
                         double step_s, double gravity_mps2, BodySet pushed,
                         const motion::PerBody<Twist>& impulses) {
  for (Body body : motion::kBodies) {
    const BodyState& state = now[body];
    const Matrix3d turn = state.orientation.toRotationMatrix();
    const double mass_kg = static_cast<double>(figure_model_.model[body].mass_kg);
    Link& link = links_[body];
    link.to_joint = turn * link.joint_local;
    if (body != Body::pelvis) {
      link.parent_to_joint = now[link.parent].orientation * rows.joints[body].socket;
      link.joint_to_joint = link.parent_to_joint - links_[link.parent].to_joint;
    }
    const Matrix3d inertia = symmetric_product(turn * figure_model_.inertia[body], turn);
    inertia_[body] = rigid_inertia(mass_kg, inertia, link.to_joint);
    Twist momentum{mass_kg * (state.velocity - step_s * gravity_mps2 * Vector3d::UnitZ()),
                   momentum_with_gyroscopic_torque(inertia, state.angular_velocity, step_s)};
    if (pushed & set_of(body)) momentum = sum(momentum, impulses[body]);
    momentum_[body] = moved_to(momentum, link.to_joint);
  }
  for (motion::Side side : motion::kSides) {
    if (rows.feet[side]) anchor(foot_of(side), *rows.feet[side], step_s);
  }
  for (std::size_t i = motion::kBodyCount - 1; i > 0; --i) {
    const Body body = motion::kBodies[i];
    factor(rows.joints[body], now, body, step_s);
  }
  if (rows.pelvis) anchor(Body::pelvis, *rows.pelvis, step_s);
  root_inverse_inertia_ = inverse(inertia_[Body::pelvis]);
  root_velocity_ = root_inverse_inertia_ * to_vector(momentum_[Body::pelvis]);
}

// The springs act at the centre of mass, which the pelvis moves about.
void JointTree::anchor(Body body, const AnchorRows& rows, double step_s) {
  SpatialInertia& inertia = inertia_[body];
  Twist& momentum = momentum_[body];
  const Vector3d& to_joint = links_[body].to_joint;
  if (body != Body::pelvis) {
    inertia = moved_to(inertia, -to_joint);
    momentum = moved_to(momentum, -to_joint);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const AxisRow& linear = rows.linear[static_cast<std::size_t>(axis)];
    const AxisRow& angular = rows.angular[static_cast<std::size_t>(axis)];
    inertia.mass(axis, axis) += step_s / linear.softness;
    inertia.angular(axis, axis) += step_s / angular.softness;
    momentum.linear[axis] += step_s / linear.softness * linear.velocity;
    momentum.angular[axis] += step_s / angular.softness * angular.velocity;
  }
  if (body != Body::pelvis) {
    inertia = moved_to(inertia, to_joint);
    momentum = moved_to(momentum, to_joint);
  }
}

void JointTree::factor(const JointRows& rows, const motion::PerBody<BodyState>& now, Body body,
                       double step_s) {
  Link& link = links_[body];
  const auto& [mass, coupling, angular] = inertia_[body];
  const JointMobility joint = joint_mobility(rows, step_s, angular);
  link.mobility = joint.mobility;
  link.coupling_mobility = coupling * joint.mobility;
  const Vector3d gap =
      now[link.parent].position + link.parent_to_joint - now[body].position - link.to_joint;
  link.prescribed = {joint_error_reduction(step_s) / step_s * gap, joint.prescribed};

  SpatialInertia projected;
  projected.mass = mass - symmetric_product(link.coupling_mobility, coupling);
  if (joint.isotropic_stiffness > 0) {
    link.angular_mobility = symmetric_product(angular, joint.mobility);
    projected.coupling = joint.isotropic_stiffness * link.coupling_mobility;
    projected.angular = joint.isotropic_stiffness * link.angular_mobility;
  } else {
    link.angular_mobility = angular * joint.mobility;
    projected.coupling = coupling - link.coupling_mobility * angular;
    projected.angular = angular - symmetric_product(link.angular_mobility, angular);
  }

  const Twist& own = momentum_[body];
  const Twist& prescribed = link.prescribed;
  const Twist free{
      own.linear - mass * prescribed.linear - coupling * prescribed.angular,
      own.angular - coupling.transpose() * prescribed.linear - angular * prescribed.angular};
  link.angular = link.mobility * free.angular + joint.bias;
  const Twist to_parent{free.linear - coupling * link.angular,
                        free.angular - angular * link.angular};

  Twist& momentum = momentum_[link.parent];
  momentum = sum(momentum, moved_to(to_parent, -link.joint_to_joint));
  const SpatialInertia at_parent = moved_to(projected, -link.joint_to_joint);
  SpatialInertia& parent = inertia_[link.parent];
  parent.mass += at_parent.mass;
  parent.coupling += at_parent.coupling;
  parent.angular += at_parent.angular;
}

void JointTree::propagate(std::span<const BodyImpulse> body_impulses,
                          PropagatedImpulse& propagated) const {
  motion::PerBody<Twist> own;  // at the joints
  propagated.chain = 0;
  for (const BodyImpulse& body_impulse : body_impulses) {
    own[body_impulse.body] = sum(
        own[body_impulse.body], moved_to(body_impulse.impulse, links_[body_impulse.body].to_joint));
    propagated.chain |= links_[body_impulse.body].chain;
  }
  for (std::size_t i = motion::kBodyCount - 1; i > 0; --i) {
    const Body body = motion::kBodies[i];
    if (!(propagated.chain & set_of(body))) continue;
    const Link& link = links_[body];
    const Twist& at_joint = own[body];
    propagated.moment[body] = at_joint.angular;
    propagated.angular[body] = link.mobility * at_joint.angular;
    const Twist to_parent{at_joint.linear - link.coupling_mobility * at_joint.angular,
                          at_joint.angular - link.angular_mobility * at_joint.angular};
    own[link.parent] = sum(own[link.parent], moved_to(to_parent, -link.joint_to_joint));
  }
  propagated.root_impulse = to_vector(own[Body::pelvis]);
  // The rows of a ball on the ground pass on nothing, also before the first step has set the
  // inertia.
  if (propagated.chain == 0) {
    propagated.root_velocity_change.setZero();
  } else {
    propagated.root_velocity_change = root_inverse_inertia_ * propagated.root_impulse;
  }
}

double JointTree::inverse_inertia_product(const PropagatedImpulse& first,
                                          const PropagatedImpulse& second) {
  double sum = first.root_impulse.dot(second.root_velocity_change);
  for_each_body(first.chain & second.chain & ~set_of(Body::pelvis),
                [&](Body body) { sum += first.moment[body].dot(second.angular[body]); });
  return sum;
}

void JointTree::add(const PropagatedImpulse& propagated, double size) {
  root_velocity_ += size * propagated.root_velocity_change;
  for_each_body(propagated.chain & ~set_of(Body::pelvis),
                [&](Body body) { links_[body].angular += size * propagated.angular[body]; });
}

void JointTree::velocities(BodySet wanted, motion::PerBody<Twist>& after) const {
  after[Body::pelvis] = {root_velocity_.head<3>(), root_velocity_.tail<3>()};
  for_each_body(wanted & ~set_of(Body::pelvis), [&](Body body) {
    const Link& link = links_[body];
    const Twist& parent = after[link.parent];
    const Vector3d linear = parent.linear + parent.angular.cross(link.parent_to_joint);
    const Vector3d angular = parent.angular + link.prescribed.angular + link.angular -
                             link.coupling_mobility.transpose() * linear -
                             link.angular_mobility.transpose() * parent.angular;
    after[body].angular = angular;
    after[body].linear = linear + link.prescribed.linear + link.to_joint.cross(angular);
  });
}

}  // namespace flinch::sim
