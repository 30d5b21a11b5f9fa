// SPDX-License-Identifier: MIT
#include "sim/rehearsal/simulator.h"

#include <array>
#include <cmath>

#include "sim/encounter/encounter.h"
#include "sim/rehearsal/rehearsal_run.h"
#include "sim/rehearsal/rehearsal_track.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr std::array kEndEffectors{Body::head, Body::left_hand, Body::right_hand, Body::left_foot,
                                   Body::right_foot};

/// Mean squared distance of the end effectors from the reference, m².
double squared_error(const Figure& figure, const ReferenceState& target) {
  double sum = 0;
  for (Body body : kEndEffectors) {
    sum += (position_of(figure.body(body)) - target.body[body].position).squaredNorm();
  }
  return sum / static_cast<double>(kEndEffectors.size());
}

/// State of a simulation in progress.
class TrackedSimulation {
 public:
  TrackedSimulation(const FigureModel& figure_model, const SimulationOptions& options,
                    const motion::Motion& motion, const features::Ball* ball)
      : reference_(figure_model.skeleton, figure_model.model, motion),
        encounter_(figure_model, options, reference_.at(0), ball) {}

  SimulationResult run_until(double duration_s) {
    const int messages_before = solver_messages_on_this_thread();
    while (encounter_.time_s() < duration_s) advance(duration_s - encounter_.time_s());
    const double time_s = encounter_.time_s();
    if (time_s > 0) result_.tracking_error_m = std::sqrt(squared_error_ / time_s);
    result_.impulse = encounter_.impulse();
    result_.first_contact_s = encounter_.first_contact_s();
    result_.solver_messages = solver_messages_on_this_thread() - messages_before;
    return result_;
  }

 private:
  void advance(double max_step_s) {
    const ReferenceState now = reference_.at(encounter_.time_s());
    const double step_s = encounter_.begin_step(now, max_step_s);
    const ReferenceState target = reference_.at(encounter_.time_s() + step_s);
    encounter_.figure().set_motors(target, step_s);
    encounter_.end_step(now, target, step_s);
    ++result_.steps;
    squared_error_ += step_s * squared_error(encounter_.figure(), target);
  }

  Reference reference_;
  OdeEncounter encounter_;
  SimulationResult result_;
  double squared_error_ = 0;
};

}  // namespace

struct Simulator::Setup {
  FigureModel figure;
  SimulationOptions options;
};

Simulator::Simulator(const motion::Physique& character, const SimulationOptions& options)
    : setup_(std::make_unique<Setup>(Setup{FigureModel(character), options})) {}

Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

SimulationResult Simulator::simulate(const motion::Motion& reference, const features::Ball* ball,
                                     double duration_s) const {
  return TrackedSimulation(setup_->figure, setup_->options, reference, ball).run_until(duration_s);
}

Rehearsal Simulator::rehearse(const motion::Motion& reference, double from_s,
                              double duration_s) const {
  return Rehearsal(std::make_unique<Rehearsal::Track>(setup_->figure, setup_->options, reference,
                                                      from_s, duration_s));
}

SimulationResult Simulator::simulate(const Rehearsal& rehearsal, const features::Ball& ball) const {
  return run_rehearsed(setup_->figure, setup_->options, rehearsal.track(), ball);
}

}  // namespace flinch::sim
