// SPDX-License-Identifier: MIT
#include "sim/rehearsal/simulator.h"

#include <utility>

#include "sim/figure/waist_up.h"
#include "sim/rehearsal/rehearsal_track.h"
#include "sim/rehearsal/throw_simulator.h"
#include "sim/rehearsal/track_lanes.h"

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
  return std::move(rehearse({&reference, 1}, from_s, duration_s, 1).front());
}

std::vector<Rehearsal> Simulator::rehearse(std::span<const motion::Motion> references,
                                           double from_s, double duration_s,
                                           std::size_t lanes) const {
  const bool is_waist_up = setup_->options.figure == FigureKind::waist_up;
  std::vector<std::unique_ptr<Rehearsal::Track>> tracks;
  tracks.reserve(references.size());
  for (const motion::Motion& motion : references)
    tracks.push_back(std::make_unique<Rehearsal::Track>(
        setup_->figure, setup_->options, is_waist_up ? waist_up_motion(motion) : motion, from_s,
        duration_s));
  record(setup_->figure, setup_->options, tracks, lanes);
  std::vector<Rehearsal> rehearsals;
  rehearsals.reserve(tracks.size());
  for (auto& track : tracks) rehearsals.emplace_back(std::move(track));
  return rehearsals;
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
