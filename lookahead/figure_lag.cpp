// SPDX-License-Identifier: MIT
#include "lookahead/figure_lag.h"

#include "motion/rotation.h"

namespace flinch::lookahead {

using Eigen::Vector3d;
using motion::Body;

namespace {

// In a step this long the springs reach their equilibrium, short of a share of 2 / (w t).
constexpr double kLong_s = 10;

/// Rotation from one orientation to another per second, rad/s.
Vector3d turn_rate(const sim::BodyState& from, const sim::BodyState& to, double step_s) {
  return motion::rotation_vector(to.orientation * from.orientation.conjugate()) / step_s;
}

}  // namespace

// A step of h takes a coordinate x of the figure, with inertia I, spring k = I w^2 and damper
// c = 2 I w, towards its reference r (sim/figure/springs.h):
//
//   I (v' - v) / h = k (r' - x') + c (u' - v'),   v' = (x' - x) / h,   u' = (r'' - r) / 2h,
//
// with r, r' and r'' one step apart. While the lag e = r' - x' changes slowly, v' and v are the
// differences of the reference too, and
//
//   k e = I (r' - 2 r + r_) / h^2 - c (r'' - 2 r' + r) / 2h + weight.
//
// For a single coordinate and w h = 1 the first two terms cancel at a constant acceleration. In a
// chain of joints each spring carries what is beyond it, and they do not. The tree of joints solves
// the chain: in a long step from rest, under the right-hand side as external forces.
motion::PerBody<sim::BodyState> FigureLag::figure(const Steps& steps, double step_s,
                                                  double gravity_mps2) {
  const motion::PerBody<sim::BodyState>& now = steps.now.body;
  sim::ReferenceState still = steps.now;
  motion::PerBody<sim::Twist> impulses;
  motion::PerBody<Vector3d> damped;  // (r'' - 2 r' + r) / 2h of the rotation
  motion::PerBody<sim::BodyState> figure;
  for (const Body body : motion::kBodies) {
    const sim::BodyState& before = steps.before[body];
    still.body[body].velocity.setZero();
    still.body[body].angular_velocity.setZero();
    figure[body].velocity = (now[body].position - before.position) / step_s;
    figure[body].angular_velocity = turn_rate(before, now[body], step_s);
    const Vector3d acceleration =
        (now[body].position - 2 * before.position + steps.two_before[body].position) /
        (step_s * step_s);
    const Vector3d turned_before = turn_rate(steps.two_before[body], before, step_s);
    const Vector3d angular = (figure[body].angular_velocity - turned_before) / step_s;
    damped[body] =
        (turn_rate(now[body], steps.after[body], step_s) - figure[body].angular_velocity) / 2;
    const double mass_kg = static_cast<double>(figure_model_.model[body].mass_kg);
    const Eigen::Quaterniond& turn = now[body].orientation;
    impulses[body].linear = -mass_kg * (acceleration + gravity_mps2 * Vector3d::UnitZ());
    impulses[body].angular = -(turn * (figure_model_.inertia[body] * (turn.conjugate() * angular)));
  }
  for (const Body body : motion::kBodies) {
    const double damping = figure_model_.gains[body].damping;
    if (const auto parent = parent_of(body)) {
      const Vector3d torque = damping * (damped[body] - damped[*parent]);
      impulses[body].angular += torque;
      impulses[*parent].angular -= torque;
      continue;
    }
    impulses[body].angular += damping * damped[body];
    impulses[body].linear +=
        figure_model_.pelvis_gains.damping / (2 * step_s) *
        (steps.after[body].position - 2 * now[body].position + steps.before[body].position);
  }
  for (sim::Twist& impulse : impulses) {
    impulse.linear *= kLong_s;
    impulse.angular *= kLong_s;
  }
  sim::TreeLanes<1> lane;
  tree_.put_step({still.body, still, kLong_s, 0, {}, sim::kAllBodies, impulses}, lane, 0);
  sim::factor_trees(figure_model_.tree, lane);
  tree_.take_factors(lane, 0);
  motion::PerBody<sim::Twist> after;
  tree_.velocities(sim::kAllBodies, after);
  for (const Body body : motion::kBodies) {
    sim::BodyState moving = now[body];
    moving.velocity = after[body].linear;
    moving.angular_velocity = after[body].angular;
    const sim::BodyState there = moved_on(moving, kLong_s);
    figure[body].position = there.position;
    figure[body].orientation = there.orientation;
  }
  return figure;
}

}  // namespace flinch::lookahead
