// SPDX-License-Identifier: MIT
// The equations of the joints' springs, several figures side by side: the same as figure_rows.cpp
// for one. Included once by a file per instruction set; see lane_algebra.h.
#pragma once

#include "sim/tree/lane_algebra.h"
#include "sim/tree/tree_lanes.h"

namespace flinch::sim {
namespace {

template <std::size_t kLanes>
using Number = typename LaneType<kLanes>::Number;

template <std::size_t kLanes>
Number<kLanes> load(const double (&from)[kLanes]) {
  Number<kLanes> number;
  __builtin_memcpy(&number, from, sizeof number);
  return number;
}
template <std::size_t kLanes>
Vector<Number<kLanes>> load(const double (&from)[3][kLanes]) {
  return {load(from[0]), load(from[1]), load(from[2])};
}
template <std::size_t kLanes>
Matrix<Number<kLanes>> load(const double (&from)[3][3][kLanes]) {
  return {load(from[0]), load(from[1]), load(from[2])};
}
template <std::size_t kLanes>
Quaternion<Number<kLanes>> load(const double (&from)[4][kLanes]) {
  return {load(from[3]), {load(from[0]), load(from[1]), load(from[2])}};
}
template <class N, std::size_t kLanes>
void store(const N& number, double (&to)[kLanes]) {
  __builtin_memcpy(to, &number, sizeof number);
}
template <class N, std::size_t kLanes>
void store(const Vector<N>& v, double (&to)[3][kLanes]) {
  store(v.x, to[0]);
  store(v.y, to[1]);
  store(v.z, to[2]);
}
template <class N, std::size_t kLanes>
void store(const Matrix<N>& m, double (&to)[3][3][kLanes]) {
  store(m.x, to[0]);
  store(m.y, to[1]);
  store(m.z, to[2]);
}
template <class N, std::size_t kLanes>
void store(const SymmetricMatrix<N>& m, double (&to)[6][kLanes]) {
  store(m.xx, to[0]);
  store(m.yy, to[1]);
  store(m.zz, to[2]);
  store(m.xy, to[3]);
  store(m.xz, to[4]);
  store(m.yz, to[5]);
}

template <class N, std::size_t kLanes>
void store(const Quaternion<N>& q, double (&to)[4][kLanes]) {
  store(q.u.x, to[0]);
  store(q.u.y, to[1]);
  store(q.u.z, to[2]);
  store(q.w, to[3]);
}

// acos(c) / sqrt(1 - c^2) for c in [0, 1]: the even and odd terms of its Chebyshev series of 21
// degrees in x = 2 c - 1. Right to 3e-16 of itself.
template <class N>
N angle_per_sine(const N& c) {
  constexpr double kEven[] = {1.2091995761561452,    0.06973319205204692,   0.00586162897495759,
                              0.0005447739881301811, 5.307370323056482e-05, 5.314287188091921e-06,
                              5.418581985727714e-07, 5.575738842888287e-08, 6.0331600097782334e-09,
                              4.681011903625551e-10, 1.1890151456850346e-10};
  constexpr double kOdd[] = {
      -0.26360014128128495,    -0.019837146922478774,   -0.0017729284611099334,
      -0.00016930994739062122, -1.6749143247281873e-05, -1.693639120851007e-06,
      -1.7388548997694832e-07, -1.7964789574344403e-08, -1.966661891855127e-09,
      -1.4602825315849918e-10, -3.984620360291936e-11};
  const N x = c + c - 1.0;
  const N square = x * x;
  N even = 0.0 * x + kEven[10];
  N odd = 0.0 * x + kOdd[10];
  for (int i = 9; i >= 0; --i) {
    even = even * square + kEven[i];
    odd = odd * square + kOdd[i];
  }
  return even + x * odd;
}

/// The rotation vector of a unit quaternion, the shorter way round. With c = |w|, its angle is
/// 2 acos(c), and the length of its vector part is sqrt(1 - c^2).
template <class N>
Vector<N> rotation_vector(const Quaternion<N>& q) {
  const N twice = 2.0 * angle_per_sine(absolute(q.w));
  return select(q.w < 0.0, -twice, twice) * q.u;
}

/// As motion::SwingTwist.
template <class N>
struct LaneSwingTwist {
  Quaternion<N> swing, twist;
};

template <class N>
Vector<N> broadcast(const double (&v)[3], const N& like) {
  const N zero = 0.0 * like;
  return {zero + v[0], zero + v[1], zero + v[2]};
}

/// Of a rotation from the joint's reference, about its bone.
template <class N>
LaneSwingTwist<N> swing_twist(const TreeConstants::Range& range, const Quaternion<N>& rotation) {
  const Vector<N> bone = broadcast(range.bone, rotation.w);
  const Quaternion<N> reference{
      0.0 * rotation.w + range.reference[3],
      {0.0 * rotation.w + range.reference[0], 0.0 * rotation.w + range.reference[1],
       0.0 * rotation.w + range.reference[2]}};
  const Quaternion<N> from_reference = conjugate(reference) * rotation;
  const N along = dot(from_reference.u, bone);
  const N norm = square_root(from_reference.w * from_reference.w + along * along);
  // A swing by half a turn leaves the twist undefined.
  const auto is_undefined = norm < 8 * __DBL_EPSILON__;
  const N share = 1.0 / select(is_undefined, 0.0 * norm + 1.0, norm);
  const Quaternion<N> twist{select(is_undefined, 0.0 * norm + 1.0, share * from_reference.w),
                            select(is_undefined, 0.0 * norm, share * along) * bone};
  return {from_reference * conjugate(twist), twist};
}

/// Where a rotation is certainly within the joint's limits: is_well_within() of joint_range.cpp.
template <class N>
auto is_within(const TreeConstants::Range& range, const Quaternion<N>& rotation) {
  constexpr double kMargin_rad = 1e-9;  // for rounding errors
  constexpr double kHalfPi = 1.57079632679489661923;
  const auto [swing, twist] = swing_twist(range, rotation);
  const Quaternion<N> parts[] = {swing, twist};
  const N margin = 0.0 * rotation.w + kMargin_rad;
  Vector<N> guess = 0.0 * rotation.u;
  Vector<N> error{margin, margin, margin};
  for (const Quaternion<N>& part : parts) {
    const N cosine = absolute(part.w);
    const N min = (4.0 - cosine) * (1.0 / 3);
    const N max = kHalfPi - (kHalfPi - 1) * cosine;
    guess = guess + select(part.w < 0.0, -(min + max), min + max) * part.u;
    const N width = max - min;
    error = error + Vector<N>{width * absolute(part.u.x), width * absolute(part.u.y),
                              width * absolute(part.u.z)};
  }
  const Vector<N> above = guess - error - broadcast(range.min, rotation.w);
  const Vector<N> below = broadcast(range.max, rotation.w) - guess - error;
  return (above.x >= 0.0) & (above.y >= 0.0) & (above.z >= 0.0) & (below.x >= 0.0) &
         (below.y >= 0.0) & (below.z >= 0.0);
}

/// The rotation vector that takes each lane's joint back to its limits, in the parent's frame.
template <class N, class Mask>
Vector<N> way_back(const TreeConstants::Range& range, const Quaternion<N>& rotation,
                   const Quaternion<N>& reference, const Mask& is_within) {
  constexpr std::size_t kLanes = sizeof(N) / sizeof(double);
  double from[4][kLanes], to[4][kLanes], back[3][kLanes] = {};
  store(rotation, from);
  store(reference, to);
  double within[kLanes];
  store(select(is_within, 0.0 * rotation.w + 1.0, 0.0 * rotation.w), within);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (within[lane] == 1) continue;
    double violation[3];
    find_limit_violation(range, {from[0][lane], from[1][lane], from[2][lane], from[3][lane]},
                         {to[0][lane], to[1][lane], to[2][lane], to[3][lane]}, violation);
    for (std::size_t i = 0; i < 3; ++i) back[i][lane] = violation[i];
  }
  return load(back);
}

/// The axes of a joint that is no ball joint, in the parent's frame: axes_of() of figure_rows.cpp.
template <class N>
Matrix<N> hinge_axes(const TreeConstants::Body& joint, const Quaternion<N>& reference) {
  constexpr double kStraight_rad = 0.1;
  const auto [swing, twist] = swing_twist(joint.range, reference);
  const Vector<N> angles = rotation_vector(swing) + rotation_vector(twist);
  const Vector<N> bone = broadcast(joint.range.bone, reference.w);
  const Vector<N> anatomical = broadcast(joint.hinge, reference.w);
  const Vector<N> bend = angles - dot(angles, bone) * bone;
  const N side =
      select(dot(bend, anatomical) < 0.0, 0.0 * reference.w - 1.0, 0.0 * reference.w + 1.0);
  const Vector<N> axis = side * bend + kStraight_rad * anatomical;
  const Vector<N> hinge = (1.0 / square_root(dot(axis, axis))) * axis;
  return {hinge, bone, cross(hinge, bone)};
}

/// The axes of the child in the parent's frame, the bone last.
template <class N>
Matrix<N> bone_axes(const TreeConstants::Body& joint, const Quaternion<N>& now) {
  const Matrix<N> turn = rotation(now);
  if (joint.bone == 0) return {turn.y, turn.z, turn.x};
  if (joint.bone == 1) return {turn.z, turn.x, turn.y};
  return turn;
}

/// A joint's springs over a step, as an impulse D (c - u) about each axis. Of an axis without a
/// spring, `drive` is the prescribed velocity.
template <class N>
struct SpringRows {
  Matrix<N> axes;
  Vector<N> stiffness;         // D
  Vector<N> drive;             // D c
  decltype(N{} == N{}) alike;  // where all three have the same stiffness
};

// With f = k e + c (w_d - w) and e at the end of the step h, D = h (h k + c) and D c = h (k e + c
// w_d). A limit adds stiffness and damping, divided among the axes in proportion to the squares of
// the way back. Along a bone whose twist is damped, a share of all of it is left.
template <class N, std::size_t kLanes>
SpringRows<N> spring_rows(const TreeConstants::Body& joint, const TreeLanes<kLanes>& lanes,
                          std::size_t body, const Matrix<N>& parent_turn) {
  const auto& own = lanes.bodies[body];
  const auto& parent = lanes.bodies[joint.parent];
  const Quaternion<N> to_parent = conjugate(load(parent.target_orientation));
  const Quaternion<N> reference = to_parent * load(own.target_orientation);
  const Quaternion<N> now = conjugate(load(parent.orientation)) * load(own.orientation);
  Vector<N> error = rotation_vector(reference * conjugate(now));
  Vector<N> velocity =
      transposed_times(rotation(load(parent.target_orientation)),
                       load(own.target_angular_velocity) - load(parent.target_angular_velocity));
  const auto within = is_within(joint.range, now);
  const bool all_within = holds_everywhere(within);
  Vector<N> back = 0.0 * error;
  if (!all_within) back = way_back(joint.range, now, reference, within);
  SpringRows<N> rows;
  rows.axes = parent_turn;
  if (joint.bone >= 0 || (joint.free_axes < 3 && joint.free_axes > 0)) {
    const Matrix<N> axes = joint.bone >= 0 ? bone_axes(joint, now) : hinge_axes(joint, reference);
    error = transposed_times(axes, error);
    velocity = transposed_times(axes, velocity);
    back = transposed_times(axes, back);
    rows.axes = parent_turn * axes;
  }
  const N step_s = load(lanes.step_s);
  const N stiffness = load(lanes.stiffness_share) * joint.stiffness;
  const N damping = load(lanes.damping_share) * joint.damping;
  const N spring = step_s * (step_s * stiffness + damping);
  rows.stiffness = {spring, spring, spring};
  rows.drive = (step_s * stiffness) * error;
  if (joint.follows_velocity) rows.drive = rows.drive + (step_s * damping) * velocity;
  const N way = dot(back, back);
  rows.alike = !(way > 0.0);
  if (!all_within) {
    const N per_square = joint.limit_stiffness * step_s / way;
    const Vector<N> stop{per_square * back.x * back.x, per_square * back.y * back.y,
                         per_square * back.z * back.z};
    const Vector<N> push{stop.x * back.x, stop.y * back.y, stop.z * back.z};
    Vector<N> added = step_s * stop;
    if (joint.limit_damping > 0) {
      const N damping_per_square = joint.limit_damping * step_s / way;
      added = added + Vector<N>{damping_per_square * back.x * back.x,
                                damping_per_square * back.y * back.y,
                                damping_per_square * back.z * back.z};
    }
    rows.stiffness = select(rows.alike, rows.stiffness, rows.stiffness + added);
    rows.drive = select(rows.alike, rows.drive, rows.drive + push);
  }
  if (joint.twist_share != 1) {
    rows.stiffness.z = joint.twist_share * rows.stiffness.z;
    rows.drive.z = joint.twist_share * rows.drive.z;
    rows.alike = way < 0.0;  // nowhere
  }
  const Vector<N> rigid = velocity + load(lanes.joint_correction) * error;
  if (joint.free_axes < 3) rows.drive.z = rigid.z;
  if (joint.free_axes < 2) rows.drive.y = rigid.y;
  if (joint.free_axes < 1) rows.drive.x = rigid.x;
  return rows;
}

}  // namespace
}  // namespace flinch::sim
