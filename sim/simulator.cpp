// SPDX-License-Identifier: MIT
#include "sim/simulator.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/ball_flight.h"
#include "sim/contacts.h"
#include "sim/figure.h"
#include "sim/pushes.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr std::array kEndEffectors{Body::head, Body::left_hand, Body::right_hand, Body::left_foot,
                                   Body::right_foot};

/// Squared distance of the end effectors from where the reference has them, mean, m².
double squared_error(const Figure& figure, const ReferenceState& target) {
  double sum = 0;
  for (Body body : kEndEffectors) {
    sum += (position_of(figure.body(body)) - target.body[body].position).squaredNorm();
  }
  return sum / static_cast<double>(kEndEffectors.size());
}

/// One simulation under way.
class Run {
 public:
  Run(const FigurePlan& plan, const SimulationOptions& options, const motion::Motion& motion,
      const Ball* ball)
      : options_(options),
        reference_(plan.skeleton, plan.model, motion),
        pushes_(plan),
        contacts_(world_.id()),
        figure_(plan, world_.id(), reference_.at(0)) {
    dWorldSetGravity(world_.id(), 0, 0, -options.gravity_mps2);
    if (ball) ball_.emplace(world_.id(), *ball, options.gravity_mps2);
  }

  SimulationResult to(double duration_s) {
    const int messages_before = solver_messages_on_this_thread();
    while (time_s_ < duration_s) advance(duration_s - time_s_);
    if (time_s_ > 0) result_.tracking_error_m = std::sqrt(squared_error_ / time_s_);
    result_.solver_messages = solver_messages_on_this_thread() - messages_before;
    return result_;
  }

 private:
  void advance(double most_s) {
    const motion::PerBody<MovingShape> shapes = figure_.shapes();
    double step_s = options_.free_step_s;
    contacts_.clear();
    pushes_.begin_step(time_s_);
    const ReferenceState now = reference_.at(time_s_);
    if (pushes_.ahead(shapes, now, step_s)) step_s = options_.contact_step_s;
    if (ball_) step_s = std::min(step_s, meet(shapes));
    // A last sliver of a step would only cost.
    if (step_s > most_s * (1 - 1e-9)) step_s = most_s;

    const ReferenceState target = reference_.at(time_s_ + step_s);
    figure_.drive(target, step_s);
    figure_.stand(contacts_, target, step_s);
    pushes_.add(figure_, shapes, now, contacts_);
    if (ball_) {
      ball_->step(world_, step_s);
    } else {
      world_.step(step_s);
    }
    pushes_.charge(contacts_.impulses(step_s), result_.impulse);
    time_s_ += step_s;
    ++result_.steps;
    squared_error_ += step_s * squared_error(figure_, target);
  }

  /// Adds what the ball touches now, and says how long a step it allows.
  double meet(const motion::PerBody<MovingShape>& shapes) {
    const features::FreeFlight flight = ball_->flight();
    const StepAhead ahead = step_ahead(flight, {&*shapes.begin(), motion::kBodyCount}, options_);
    for (Body body : motion::kBodies) {
      const features::Clearance near = clearance(flight.position, flight.radius, shapes[body]);
      if (!hits(flight, shapes[body], near)) continue;
      contacts_.add_hit(ball_->body(), figure_.body(body), body, near, options_.restitution);
      pushes_.hit(body);
      result_.first_contact_s = std::min(result_.first_contact_s, time_s_);
    }
    if (ahead.on_ground) ball_->meet_ground(contacts_, options_.restitution);
    return ahead.step_s;
  }

  SimulationOptions options_;
  Reference reference_;
  Pushes pushes_;
  OdeWorld world_;
  Contacts contacts_;
  Figure figure_;
  std::optional<BallFlight> ball_;
  SimulationResult result_;
  double time_s_ = 0;
  double squared_error_ = 0;
};

}  // namespace

struct Simulator::Plan {
  FigurePlan figure;
  SimulationOptions options;
};

Simulator::Simulator(const motion::Character& character, const SimulationOptions& options)
    : plan_(std::make_unique<Plan>(Plan{FigurePlan(character), options})) {}

Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

SimulationResult Simulator::simulate(const motion::Motion& reference, const Ball* ball,
                                     double duration_s) const {
  return Run(plan_->figure, plan_->options, reference, ball).to(duration_s);
}

}  // namespace flinch::sim
