// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

namespace flinch::features {

/// A ball in free flight: x(t) = x + v t - g t^2 / 2 z. World frame.
struct FreeFlight {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its centre, m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
  double radius = 0;                                   ///< m
  double gravity_mps2 = 0;

  Eigen::Vector3d position_at(double time_s) const;
  Eigen::Vector3d velocity_at(double time_s) const;
};

/// Returns the first time in [0, horizon_s] at which the falling ball comes within touch_m of the
/// ground.
std::optional<double> time_of_bounce(const FreeFlight& ball, double horizon_s, double touch_m);

}  // namespace flinch::features
