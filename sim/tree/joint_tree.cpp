// SPDX-License-Identifier: MIT
#include "sim/tree/joint_tree.h"

#include <algorithm>
#include <limits>

namespace flinch::sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using motion::Body;

using Vector6d = Eigen::Vector<double, 6>;

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

template <std::size_t kLanes>
Vector3d lane_of(const double (&values)[3][kLanes], std::size_t lane) {
  return {values[0][lane], values[1][lane], values[2][lane]};
}
template <std::size_t kLanes>
Matrix3d lane_of(const double (&columns)[3][3][kLanes], std::size_t lane) {
  Matrix3d matrix;
  for (int i = 0; i < 3; ++i) matrix.col(i) = lane_of(columns[i], lane);
  return matrix;
}
template <class From, std::size_t kCount, std::size_t kLanes>
void put(const From& from, double (&values)[kCount][kLanes], std::size_t lane) {
  for (std::size_t i = 0; i < kCount; ++i) values[i][lane] = from[static_cast<Eigen::Index>(i)];
}

template <std::size_t kLanes>
void put(const std::optional<AnchorRows>& rows, typename TreeLanes<kLanes>::Anchor& anchor,
         std::size_t lane) {
  constexpr AxisRow kNoSpring{0, std::numeric_limits<double>::infinity()};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const AxisRow linear = rows ? rows->linear[axis] : kNoSpring;
    const AxisRow angular = rows ? rows->angular[axis] : kNoSpring;
    anchor.velocity[axis][lane] = linear.velocity;
    anchor.softness[axis][lane] = linear.softness;
    anchor.angular_velocity[axis][lane] = angular.velocity;
    anchor.angular_softness[axis][lane] = angular.softness;
  }
}

}  // namespace

JointTree::JointTree(const FigureModel& figure_model) : figure_model_(figure_model) {
  for (Body body : motion::kBodies) {
    Link& link = links_[body];
    link.chain = set_of(body);
    if (const auto parent = parent_of(body)) {
      link.parent = *parent;
      link.chain |= links_[*parent].chain;
    }
  }
}

template <std::size_t kLanes>
void JointTree::put_step(const TreeStep& step, TreeLanes<kLanes>& lanes, std::size_t lane) const {
  for (Body body : motion::kBodies) {
    auto& to = lanes.bodies[static_cast<std::size_t>(body)];
    const BodyState& now = step.now[body];
    put(now.position, to.position, lane);
    put(now.orientation.coeffs(), to.orientation, lane);
    put(now.velocity, to.velocity, lane);
    put(now.angular_velocity, to.angular_velocity, lane);
    const Twist impulse = contains(step.pushed, body) ? step.impulses[body] : Twist{};
    put(impulse.linear, to.impulse, lane);
    put(impulse.angular, to.angular_impulse, lane);
    const BodyState& target = step.target.body[body];
    put(target.orientation.coeffs(), to.target_orientation, lane);
    put(target.angular_velocity, to.target_angular_velocity, lane);
    put(step.target.socket[body], to.socket, lane);
  }
  const FigureAnchors anchors =
      figure_anchors(figure_model_, step.now, step.target, step.step_s, step.drive);
  put<kLanes>(anchors.pelvis, lanes.anchors[0], lane);
  put<kLanes>(anchors.feet[motion::Side::left], lanes.anchors[1], lane);
  put<kLanes>(anchors.feet[motion::Side::right], lanes.anchors[2], lane);
  lanes.step_s[lane] = step.step_s;
  lanes.gravity_mps2[lane] = step.gravity_mps2;
  lanes.joint_correction[lane] = joint_error_reduction(step.step_s) / step.step_s;
  const Gains share = scaled_gains({1, 1}, step.drive.strength.joints);
  lanes.stiffness_share[lane] = share.stiffness;
  lanes.damping_share[lane] = share.damping;
}

template <std::size_t kLanes>
void JointTree::take_factors(const TreeLanes<kLanes>& lanes, std::size_t lane) {
  for (Body body : motion::kBodies) {
    const auto& from = lanes.links[static_cast<std::size_t>(body)];
    Link& link = links_[body];
    link.to_joint = lane_of(from.to_joint, lane);
    if (body == Body::pelvis) continue;
    link.parent_to_joint = lane_of(from.parent_to_joint, lane);
    link.joint_to_joint = lane_of(from.joint_to_joint, lane);
    const auto& e = from.mobility;
    link.mobility << e[0][lane], e[3][lane], e[4][lane], e[3][lane], e[1][lane], e[5][lane],
        e[4][lane], e[5][lane], e[2][lane];
    link.coupling_mobility = lane_of(from.coupling_mobility, lane);
    link.angular_mobility = lane_of(from.angular_mobility, lane);
    link.prescribed = {lane_of(from.prescribed, lane), lane_of(from.prescribed_angular, lane)};
    link.angular = lane_of(from.angular, lane);
  }
  for (Eigen::Index i = 0; i < 6; ++i) {
    root_velocity_[i] = lanes.root_velocity[i][lane];
    for (Eigen::Index j = 0; j < 6; ++j)
      root_inverse_inertia_(j, i) = lanes.root_inverse_inertia[i][j][lane];
  }
}

template <std::size_t kLanes>
void JointTree::put_impulses(TreeLanes<kLanes>& lanes, std::size_t lane) const {
  for (Body body : motion::kBodies)
    put(links_[body].angular, lanes.links[static_cast<std::size_t>(body)].angular, lane);
  put(root_velocity_, lanes.root_velocity, lane);
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
    if (!contains(propagated.chain, body)) continue;
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

void find_limit_violation(const TreeConstants::Range& range, const double (&rotation)[4],
                          const double (&reference)[4], double (&violation)[3]) {
  const JointRange limits{Eigen::Quaterniond(range.reference), Vector3d(range.bone),
                          Vector3d(range.min), Vector3d(range.max)};
  const Vector3d back =
      limit_violation(limits, Eigen::Quaterniond(rotation), Eigen::Quaterniond(reference));
  std::ranges::copy(back, violation);
}

template void JointTree::put_step(const TreeStep&, TreeLanes<1>&, std::size_t) const;
template void JointTree::take_factors(const TreeLanes<1>&, std::size_t);
template void JointTree::put_impulses(TreeLanes<1>&, std::size_t) const;
template void JointTree::put_step(const TreeStep&, TreeLanes<2>&, std::size_t) const;
template void JointTree::take_factors(const TreeLanes<2>&, std::size_t);
template void JointTree::put_impulses(TreeLanes<2>&, std::size_t) const;
#ifdef __x86_64__
template void JointTree::put_step(const TreeStep&, TreeLanes<4>&, std::size_t) const;
template void JointTree::take_factors(const TreeLanes<4>&, std::size_t);
template void JointTree::put_impulses(TreeLanes<4>&, std::size_t) const;
template void JointTree::put_step(const TreeStep&, TreeLanes<8>&, std::size_t) const;
template void JointTree::take_factors(const TreeLanes<8>&, std::size_t);
template void JointTree::put_impulses(TreeLanes<8>&, std::size_t) const;
#endif

}  // namespace flinch::sim
