// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "features/ball.h"
#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"
#include "sim/rehearsal/rehearsal.h"
#include "sim/simulation_options.h"

namespace flinch::sim {

/// The states that a rehearsal keeps: the figure at the start of every free step.
struct Rehearsal::Track {
  /// Runs the undisturbed simulation. `figure_model` must outlive the track.
  Track(const FigureModel& figure_model, const SimulationOptions& options,
        const motion::Motion& response, double kept_from_s, double rehearsed_s);
  Track(const Track&) = delete;
  Track& operator=(const Track&) = delete;

  std::size_t byte_count() const;
  const motion::PerBody<BodyState>& figure_at(std::size_t step) const {
    return figures[step - first_kept];
  }

  motion::Motion motion;
  Reference reference;
  double from_s;
  double duration_s;
  std::vector<double> step_begins_s;  ///< one per step
  /// Bounding sphere of the figure over the whole step, with the accelerations that the sweep
  /// allows for.
  struct Sphere {
    Eigen::Vector3d centre;
    double radius = 0;
  };
  std::vector<Sphere> reach;
  std::size_t first_kept = 0;  ///< index of a step
  std::vector<motion::PerBody<BodyState>> figures;
};

}  // namespace flinch::sim
