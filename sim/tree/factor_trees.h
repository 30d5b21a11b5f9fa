// SPDX-License-Identifier: MIT
// The source of factor_trees(), included once by a file per instruction set; see lane_algebra.h.
#pragma once

#include "sim/tree/row_lanes.h"

namespace flinch::sim {
namespace {

/// Spatial inertia [mass coupling; coupling^T angular] at a point, as SpatialInertia.
template <class N>
struct Inertia {
  SymmetricMatrix<N> mass;
  Matrix<N> coupling;
  SymmetricMatrix<N> angular;
};
/// An impulse and its moment, or a velocity and an angular velocity.
template <class N>
struct Pair {
  Vector<N> linear, angular;
};

// Moves an inertia to the point displaced by r, whose velocity is v' = v - [r]x w. With A
// symmetric,
//   B' = B + A [r]x,   C' = C + H^T [r]x + (H^T [r]x)^T,   H = B + A [r]x / 2.
template <class N>
Inertia<N> moved(const Inertia<N>& inertia, const Vector<N>& arm) {
  const Matrix<N> lever = times_cross(full(inertia.mass), arm);
  const Matrix<N> half = inertia.coupling + scaled(0.5, lever);
  const Matrix<N> turned = times_cross(transposed(half), arm);
  return {inertia.mass, inertia.coupling + lever,
          inertia.angular + upper(turned + transposed(turned))};
}
/// Moves an impulse to the point that is displaced by `arm`.
template <class N>
Pair<N> moved(const Pair<N>& impulse, const Vector<N>& arm) {
  return {impulse.linear, impulse.angular - cross(arm, impulse.linear)};
}
template <class N>
Inertia<N> operator+(const Inertia<N>& a, const Inertia<N>& b) {
  return {a.mass + b.mass, a.coupling + b.coupling, a.angular + b.angular};
}
template <class N>
Pair<N> operator+(const Pair<N>& a, const Pair<N>& b) {
  return {a.linear + b.linear, a.angular + b.angular};
}

// Spatial inertia of a rigid body at a point r from its centre of mass:  [m, m [r]x; sym., I + m
// (r^2 - r r^T)].
template <class N>
Inertia<N> rigid(double mass_kg, const SymmetricMatrix<N>& inertia, const Vector<N>& arm) {
  const Vector<N> m = mass_kg * arm;
  const N zero = m.x * 0.0;
  const N mass = zero + mass_kg;
  const N square = dot(m, arm);
  return {{mass, mass, mass, zero, zero, zero},
          {{zero, m.z, -m.y}, {-m.z, zero, m.x}, {m.y, -m.x, zero}},
          {inertia.xx + (square - m.x * arm.x), inertia.yy + (square - m.y * arm.y),
           inertia.zz + (square - m.z * arm.z), inertia.xy - m.x * arm.y, inertia.xz - m.x * arm.z,
           inertia.yz - m.y * arm.z}};
}

// Gyroscopic torque of a rotating body, with w' at the end of the step h (Lacoursiere 2006). In the
// body's frame, where its inertia I is constant,
//
//   I (w' - w) = h L x w',  L = I w   <=>   (I - h [L]x) w' = L,
//
// which holds in the world's axes too if all terms are in them. Returns the angular momentum I w'.
template <class N>
Vector<N> momentum_with_gyroscopic_torque(const SymmetricMatrix<N>& inertia,
                                          const Vector<N>& angular_velocity, const N& step_s) {
  const Vector<N> momentum = inertia * angular_velocity;
  const Vector<N> turn = step_s * momentum;
  const N zero = turn.x * 0.0;
  const Matrix<N> cross_turn{
      {zero, turn.z, -turn.y}, {-turn.z, zero, turn.x}, {turn.y, -turn.x, zero}};
  return momentum + cross(turn, solved(full(inertia) - cross_turn, momentum));
}

/// Response of a joint to moments, and what its parent gains, as factor_lanes() derives them.
template <class N>
struct FactoredJoint {
  SymmetricMatrix<N> mobility;  // E
  Matrix<N> coupling_mobility;  // B E
  Matrix<N> angular_mobility;   // C E
  Vector<N> bias;               // e
  Vector<N> prescribed;         // the angular part of c_0
  Inertia<N> projected;         // N
};

// A joint with springs about all three axes F: K = F D F^T is their stiffness, and
//   E = (C + K)^-1,   1 - E C = E K,   N = [A - B E B^T, B E K; sym., C E K].
// Mostly all three are alike, K = D; then K's products are those with a number.
template <class N>
FactoredJoint<N> factor_ball(const Inertia<N>& inertia, const SpringRows<N>& rows) {
  const auto& [axes, stiffness, drive, alike] = rows;
  const bool all_alike = holds_everywhere(alike);
  const N zero = stiffness.x * 0.0;
  SymmetricMatrix<N> spring{stiffness.x, stiffness.x, stiffness.x, zero, zero, zero};
  if (!all_alike) {
    spring = select(alike, spring,
                    scaled(stiffness.x, square(axes.x)) + scaled(stiffness.y, square(axes.y)) +
                        scaled(stiffness.z, square(axes.z)));
  }
  FactoredJoint<N> joint;
  joint.mobility = inverse(inertia.angular + spring);
  const Matrix<N> mobility = full(joint.mobility);
  joint.coupling_mobility = inertia.coupling * mobility;
  joint.angular_mobility = full(inertia.angular) * mobility;
  joint.bias = mobility * (axes * drive);
  joint.prescribed = {zero, zero, zero};
  auto& [mass, coupling, angular] = joint.projected;
  mass = inertia.mass - symmetric_product(joint.coupling_mobility, inertia.coupling);
  coupling = scaled(stiffness.x, joint.coupling_mobility);
  angular = scaled(stiffness.x, upper(joint.angular_mobility));
  if (!all_alike) {
    coupling = select(alike, coupling, joint.coupling_mobility * full(spring));
    angular = select(alike, angular, symmetric_product(joint.angular_mobility, full(spring)));
  }
  return joint;
}

// A joint with springs about its first one or two axes, and rigid about the others.
template <class N>
FactoredJoint<N> factor_hinge(const Inertia<N>& inertia, const SpringRows<N>& rows, int free_axes) {
  const auto& [axes, stiffness, drive, alike] = rows;
  const Vector<N> along = inertia.angular * axes.x;
  const N first = dot(axes.x, along) + stiffness.x;
  FactoredJoint<N> joint;
  if (free_axes == 0) {
    const N zero = 0.0 * first;
    joint.mobility = {zero, zero, zero, zero, zero, zero};
    joint.bias = {zero, zero, zero};
    joint.prescribed = drive.x * axes.x + drive.y * axes.y + drive.z * axes.z;
  } else if (free_axes == 1) {
    const Vector<N> row = (1.0 / first) * axes.x;
    joint.mobility = {row.x * axes.x.x, row.y * axes.x.y, row.z * axes.x.z,
                      row.x * axes.x.y, row.x * axes.x.z, row.y * axes.x.z};
    joint.bias = drive.x * row;
    joint.prescribed = drive.y * axes.y + drive.z * axes.z;
  } else {
    const N across = dot(axes.y, along);
    const N second = dot(axes.y, inertia.angular * axes.y) + stiffness.y;
    const N share = 1.0 / (first * second - across * across);
    const Vector<N> row = (share * second) * axes.x - (share * across) * axes.y;
    const Vector<N> other = (share * first) * axes.y - (share * across) * axes.x;
    joint.mobility = {row.x * axes.x.x + other.x * axes.y.x, row.y * axes.x.y + other.y * axes.y.y,
                      row.z * axes.x.z + other.z * axes.y.z, row.x * axes.x.y + other.x * axes.y.y,
                      row.x * axes.x.z + other.x * axes.y.z, row.y * axes.x.z + other.y * axes.y.z};
    joint.bias = drive.x * row + drive.y * other;
    joint.prescribed = drive.z * axes.z;
  }
  const Matrix<N> mobility = full(joint.mobility);
  const Matrix<N> angular = full(inertia.angular);
  joint.coupling_mobility = inertia.coupling * mobility;
  joint.angular_mobility = angular * mobility;
  joint.projected = {inertia.mass - symmetric_product(joint.coupling_mobility, inertia.coupling),
                     inertia.coupling - joint.coupling_mobility * angular,
                     inertia.angular - symmetric_product(joint.angular_mobility, angular)};
  return joint;
}

/// Springs to the world, at the centre of mass: D, and the impulse D c.
template <class N>
struct AnchorSprings {
  Inertia<N> stiffness;
  Pair<N> impulse;
};
template <std::size_t kLanes, class N = Number<kLanes>>
AnchorSprings<N> springs_of(const typename TreeLanes<kLanes>::Anchor& anchor, const N& step_s) {
  const auto stiffness = [&](const double(&softness)[3][kLanes]) {
    return Vector<N>{step_s / load(softness[0]), step_s / load(softness[1]),
                     step_s / load(softness[2])};
  };
  const auto times = [](const Vector<N>& a, const Vector<N>& b) {
    return Vector<N>{a.x * b.x, a.y * b.y, a.z * b.z};
  };
  const Vector<N> linear = stiffness(anchor.softness);
  const Vector<N> angular = stiffness(anchor.angular_softness);
  const N zero = linear.x * 0.0;
  const Vector<N> zeros{zero, zero, zero};
  return {{{linear.x, linear.y, linear.z, zero, zero, zero},
           {zeros, zeros, zeros},
           {angular.x, angular.y, angular.z, zero, zero, zero}},
          {times(linear, load(anchor.velocity)), times(angular, load(anchor.angular_velocity))}};
}

// [A B; B^T C]^-1 by the Schur complement S = C - B^T A^-1 B:
//   [A^-1 + G S^-1 G^T, -G S^-1; -S^-1 G^T, S^-1],  G = A^-1 B.
template <std::size_t kLanes, class N = Number<kLanes>>
void solve_root(const Inertia<N>& inertia, const Pair<N>& momentum, TreeLanes<kLanes>& lanes) {
  const SymmetricMatrix<N> free = inverse(inertia.mass);
  const Matrix<N> lever = full(free) * inertia.coupling;
  const SymmetricMatrix<N> angular =
      inverse(inertia.angular - symmetric_product(transposed(inertia.coupling), transposed(lever)));
  const Matrix<N> across = scaled(-1.0, lever * full(angular));
  const Matrix<N> linear = full(free - symmetric_product(across, lever));
  const Vector<N> columns[6][2] = {
      {linear.x, transposed(across).x}, {linear.y, transposed(across).y},
      {linear.z, transposed(across).z}, {across.x, full(angular).x},
      {across.y, full(angular).y},      {across.z, full(angular).z}};
  for (std::size_t column = 0; column < 6; ++column) {
    const auto& [upper_half, lower_half] = columns[column];
    store(upper_half.x, lanes.root_inverse_inertia[column][0]);
    store(upper_half.y, lanes.root_inverse_inertia[column][1]);
    store(upper_half.z, lanes.root_inverse_inertia[column][2]);
    store(lower_half.x, lanes.root_inverse_inertia[column][3]);
    store(lower_half.y, lanes.root_inverse_inertia[column][4]);
    store(lower_half.z, lanes.root_inverse_inertia[column][5]);
  }
  const Vector<N> velocity = linear * momentum.linear + across * momentum.angular;
  const Vector<N> turn = transposed_times(across, momentum.linear) + angular * momentum.angular;
  store(velocity.x, lanes.root_velocity[0]);
  store(velocity.y, lanes.root_velocity[1]);
  store(velocity.z, lanes.root_velocity[2]);
  store(turn.x, lanes.root_velocity[3]);
  store(turn.y, lanes.root_velocity[4]);
  store(turn.z, lanes.root_velocity[5]);
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
template <std::size_t kLanes>
void factor_lanes(const TreeConstants& constants, TreeLanes<kLanes>& lanes) {
  using N = Number<kLanes>;
  constexpr std::size_t kBodies = TreeConstants::kBodies;
  const N step_s = load(lanes.step_s);
  const N fall = step_s * load(lanes.gravity_mps2);
  const N correction = load(lanes.joint_correction);
  Matrix<N> turns[kBodies];
  Inertia<N> inertias[kBodies];  // at the joints; of the pelvis at its centre of mass
  Pair<N> momenta[kBodies];
  for (std::size_t body = 0; body < kBodies; ++body) {
    const auto& now = lanes.bodies[body];
    const TreeConstants::Body& constant = constants.bodies[body];
    auto& link = lanes.links[body];
    const Matrix<N> turn = rotation(load(now.orientation));
    turns[body] = turn;
    const double* joint = constant.joint;
    const Vector<N> to_joint = joint[0] * turn.x + joint[1] * turn.y + joint[2] * turn.z;
    store(to_joint, link.to_joint);
    const double* own = constant.inertia;
    const Matrix<N> turned{own[0] * turn.x + own[3] * turn.y + own[4] * turn.z,
                           own[3] * turn.x + own[1] * turn.y + own[5] * turn.z,
                           own[4] * turn.x + own[5] * turn.y + own[2] * turn.z};
    const SymmetricMatrix<N> inertia = symmetric_product(turned, turn);
    inertias[body] = rigid(constant.mass_kg, inertia, to_joint);
    const Vector<N> velocity = load(now.velocity);
    const Pair<N> momentum{
        constant.mass_kg * Vector<N>{velocity.x, velocity.y, velocity.z - fall},
        momentum_with_gyroscopic_torque(inertia, load(now.angular_velocity), step_s)};
    momenta[body] =
        moved(momentum + Pair<N>{load(now.impulse), load(now.angular_impulse)}, to_joint);
    if (body == 0) continue;
    const Vector<N> parent_to_joint = turns[constant.parent] * load(now.socket);
    store(parent_to_joint, link.parent_to_joint);
    store(parent_to_joint - load(lanes.links[constant.parent].to_joint), link.joint_to_joint);
    const Vector<N> parent_position = load(lanes.bodies[constant.parent].position);
    store(correction * (parent_position + parent_to_joint - load(now.position) - to_joint),
          link.prescribed);
  }
  for (std::size_t i = 1; i < 3; ++i) {
    const std::size_t foot = kAnchored[i];
    const AnchorSprings<N> springs = springs_of<kLanes>(lanes.anchors[i], step_s);
    const Vector<N> to_joint = load(lanes.links[foot].to_joint);
    inertias[foot] = inertias[foot] + moved(springs.stiffness, to_joint);
    momenta[foot] = momenta[foot] + moved(springs.impulse, to_joint);
  }
  for (std::size_t body = kBodies - 1; body > 0; --body) {
    const TreeConstants::Body& constant = constants.bodies[body];
    auto& link = lanes.links[body];
    const Inertia<N>& own = inertias[body];
    const SpringRows<N> rows = spring_rows(constant, lanes, body, turns[constant.parent]);
    const FactoredJoint<N> joint = constant.free_axes == 3
                                       ? factor_ball(own, rows)
                                       : factor_hinge(own, rows, constant.free_axes);
    store(joint.mobility, link.mobility);
    store(joint.coupling_mobility, link.coupling_mobility);
    store(joint.angular_mobility, link.angular_mobility);
    store(joint.prescribed, link.prescribed_angular);

    const Vector<N> prescribed = load(link.prescribed);
    const Pair<N>& momentum = momenta[body];
    const Pair<N> free{momentum.linear - own.mass * prescribed - own.coupling * joint.prescribed,
                       momentum.angular - transposed_times(own.coupling, prescribed) -
                           own.angular * joint.prescribed};
    const Vector<N> angular = joint.mobility * free.angular + joint.bias;
    store(angular, link.angular);
    const Pair<N> to_parent{free.linear - own.coupling * angular,
                            free.angular - own.angular * angular};
    const Vector<N> arm = -load(link.joint_to_joint);
    momenta[constant.parent] = momenta[constant.parent] + moved(to_parent, arm);
    inertias[constant.parent] = inertias[constant.parent] + moved(joint.projected, arm);
  }
  const AnchorSprings<N> springs = springs_of<kLanes>(lanes.anchors[0], step_s);
  solve_root<kLanes>(inertias[0] + springs.stiffness, momenta[0] + springs.impulse, lanes);
}

}  // namespace
}  // namespace flinch::sim
