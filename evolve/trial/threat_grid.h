// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "features/ball.h"
#include "features/random.h"

namespace flinch::evolve {

/// A ball that is thrown at a part of the body, straight and without gravity (Rose 2006, section
/// 4.1.2). World frame.
struct AimedThrow {
  Eigen::Vector3d aim = Eigen::Vector3d::Zero();  ///< where its centre would be at the impact, m
  double azimuth = 0;    ///< where it comes from, radians counter-clockwise from +X
  double elevation = 0;  ///< how far above the horizontal it comes from, radians
  double speed_mps = 25;
  double time_to_impact_s = 0.5;  ///< from time 0, so all balls of a throw start at one point
  double radius_m = features::kVolleyballRadius_m;
  double mass_kg = features::kVolleyballMass_kg;
};

/// How far the balls of a test are from the aimed one, at its aim, m.
struct ThreatGrid {
  double spacing_m = 0.06;  ///< of the 3 by 3 cells (figure 4.4)
  double jitter_m = 0.01;   ///< the largest, in either direction, uniform
};
inline constexpr std::size_t kGridCells = 9;

/// The balls of one test: from the start of the aimed one, each turned to its cell and by a jitter
/// of its own. Cells go row by row, from the left to the right as the thrower sees them.
std::array<features::Ball, kGridCells> thrown_balls(const AimedThrow& thrown,
                                                    const ThreatGrid& grid,
                                                    features::Random& random);

}  // namespace flinch::evolve
