// SPDX-License-Identifier: MIT
#include "sim/rehearsal/simulator.h"

#include "sim/figure/waist_up.h"
#include "sim/rehearsal/rehearsal_track.h"
#include "sim/rehearsal/throw_simulator.h"

namespace flinch::sim {

struct Simulator::Setup {
  FigureModel figure;
  SimulationOptions options;
};

Simulator::Simulator(const motion::Physique& character, const SimulationOptions& options)
    : setup_(std::make_unique<Setup>(Setup{FigureModel(character, options), options})) {}

Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

Rehearsal Simulator::rehearse(const motion::Motion& reference, double from_s,
                              double duration_s) const {
  const auto track = [&](const motion::Motion& tracked) {
    return Rehearsal(std::make_unique<Rehearsal::Track>(setup_->figure, setup_->options, tracked,
                                                        from_s, duration_s));
  };
  const bool is_waist_up = setup_->options.figure == FigureKind::waist_up;
  return is_waist_up ? track(waist_up_motion(reference)) : track(reference);
}

SimulationResult Simulator::simulate(const Rehearsal& rehearsal, const features::Ball& ball) const {
  const Throw one{rehearsal, ball};
  return ThrowSimulator(*this, 1).simulate({&one, 1}).front();
}

const FigureModel& Simulator::figure_model() const {
  return setup_->figure;
}

const SimulationOptions& Simulator::options() const {
  return setup_->options;
}

}  // namespace flinch::sim
