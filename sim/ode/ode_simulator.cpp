// SPDX-License-Identifier: MIT
#include "sim/ode/ode_simulator.h"

#include <array>
#include <cmath>

#include "sim/ode/ode_encounter.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr std::array kEndEffectors{Body::head, Body::left_hand, Body::right_hand, Body::left_foot,
                                   Body::right_foot};

/// Mean squared distance of the end effectors from the reference, m².
double squared_error(const motion::PerBody<BodyState>& figure, const ReferenceState& target) {
  double sum = 0;
  for (Body body : kEndEffectors) {
    sum += (figure[body].position - target.body[body].position).squaredNorm();
  }
  return sum / static_cast<double>(kEndEffectors.size());
}

/// State of a simulation in progress.
class TrackedSimulation {
 public:
  TrackedSimulation(const FigureModel& figure_model, const SimulationOptions& options,
                    const motion::Motion& motion, const features::Ball* ball)
      : reference_(figure_model.skeleton, figure_model.model, motion),
        encounter_(figure_model, options, 0, figure_model, reference_.at(0), ball,
                   options.gravity_mps2) {}

  SimulationResult run_until(double duration_s) {
    const int messages_before = solver_messages_on_this_thread();
    while (encounter_.time_s() < duration_s) advance(duration_s - encounter_.time_s());
    const double time_s = encounter_.time_s();
    if (time_s > 0) result_.tracking_error_m = std::sqrt(squared_error_ / time_s);
    result_.impulse = encounter_.impulse();
    result_.places = encounter_.places();
    result_.first_contact_s = encounter_.first_contact_s();
    result_.solver_messages = solver_messages_on_this_thread() - messages_before;
    return result_;
  }

 private:
  void advance(double max_step_s) {
    const ReferenceState now = reference_.at(encounter_.time_s());
    const double step_s = encounter_.begin_step(now, max_step_s);
    const ReferenceState target = reference_.at(encounter_.time_s() + step_s);
    encounter_.end_step(now, target, step_s);
    ++result_.steps;
    squared_error_ += step_s * squared_error(encounter_.scene().bodies(), target);
  }

  Reference reference_;
  Encounter<OdeScene> encounter_;
  SimulationResult result_;
  double squared_error_ = 0;
};

}  // namespace

OdeSimulator::OdeSimulator(const motion::Physique& character, const SimulationOptions& options)
    : figure_model_(character, options.ball_meets), options_(options) {}

SimulationResult OdeSimulator::simulate(const motion::Motion& reference, const features::Ball* ball,
                                        double duration_s) const {
  return TrackedSimulation(figure_model_, options_, reference, ball).run_until(duration_s);
}

}  // namespace flinch::sim
