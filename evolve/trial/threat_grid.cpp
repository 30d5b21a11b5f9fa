// SPDX-License-Identifier: MIT
#include "evolve/trial/threat_grid.h"

#include <cmath>

namespace flinch::evolve {

std::array<features::Ball, kGridCells> thrown_balls(const AimedThrow& thrown,
                                                    const ThreatGrid& grid,
                                                    features::Random& random) {
  const Eigen::Vector3d from(std::cos(thrown.elevation) * std::cos(thrown.azimuth),
                             std::cos(thrown.elevation) * std::sin(thrown.azimuth),
                             std::sin(thrown.elevation));
  // The thrower looks along -from: to the right is -from x Z, normalised, and up is right x -from.
  const Eigen::Vector3d right(-std::sin(thrown.azimuth), std::cos(thrown.azimuth), 0);
  const Eigen::Vector3d up = from.cross(right);
  const Eigen::Vector3d start = thrown.aim + thrown.speed_mps * thrown.time_to_impact_s * from;
  std::array<features::Ball, kGridCells> balls;
  for (std::size_t cell = 0; cell < kGridCells; ++cell) {
    const auto column = static_cast<double>(cell % 3) - 1;
    const auto row = static_cast<double>(cell / 3) - 1;
    const double aside = column * grid.spacing_m + random.uniform(-grid.jitter_m, grid.jitter_m);
    const double below = row * grid.spacing_m + random.uniform(-grid.jitter_m, grid.jitter_m);
    const Eigen::Vector3d aim = thrown.aim + aside * right - below * up;
    features::Ball& ball = balls[cell];
    ball.position = start;
    ball.velocity = thrown.speed_mps * (aim - start).normalized();
    ball.radius = thrown.radius_m;
    ball.mass_kg = thrown.mass_kg;
    ball.gravity_mps2 = 0;
  }
  return balls;
}

}  // namespace flinch::evolve
