// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "sim/encounter/encounter.h"
#include "sim/rehearsal/rehearsal_track.h"

namespace flinch::sim {

/// Steps the undisturbed figure of a track, and records it there.
class TrackRun {
 public:
  /// Both arguments must outlive this.
  TrackRun(const FigureModel& figure_model, const SimulationOptions& options);

  /// Goes on where the recording of a track ends: at time 0 if it is empty. `track` must outlive
  /// the run.
  void start(Rehearsal::Track& track);
  /// Begins a step and returns whether there was one to take; if not, the recording is complete.
  bool begin_step();
  /// The step that has begun, in a lane beside those of other runs: call put_step, factor_trees(),
  /// solve_contacts, move_figures() and end_step, each for all lanes.
  template <std::size_t kLanes>
  void put_step(TreeLanes<kLanes>& lanes, std::size_t lane) {
    const ReferenceOnDemand now(now_);
    target_ = track_->reference.at(encounter_.time_s() + step_s_);
    encounter_.put_step(now, target_, step_s_, lanes, lane);
  }
  template <std::size_t kLanes>
  void solve_contacts(TreeLanes<kLanes>& lanes, std::size_t lane) {
    encounter_.solve_contacts(lanes, lane);
  }
  template <std::size_t kLanes>
  void end_step(const TreeLanes<kLanes>& lanes, std::size_t lane) {
    encounter_.end_step(lanes, lane);
    now_ = target_;
    record();
  }
  /// When the next step begins, s.
  double time_s() const { return encounter_.time_s(); }

 private:
  void record();

  const FigureModel& figure_model_;
  Encounter<TreeScene> encounter_;
  Rehearsal::Track* track_ = nullptr;
  ReferenceState now_;     // the reference at the start of the step
  ReferenceState target_;  // and at its end
  double step_s_ = 0;      // of the step that has begun
};

}  // namespace flinch::sim
