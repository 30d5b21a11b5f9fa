// SPDX-License-Identifier: MIT
#include "sim/ode/ode_simulator.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/figure/limit_excess.h"
#include "sim/figure/waist_up.h"
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
      : figure_model_(figure_model),
        measures_limits_(options.measures_limits),
        reference_(figure_model.skeleton, figure_model.model, motion),
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
    const bool is_measured = encounter_.time_s() < follows_until_s_;
    const double step_s =
        encounter_.begin_step(now, is_measured ? std::min(max_step_s, kFollowStep_s) : max_step_s);
    if (measures_limits_ && encounter_.is_ball_hit())
      follows_until_s_ = encounter_.time_s() + kFollowThrough_s;
    const bool measures = encounter_.time_s() < follows_until_s_;
    const ReferenceState target = reference_.at(encounter_.time_s() + step_s);
    encounter_.end_step(now, target, step_s);
    ++result_.steps;
    squared_error_ += step_s * squared_error(encounter_.scene().bodies(), target);
    if (measures)
      result_.limit_excess_rads +=
          step_s * limit_excess_rad(figure_model_, encounter_.scene().bodies(), target);
  }

  const FigureModel& figure_model_;
  bool measures_limits_;
  Reference reference_;
  Encounter<OdeScene> encounter_;
  SimulationResult result_;
  double follows_until_s_ = 0;
  double squared_error_ = 0;
};

}  // namespace

OdeSimulator::OdeSimulator(const motion::Physique& character, const SimulationOptions& options)
    : figure_model_(character, options), options_(options) {}

SimulationResult OdeSimulator::simulate(const motion::Motion& reference, const features::Ball* ball,
                                        double duration_s) const {
  const bool is_waist_up = options_.figure == FigureKind::waist_up;
  const motion::Motion tracked = is_waist_up ? waist_up_motion(reference) : reference;
  return TrackedSimulation(figure_model_, options_, tracked, ball).run_until(duration_s);
}

}  // namespace flinch::sim
