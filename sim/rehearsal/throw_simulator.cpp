// SPDX-License-Identifier: MIT
#include "sim/rehearsal/throw_simulator.h"

#include <algorithm>
#include <array>

#include "sim/rehearsal/rehearsal_run.h"

namespace flinch::sim {

class ThrowSimulator::Lanes {
 public:
  virtual ~Lanes() = default;
  virtual void simulate(std::span<const Throw> throws, std::span<SimulationResult> results) = 0;
};

/// Runs of different throws step side by side, whatever time it is in each. A lane whose run is
/// over takes the next throw.
template <std::size_t kLanes>
class ThrowSimulator::LanesOf final : public Lanes {
 public:
  explicit LanesOf(const Simulator& simulator) : constants_(simulator.figure_model().tree) {
    runs_.reserve(kLanes);
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      runs_.emplace_back(simulator.figure_model(), simulator.options());
  }

  void simulate(std::span<const Throw> throws, std::span<SimulationResult> results) override {
    std::size_t next = 0;
    running_.fill(nullptr);
    for (;;) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        for (; !running_[lane] && next < throws.size(); ++next) {
          if (runs_[lane].start(throws[next].rehearsal.track(), throws[next].ball)) {
            running_[lane] = &results[next];
          } else {
            results[next] = runs_[lane].result();
          }
        }
      }
      if (std::ranges::none_of(running_, [](const auto* result) { return result; })) return;
      step();
    }
  }

 private:
  void step() {
    for_each_running([&](std::size_t lane) { runs_[lane].put_step(lanes_, lane); });
    factor_trees(constants_, lanes_);
    for_each_running([&](std::size_t lane) { runs_[lane].solve_contacts(lanes_, lane); });
    move_figures(constants_, lanes_);
    for_each_running([&](std::size_t lane) {
      if (runs_[lane].end_step(lanes_, lane)) return;
      *running_[lane] = runs_[lane].result();
      running_[lane] = nullptr;
    });
  }

  template <class Visit>
  void for_each_running(Visit visit) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (running_[lane]) visit(lane);
    }
  }

  const TreeConstants& constants_;
  std::vector<RehearsalRun> runs_;                   // one per lane
  std::array<SimulationResult*, kLanes> running_{};  // where the lane's result goes; null if idle
  TreeLanes<kLanes> lanes_{};  // an idle lane keeps the numbers of its last step
};

ThrowSimulator::ThrowSimulator(const Simulator& simulator, std::size_t lanes) {
  switch (lanes) {
#ifdef __x86_64__
    case 8:
      lanes_ = std::make_unique<LanesOf<8>>(simulator);
      break;
    case 4:
      lanes_ = std::make_unique<LanesOf<4>>(simulator);
      break;
#endif
    case 2:
      lanes_ = std::make_unique<LanesOf<2>>(simulator);
      break;
    default:
      lanes_ = std::make_unique<LanesOf<1>>(simulator);
  }
}

ThrowSimulator::~ThrowSimulator() = default;

std::vector<SimulationResult> ThrowSimulator::simulate(std::span<const Throw> throws) {
  std::vector<SimulationResult> results(throws.size());
  lanes_->simulate(throws, results);
  return results;
}

}  // namespace flinch::sim
