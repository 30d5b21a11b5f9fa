// SPDX-License-Identifier: MIT
#include "sim/tree/tree_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/contact/rod_step.h"

namespace flinch::sim {
namespace {

using Eigen::Vector3d;
using motion::Body;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TreeScene::TreeScene(const FigureModel& figure_model, const motion::PerBody<BodyState>& start,
                     const features::Ball* ball, double gravity_mps2)
    : figure_model_(figure_model), gravity_mps2_(gravity_mps2), tree_(figure_model) {
  contacts_.reserve(kReservedRows);
  impulses_.reserve(kReservedRows);
  rows_.reserve(kReservedRows);
  propagated_.reserve(kReservedRows);
  restart(start, ball);
}

void TreeScene::restart(const motion::PerBody<BodyState>& start, const features::Ball* ball) {
  clear_contacts();
  bodies_ = start;
  ball_state_ = {};
  ball_inertia_ = 0;
  solver_messages_ = 0;
  ball_.reset();
  if (!ball) return;
  ball_ = *ball;
  ball_state_.position = ball->position;
  ball_state_.velocity = ball->velocity;
  ball_state_.angular_velocity = ball->rod.angular_velocity;
  ball_inertia_ = moment_of_inertia(*ball);
}

motion::PerBody<MovingShape> TreeScene::shapes() const {
  motion::PerBody<MovingShape> result;
  for (Body body : motion::kBodies) {
    result[body] = placed_shape(figure_model_.outline[body], bodies_[body]);
  }
  return result;
}

std::optional<features::Ball> TreeScene::flight() const {
  if (!ball_) return std::nullopt;
  features::Ball ball = *ball_;
  ball.position = ball_state_.position;
  ball.velocity = ball_state_.velocity;
  if (ball.is_rod()) ball.rod.angular_velocity = ball_state_.angular_velocity;
  return ball;
}

void TreeScene::place(const motion::PerBody<BodyState>& figure, const features::Ball& ball) {
  bodies_ = figure;
  ball_state_.position = ball.position;
  ball_state_.velocity = ball.velocity;
  if (!ball_) return;
  ball_->window = ball.window;
  ball_->rod.axis = ball.rod.axis;
}

void TreeScene::clear_contacts() {
  contacts_.clear();
  dragged_ = 0;
}

void TreeScene::add_hit(Body body, const motion::Clearance& at) {
  contacts_.push_back(
      {impact_constraint(at.point, at.normal, ball_state_, bodies_[body], ball_->bounce),
       {ContactBody::Kind::ball, {}},
       {ContactBody::Kind::body, body},
       true});
}

void TreeScene::add_bounce() {
  contacts_.push_back(
      {bounce_constraint(ball_state_, bodies_[Body::pelvis].orientation, ball_->bounce),
       {ContactBody::Kind::ball, {}},
       {},
       false});
}

void TreeScene::add_body_contact(Body first, Body second, const motion::Clearance& at,
                                 double free_closing_mps, bool measured) {
  contacts_.push_back({body_contact_constraint(at, free_closing_mps),
                       {ContactBody::Kind::body, first},
                       {ContactBody::Kind::body, second},
                       measured});
}

void TreeScene::add_supports(const ReferenceState& target, double step_s, const Drive& drive) {
  const motion::PerSide<bool> held = held_feet(figure_model_, target, drive);
  for_each_body(supported_bodies(drive), [&](Body body) {
    const Support support =
        support_of(figure_model_, body, bodies_[body], target.body[body], drive, held);
    for (std::size_t i = 0; i < support.count; ++i) {
      const SupportPoint& at = support.points[i];
      contacts_.push_back({ground_constraint(at.point, at.depth_m, support.mass_kg, step_s),
                           {ContactBody::Kind::body, body},
                           {},
                           false});
    }
    if (drive.is_falling && support.count > 0) dragged_ |= set_of(body);
  });
}

void TreeScene::apply_gravity(double time_s) {
  if (ball_) ball_state_.velocity.z() -= ball_->gravity_mps2 * time_s;
}

void TreeScene::step(const ReferenceState& target, double step_s, const Drive& drive) {
  TreeLanes<1> lanes;
  begin_step(target, step_s, drive, lanes, 0);
  factor_trees(figure_model_.tree, lanes);
  solve_contacts(lanes, 0);
  move_figures(figure_model_.tree, lanes);
  end_step(lanes, 0);
}

template <std::size_t kLanes>
void TreeScene::begin_step(const ReferenceState& target, double step_s, const Drive& drive,
                           TreeLanes<kLanes>& lanes, std::size_t lane) {
  set_forces(target, step_s, drive);
  tree_.put_step({bodies_, target, step_s, drive.feedforward_from ? 0 : gravity_mps2_, drive,
                  pushed_, pushes_},
                 lanes, lane);
}

template <std::size_t kLanes>
void TreeScene::solve_contacts(TreeLanes<kLanes>& lanes, std::size_t lane) {
  const double step_s = lanes.step_s[lane];
  apply_gravity(step_s / 2);
  Twist on_ball;
  if (!contacts_.empty()) {
    tree_.take_factors(lanes, lane);
    on_ball = solve_contacts(step_s);
    tree_.put_impulses(lanes, lane);
  }
  move_ball(on_ball, step_s);
  apply_gravity(step_s / 2);
}

template <std::size_t kLanes>
void TreeScene::end_step(const TreeLanes<kLanes>& lanes, std::size_t lane) {
  for (Body body : motion::kBodies) {
    const auto& from = lanes.bodies[static_cast<std::size_t>(body)];
    BodyState& state = bodies_[body];
    for (Eigen::Index i = 0; i < 3; ++i) {
      state.position[i] = from.position[i][lane];
      state.velocity[i] = from.velocity[i][lane];
      state.angular_velocity[i] = from.angular_velocity[i][lane];
    }
    for (Eigen::Index i = 0; i < 4; ++i) state.orientation.coeffs()[i] = from.orientation[i][lane];
  }
}

void TreeScene::step_ball(double step_s) {
  apply_gravity(step_s / 2);
  move_ball(solve_contacts(step_s), step_s);
  apply_gravity(step_s / 2);
}

void TreeScene::set_forces(const ReferenceState& target, double step_s, const Drive& drive) {
  pushed_ = drive.feedforward_from ? kAllBodies : dragged_;
  for_each_body(pushed_, [&](Body body) {
    pushes_[body] = drive.feedforward_from
                        ? feedforward_impulse(figure_model_, body,
                                              drive.feedforward_from->body[body], target.body[body])
                        : Twist{};
    if (contains(dragged_, body))
      pushes_[body].linear += step_s * ground_drag(figure_model_, body, bodies_[body]);
  });
}

Twist TreeScene::solve_contacts(double step_s) {
  Twist on_ball;
  if (contacts_.empty()) return on_ball;
  make_rows();
  propagate_rows();
  Scratch::Vector solution = solution_.vector(static_cast<Eigen::Index>(rows_.size()));
  if (!solve_rows(make_equations(step_s), solution)) ++solver_messages_;
  apply(solution, on_ball);
  return on_ball;
}

void TreeScene::move_ball(const Twist& impulse, double step_s) {
  if (!ball_) return;
  const features::VelocityChange change =
      velocity_change(*ball_, ball_inertia_, impulse.linear, impulse.angular);
  const Twist after{ball_state_.velocity + change.linear,
                    ball_state_.angular_velocity + change.angular};
  if (ball_->is_rod()) return move_rod(after, step_s, !change.linear.isZero(0));
  move(ball_state_, after, step_s);
  ball_->window = ball_->window.at(step_s);
  if (ball_->window.is_over()) ball_state_.velocity.setZero();  // the stroke ends
}

void TreeScene::move_rod(const Twist& after, double step_s, bool is_struck) {
  const features::Ball rod = rod_after_step(*flight(), after, step_s, is_struck);
  ball_ = rod;
  ball_state_.position = rod.position;
  ball_state_.velocity = rod.velocity;
  ball_state_.angular_velocity = rod.rod.angular_velocity;
}

// As in ODE, bodies move with their new velocities.
void TreeScene::move(BodyState& state, const Twist& after, double step_s) {
  state.velocity = after.linear;
  state.angular_velocity = after.angular;
  state = moved_on(state, step_s);
}

const BodyState& TreeScene::state_of(const ContactBody& contact_body) const {
  return contact_body.kind == ContactBody::Kind::ball ? ball_state_ : bodies_[contact_body.body];
}

void TreeScene::make_rows() {
  rows_.clear();
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Contact& contact = contacts_[i];
    const auto add = [&](const Vector3d& direction, Eigen::Index normal) {
      Row row;
      row.contact = i;
      row.direction = direction;
      row.first_moment =
          (contact.constraint.point - state_of(contact.first).position).cross(direction);
      row.second_moment.setZero();
      if (contact.second.kind != ContactBody::Kind::ground) {
        row.second_moment =
            (contact.constraint.point - state_of(contact.second).position).cross(-direction);
      }
      row.normal = normal;
      rows_.push_back(row);
    };
    const auto normal = static_cast<Eigen::Index>(rows_.size());
    const ContactConstraint& constraint = contact.constraint;
    add(constraint.normal, -1);
    if (constraint.friction <= 0) continue;
    add(constraint.tangent, normal);
    add(constraint.normal.cross(constraint.tangent), normal);
  }
}

Twist TreeScene::current_velocity(const ContactBody& contact_body) const {
  if (contact_body.kind == ContactBody::Kind::ground) return {};
  const BodyState& state = state_of(contact_body);
  return {state.velocity, state.angular_velocity};
}

Twist TreeScene::free_velocity(const ContactBody& contact_body) const {
  return contact_body.kind == ContactBody::Kind::body ? after_[contact_body.body]
                                                      : current_velocity(contact_body);
}

/// Relative velocity along a row of its two bodies when they move with these velocities.
double TreeScene::relative_velocity(const Row& row, const Twist& first, const Twist& second) {
  return row.direction.dot(first.linear - second.linear) + row.first_moment.dot(first.angular) +
         row.second_moment.dot(second.angular);
}

/// Propagates the unit impulse of each row and finds the velocity of each row without contact
/// impulses.
void TreeScene::propagate_rows() {
  if (propagated_.size() < rows_.size()) propagated_.resize(rows_.size());
  BodySet wanted = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const Contact& contact = contacts_[row.contact];
    std::array<BodyImpulse, 2> body_impulses;
    std::size_t count = 0;
    if (contact.first.kind == ContactBody::Kind::body) {
      body_impulses[count++] = {contact.first.body, {row.direction, row.first_moment}};
    }
    if (contact.second.kind == ContactBody::Kind::body) {
      body_impulses[count++] = {contact.second.body, {-row.direction, row.second_moment}};
    }
    tree_.propagate(std::span(body_impulses).first(count), propagated_[i]);
    wanted |= propagated_[i].chain;
  }
  tree_.velocities(wanted, after_);
}

/// The minimum velocity that the contact's law demands of a row.
double TreeScene::target_relative_velocity(const Row& row, double step_s) const {
  if (row.normal >= 0) return 0;
  const Contact& contact = contacts_[row.contact];
  const ContactConstraint& constraint = contact.constraint;
  const double wanted =
      constraint.error_reduction * constraint.depth_m / step_s - constraint.free_closing_mps;
  if (constraint.restitution <= 0) return wanted;
  const double closing =
      -relative_velocity(row, current_velocity(contact.first), current_velocity(contact.second));
  return closing > kMinBounceSpeed_mps ? std::max(wanted, constraint.restitution * closing)
                                       : wanted;
}

/// The velocity of a row per unit impulse of another, of the ball alone.
double TreeScene::change_by_ball(const Row& row, const Row& other) const {
  if (!ball_->is_rod())
    return row.direction.dot(other.direction) / ball_->mass_kg +
           row.first_moment.dot(other.first_moment) / ball_inertia_;
  const features::VelocityChange change =
      velocity_change(*ball_, ball_inertia_, other.direction, other.first_moment);
  return row.direction.dot(change.linear) + row.first_moment.dot(change.angular);
}

// With v the rows' velocities without contact impulses and A_ij the velocity change of row i per
// unit impulse of row j, A p + softness/h p - (v_wanted - v) is complementary to p.
TreeScene::Equations TreeScene::make_equations(double step_s) {
  const auto count = static_cast<Eigen::Index>(rows_.size());
  Equations equations{matrix_.matrix(count, count), right_hand_side_.vector(count)};
  auto& [matrix, right_hand_side] = equations;
  const auto hits = [this](const Row& row) {
    return contacts_[row.contact].first.kind == ContactBody::Kind::ball;
  };
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto at = static_cast<std::size_t>(j);
    const Row& row = rows_[at];
    for (Eigen::Index i = 0; i <= j; ++i) {
      const auto other_at = static_cast<std::size_t>(i);
      const Row& other = rows_[other_at];
      double change = JointTree::inverse_inertia_product(propagated_[at], propagated_[other_at]);
      if (hits(row) && hits(other)) change += change_by_ball(row, other);
      matrix(i, j) = change;
      matrix(j, i) = change;
    }
    const Contact& contact = contacts_[row.contact];
    const double softness =
        row.normal < 0 ? contact.constraint.softness : ContactConstraint{}.softness;
    matrix(j, j) += softness / step_s;
    right_hand_side[j] =
        target_relative_velocity(row, step_s) -
        relative_velocity(row, free_velocity(contact.first), free_velocity(contact.second));
  }
  return equations;
}

// As in ODE, the normal forces of a step without friction bound the friction.
bool TreeScene::solve_rows(const Equations& equations, Scratch::Vector& solution) {
  const auto& [matrix, right_hand_side] = equations;
  const Eigen::Index count = solution.size();
  Scratch::Matrix bounds = bounds_.matrix(count, 2);
  auto lower = bounds.col(0);
  auto upper = bounds.col(1);
  bounds.setZero();
  bool has_friction = false;
  for (Eigen::Index i = 0; i < count; ++i) {
    const bool is_normal = rows_[static_cast<std::size_t>(i)].normal < 0;
    if (is_normal) upper[i] = kInfinity;
    has_friction |= !is_normal;
  }
  bool solved = lcp_.solve(matrix, right_hand_side, lower, upper, solution);
  if (!has_friction) return solved;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Row& row = rows_[static_cast<std::size_t>(i)];
    if (row.normal < 0) continue;
    upper[i] = contacts_[row.contact].constraint.friction * solution[row.normal];
    lower[i] = -upper[i];
  }
  solved &= lcp_.solve(matrix, right_hand_side, lower, upper, solution);
  return solved;
}

void TreeScene::apply(const Scratch::Vector& solution, Twist& on_ball) {
  for (Contact& contact : contacts_) contact.impulse_ns = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const double size = solution[static_cast<Eigen::Index>(i)];
    Contact& contact = contacts_[row.contact];
    contact.impulse_ns = std::hypot(contact.impulse_ns, size);
    tree_.add(propagated_[i], size);
    if (contact.first.kind != ContactBody::Kind::ball) continue;
    on_ball.linear += size * row.direction;
    on_ball.angular += size * row.first_moment;
  }
}

std::span<const ContactImpulse> TreeScene::impulses(double) {
  impulses_.clear();
  for (const Contact& contact : contacts_) {
    if (!contact.measured) continue;
    const bool hit = contact.first.kind == ContactBody::Kind::ball;
    impulses_.push_back({hit ? contact.second.body : contact.first.body,
                         hit ? std::nullopt : std::optional(contact.second.body),
                         contact.impulse_ns});
  }
  return impulses_;
}

template void TreeScene::begin_step(const ReferenceState&, double, const Drive&, TreeLanes<1>&,
                                    std::size_t);
template void TreeScene::solve_contacts(TreeLanes<1>&, std::size_t);
template void TreeScene::end_step(const TreeLanes<1>&, std::size_t);
template void TreeScene::begin_step(const ReferenceState&, double, const Drive&, TreeLanes<2>&,
                                    std::size_t);
template void TreeScene::solve_contacts(TreeLanes<2>&, std::size_t);
template void TreeScene::end_step(const TreeLanes<2>&, std::size_t);
#ifdef __x86_64__
template void TreeScene::begin_step(const ReferenceState&, double, const Drive&, TreeLanes<4>&,
                                    std::size_t);
template void TreeScene::solve_contacts(TreeLanes<4>&, std::size_t);
template void TreeScene::end_step(const TreeLanes<4>&, std::size_t);
template void TreeScene::begin_step(const ReferenceState&, double, const Drive&, TreeLanes<8>&,
                                    std::size_t);
template void TreeScene::solve_contacts(TreeLanes<8>&, std::size_t);
template void TreeScene::end_step(const TreeLanes<8>&, std::size_t);
#endif

}  // namespace flinch::sim
