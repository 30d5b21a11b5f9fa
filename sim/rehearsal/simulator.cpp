// SPDX-License-Identifier: MIT
#include "sim/rehearsal/simulator.h"

#include "sim/rehearsal/rehearsal_run.h"
#include "sim/rehearsal/rehearsal_track.h"

namespace flinch::sim {

struct Simulator::Setup {
  FigureModel figure;
  SimulationOptions options;
};

Simulator::Simulator(const motion::Physique& character, const SimulationOptions& options)
    : setup_(std::make_unique<Setup>(Setup{FigureModel(character), options})) {}

Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

Rehearsal Simulator::rehearse(const motion::Motion& reference, double from_s,
                              double duration_s) const {
  return Rehearsal(std::make_unique<Rehearsal::Track>(setup_->figure, setup_->options, reference,
                                                      from_s, duration_s));
}

std::vector<SimulationResult> Simulator::simulate(std::span<const Throw> throws) const {
  std::vector<SimulationResult> results;
  results.reserve(throws.size());
  RehearsalRun run(setup_->figure, setup_->options);
  for (const auto& [rehearsal, ball] : throws) {
    for (bool goes_on = run.start(rehearsal.track(), ball); goes_on;) goes_on = run.step();
    results.push_back(run.result());
  }
  return results;
}

SimulationResult Simulator::simulate(const Rehearsal& rehearsal, const features::Ball& ball) const {
  const Throw one{rehearsal, ball};
  return simulate({&one, 1}).front();
}

}  // namespace flinch::sim
