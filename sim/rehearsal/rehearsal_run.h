// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "sim/encounter/encounter.h"
#include "sim/rehearsal/rehearsal_track.h"
#include "sim/rehearsal/simulator.h"

namespace flinch::sim {

/// Simulates a ball and the figure of a rehearsal from their first contact until they can no longer
/// meet, then the next ball, which may meet another rehearsal. Allocates nothing for a ball, except
/// for more contacts than ever before.
class RehearsalRun {
 public:
  /// Both arguments must outlive this.
  RehearsalRun(const FigureModel& figure_model, const SimulationOptions& options);

  /// Goes to the first contact. Returns whether there is a step to take from there; if not, the
  /// result is complete. `track` must outlive the run. Throws Error as Simulator::simulate.
  bool start(const Rehearsal::Track& track, const features::Ball& ball);
  /// A step, in a lane beside those of other runs: call put_step, factor_trees(), solve_contacts,
  /// move_figures() and end_step, each for all lanes. The last returns whether there is another
  /// step to take; if not, the result is complete.
  template <std::size_t kLanes>
  void put_step(TreeLanes<kLanes>& lanes, std::size_t lane) {
    ReferenceState& target = target_of_step();
    target = track_->reference.at(encounter_.time_s() + step_s_);
    encounter_.put_step(*now_, target, step_s_, lanes, lane);
  }
  template <std::size_t kLanes>
  void solve_contacts(TreeLanes<kLanes>& lanes, std::size_t lane) {
    encounter_.solve_contacts(lanes, lane);
  }
  template <std::size_t kLanes>
  bool end_step(const TreeLanes<kLanes>& lanes, std::size_t lane) {
    const double stepped_s = encounter_.end_step(lanes, lane);
    if (options_.measures_limits) measure_limits(stepped_s);
    if (stepped_s >= step_s_) {
      now_.emplace(target_of_step());
    } else {
      now_.emplace(track_->reference, encounter_.time_s());
    }
    ++result_.steps;
    result_.is_finite = is_finite();
    return result_.is_finite && begin_step();
  }
  const SimulationResult& result() const { return result_; }

 private:
  bool begin_step();
  ReferenceState& target_of_step() { return targets_[static_cast<std::size_t>(result_.steps % 2)]; }
  bool leaves(double time_s) const;
  bool is_finite() const;
  void measure_limits(double stepped_s);

  const FigureModel& figure_model_;
  const SimulationOptions& options_;
  Encounter<TreeScene> encounter_;
  const Rehearsal::Track* track_ = nullptr;
  std::array<ReferenceState, 2> targets_;  // of this step and the last
  std::optional<ReferenceOnDemand> now_;   // the reference at the start of the step
  double step_s_ = 0;                      ///< of the step that has begun
  double follows_until_s_ = 0;             ///< until when limits are measured
  SimulationResult result_;
};

}  // namespace flinch::sim
