// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "motion/rotation.h"
#include "tests/sim/figure_motions.h"

namespace flinch::scenes {

/// A ball, and the index of the motion that it meets.
struct Hit {
  std::size_t motion = 0;
  features::Ball ball;
};

/// Volleyballs distributed as threats are: 8 to 30 m/s, from any direction, elevations of -10 to 45
/// degrees, aimed at the middle of each target in turn, between a third and two thirds into each
/// motion in turn.
inline std::vector<Hit> random_hits(const motion::Physique& character,
                                    const std::vector<NamedMotion>& motions, std::size_t count,
                                    unsigned seed) {
  std::mt19937 generator(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  const motion::BodyModel model = make_body_model(character);
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index = i % motions.size();
    const motion::Motion& motion = motions[index].motion;
    const double time_s = uniform(1.0 / 3, 2.0 / 3) * static_cast<double>(motion.duration_s());
    const auto frames =
        forward_kinematics(character.skeleton, motion::sample(motion, static_cast<float>(time_s)));
    const auto target = static_cast<motion::Target>(i / motions.size() % motion::kTargetCount);
    const double azimuth = uniform(0, 2 * std::numbers::pi);
    const double elevation = motion::radians(uniform(-10, 45));
    const Eigen::Vector3d from(std::cos(azimuth) * std::cos(elevation),
                               std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
    hits.push_back({index, aimed_ball(target_centre(model, frames, target).cast<double>(),
                                      -uniform(8, 30) * from, time_s)});
  }
  return hits;
}

}  // namespace flinch::scenes
