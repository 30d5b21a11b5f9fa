// SPDX-License-Identifier: MIT
#include "sim/tree/tree_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flinch::sim {
namespace {

using Eigen::Vector3d;
using motion::Body;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two directions across a unit vector, as ODE takes them: the pyramid of friction has corners.
std::array<Vector3d, 2> across(const Vector3d& normal) {
  const bool upright = std::abs(normal.z()) > std::sqrt(0.5);
  const Vector3d first =
      (upright ? Vector3d(0, -normal.z(), normal.y()) : Vector3d(-normal.y(), normal.x(), 0))
          .normalized();
  return {first, normal.cross(first)};
}

}  // namespace

// A shell: I = 2/3 m r^2.
BallState ball_state(const Ball& ball) {
  BallState state;
  state.body.position = ball.position;
  state.body.velocity = ball.velocity;
  state.radius = ball.radius;
  state.mass_kg = ball.mass_kg;
  state.inertia = 2.0 / 3 * ball.mass_kg * ball.radius * ball.radius;
  return state;
}

TreeScene::TreeScene(const FigurePlan& plan, const motion::PerBody<BodyState>& start,
                     const Ball* ball, double gravity_mps2)
    : plan_(plan), gravity_mps2_(gravity_mps2), bodies_(start), tree_(plan) {
  if (ball) ball_ = ball_state(*ball);
}

motion::PerBody<MovingShape> TreeScene::shapes() const {
  motion::PerBody<MovingShape> result;
  for (Body body : motion::kBodies) {
    result[body] = placed_shape(plan_.outline[body], bodies_[body]);
  }
  return result;
}

std::optional<features::FreeFlight> TreeScene::flight() const {
  if (!ball_) return std::nullopt;
  return features::FreeFlight{ball_->body.position, ball_->body.velocity, ball_->radius,
                              gravity_mps2_};
}

void TreeScene::clear_contacts() {
  contacts_.clear();
}

void TreeScene::add_hit(Body body, const motion::Clearance& at, double restitution) {
  contacts_.push_back({hit_at(at.point, at.normal, restitution),
                       {Party::Kind::ball, {}},
                       {Party::Kind::body, body},
                       true});
}

void TreeScene::add_bounce(double restitution) {
  const Vector3d& centre = ball_->body.position;
  contacts_.push_back({hit_at({centre.x(), centre.y(), 0}, Vector3d::UnitZ(), restitution),
                       {Party::Kind::ball, {}},
                       {},
                       false});
}

void TreeScene::add_push(Body first, Body second, const motion::Clearance& at,
                         double free_closing_mps, bool measured) {
  contacts_.push_back({push_at(at, free_closing_mps),
                       {Party::Kind::body, first},
                       {Party::Kind::body, second},
                       measured});
}

void TreeScene::add_supports(const ReferenceState& target, double step_s) {
  for (Body foot : {Body::left_foot, Body::right_foot}) {
    const FootSupport support = foot_support(plan_, foot, bodies_[foot], target.body[foot]);
    for (std::size_t i = 0; i < support.count; ++i) {
      const SupportPoint& at = support.points[i];
      contacts_.push_back({support_at(at.point, at.depth_m, plan_.mass_kg / 4, step_s),
                           {Party::Kind::body, foot},
                           {},
                           false});
    }
  }
}

void TreeScene::fall(double time_s) {
  if (ball_) ball_->body.velocity.z() -= gravity_mps2_ * time_s;
}

void TreeScene::step(const ReferenceState& target, double step_s) {
  fall(step_s / 2);
  tree_.set_step(bodies_, figure_rows(plan_, bodies_, target, step_s), step_s, gravity_mps2_);
  Twist on_ball;
  if (!contacts_.empty()) {
    make_rows();
    pass_rows();
    make_equations(step_s);
    if (!solve_rows()) ++solver_messages_;
    apply(on_ball);
  }
  tree_.velocities(kAllBodies, after_);
  for (Body body : motion::kBodies) move(bodies_[body], after_[body], step_s);
  if (ball_) {
    BodyState& ball = ball_->body;
    move(ball,
         {ball.velocity + on_ball.linear / ball_->mass_kg,
          ball.angular_velocity + on_ball.angular / ball_->inertia},
         step_s);
  }
  fall(step_s / 2);
}

// x' = x + h v', and q' the unit of q + h/2 w' q, as ODE moves bodies.
void TreeScene::move(BodyState& state, const Twist& after, double step_s) const {
  state.velocity = after.linear;
  state.angular_velocity = after.angular;
  state.position += step_s * after.linear;
  const Eigen::Quaterniond spin(0, after.angular.x(), after.angular.y(), after.angular.z());
  state.orientation.coeffs() += step_s / 2 * (spin * state.orientation).coeffs();
  state.orientation.normalize();
}

const BodyState& TreeScene::state_of(const Party& party) const {
  return party.kind == Party::Kind::ball ? ball_->body : bodies_[party.body];
}

void TreeScene::make_rows() {
  rows_.clear();
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Contact& contact = contacts_[i];
    const auto add = [&](const Vector3d& direction, Eigen::Index normal) {
      Row row;
      row.contact = i;
      row.direction = direction;
      row.first_moment = (contact.touch.point - state_of(contact.first).position).cross(direction);
      row.second_moment.setZero();
      if (contact.second.kind != Party::Kind::ground) {
        row.second_moment =
            (contact.touch.point - state_of(contact.second).position).cross(-direction);
      }
      row.normal = normal;
      rows_.push_back(row);
    };
    const auto normal = static_cast<Eigen::Index>(rows_.size());
    add(contact.touch.normal, -1);
    if (contact.touch.friction <= 0) continue;
    for (const Vector3d& tangent : across(contact.touch.normal)) add(tangent, normal);
  }
}

Twist TreeScene::motion_of(const Party& party) const {
  if (party.kind == Party::Kind::ground) return {};
  const BodyState& state = state_of(party);
  return {state.velocity, state.angular_velocity};
}

Twist TreeScene::free_motion_of(const Party& party) const {
  return party.kind == Party::Kind::body ? after_[party.body] : motion_of(party);
}

/// How fast a row's two part who move like this.
double TreeScene::rate(const Row& row, const Twist& first, const Twist& second) {
  return row.direction.dot(first.linear - second.linear) + row.first_moment.dot(first.angular) +
         row.second_moment.dot(second.angular);
}

/// Passes each row's unit impulse on, and finds how those that the rows act on move without it.
void TreeScene::pass_rows() {
  if (passed_.size() < rows_.size()) passed_.resize(rows_.size());
  BodySet wanted = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const Contact& contact = contacts_[row.contact];
    std::array<Load, 2> loads;
    std::size_t loaded = 0;
    if (contact.first.kind == Party::Kind::body) {
      loads[loaded++] = {contact.first.body, {row.direction, row.first_moment}};
    }
    if (contact.second.kind == Party::Kind::body) {
      loads[loaded++] = {contact.second.body, {-row.direction, row.second_moment}};
    }
    tree_.pass(std::span(loads).first(loaded), passed_[i]);
    wanted |= passed_[i].chain;
  }
  tree_.velocities(wanted, after_);
}

/// The velocity that a contact's law asks of a row at the least.
double TreeScene::wanted_rate(const Row& row, double step_s) const {
  if (row.normal >= 0) return 0;
  const Contact& contact = contacts_[row.contact];
  const Touch& touch = contact.touch;
  const double wanted = touch.error_reduction * touch.depth_m / step_s - touch.free_closing_mps;
  if (touch.bounce <= 0) return wanted;
  const double closing = -rate(row, motion_of(contact.first), motion_of(contact.second));
  return closing > kRestSpeed_mps ? std::max(wanted, touch.bounce * closing) : wanted;
}

// With v the rows' velocities without contacts, and A the change of each by a unit impulse of
// another, A p + softness/h p - (v_wanted - v) complements p.
void TreeScene::make_equations(double step_s) {
  const auto count = static_cast<Eigen::Index>(rows_.size());
  matrix_.resize(count, count);
  right_.resize(count);
  const auto hits = [this](const Row& row) {
    return contacts_[row.contact].first.kind == Party::Kind::ball;
  };
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto at = static_cast<std::size_t>(j);
    const Row& row = rows_[at];
    for (Eigen::Index i = 0; i <= j; ++i) {
      const auto other_at = static_cast<std::size_t>(i);
      const Row& other = rows_[other_at];
      double change = JointTree::effect(passed_[at], passed_[other_at]);
      if (hits(row) && hits(other)) {
        change += row.direction.dot(other.direction) / ball_->mass_kg +
                  row.first_moment.dot(other.first_moment) / ball_->inertia;
      }
      matrix_(i, j) = change;
      matrix_(j, i) = change;
    }
    const Contact& contact = contacts_[row.contact];
    const double softness = row.normal < 0 ? contact.touch.softness : Touch{}.softness;
    matrix_(j, j) += softness / step_s;
    right_[j] = wanted_rate(row, step_s) -
                rate(row, free_motion_of(contact.first), free_motion_of(contact.second));
  }
}

// As ODE has it: friction is bounded by the normal forces of a step without it.
bool TreeScene::solve_rows() {
  const auto count = static_cast<Eigen::Index>(rows_.size());
  low_ = Eigen::VectorXd::Zero(count);
  high_ = Eigen::VectorXd::Zero(count);
  bool rubs = false;
  for (Eigen::Index i = 0; i < count; ++i) {
    const bool is_normal = rows_[static_cast<std::size_t>(i)].normal < 0;
    if (is_normal) high_[i] = kInfinity;
    rubs |= !is_normal;
  }
  bool solved = lcp_.solve(matrix_, right_, low_, high_, x_);
  if (!rubs) return solved;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Row& row = rows_[static_cast<std::size_t>(i)];
    if (row.normal < 0) continue;
    high_[i] = contacts_[row.contact].touch.friction * x_[row.normal];
    low_[i] = -high_[i];
  }
  solved &= lcp_.solve(matrix_, right_, low_, high_, x_);
  return solved;
}

void TreeScene::apply(Twist& on_ball) {
  for (Contact& contact : contacts_) contact.impulse_ns = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const double size = x_[static_cast<Eigen::Index>(i)];
    Contact& contact = contacts_[row.contact];
    contact.impulse_ns = std::hypot(contact.impulse_ns, size);
    tree_.add(passed_[i], size);
    if (contact.first.kind != Party::Kind::ball) continue;
    on_ball.linear += size * row.direction;
    on_ball.angular += size * row.first_moment;
  }
}

std::span<const ContactImpulse> TreeScene::impulses(double) {
  impulses_.clear();
  for (const Contact& contact : contacts_) {
    if (!contact.measured) continue;
    const bool hit = contact.first.kind == Party::Kind::ball;
    impulses_.push_back({hit ? contact.second.body : contact.first.body,
                         hit ? std::nullopt : std::optional(contact.second.body),
                         contact.impulse_ns});
  }
  return impulses_;
}

}  // namespace flinch::sim
