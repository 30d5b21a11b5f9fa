// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "features/ball.h"
#include "sim/contact/step_path.h"
#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"
#include "sim/rehearsal/rehearsal.h"
#include "sim/simulation_options.h"

namespace flinch::sim {

/// What a rehearsal keeps: the figure at the start of every free step, and at the end of the last.
/// record() steps the undisturbed figure.
struct Rehearsal::Track {
  /// Nothing is recorded yet. `figure_model` must outlive the track.
  Track(const FigureModel& figure_model, const SimulationOptions& options, motion::Motion response,
        double kept_from_s, double rehearsed_s);
  Track(const Track&) = delete;
  Track& operator=(const Track&) = delete;

  /// Takes over what is recorded of a track of the same duration.
  void copy_recording(const Track& other);

  std::size_t byte_count() const;
  /// The figure at the start of a step; for the number of steps, at the end of the last.
  const motion::PerBody<BodyState>& figure_at(std::size_t step) const {
    return figures[step - first_kept];
  }
  StepPath path_of(std::size_t step) const {
    return {figure_at(step), figure_at(step + 1), step_s(step)};
  }
  /// Length of a step, s.
  double step_s(std::size_t step) const {
    const bool is_last = step + 1 == step_begins_s.size();
    return (is_last ? duration_s : step_begins_s[step + 1]) - step_begins_s[step];
  }

  motion::Motion motion;
  Reference reference;
  double from_s;
  double duration_s;
  double recorded_s = 0;              ///< the time until which it is recorded
  std::vector<double> step_begins_s;  ///< one per step
  /// Bounding sphere of the figure over a whole step.
  struct Sphere {
    Eigen::Vector3d centre;
    double radius = 0;
    bool may_reach(const features::Ball& ball, double time_s, double distance_m) const;
  };
  std::vector<Sphere> reach;
  std::size_t first_kept = 0;  ///< index of a step
  std::vector<motion::PerBody<BodyState>> figures;
};

}  // namespace flinch::sim
