// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "sim/ode/ode_simulator.h"
#include "sim/rehearsal/simulator.h"
#include "tests/sim/random_hits.h"

namespace flinch::sim {

/// A character with motions made by rule, the simulator that is tested, and ODE to compare it with.
class RehearsalTest : public testing::Test {
 protected:
  motion::Physique character_ = motion::default_character();
  std::vector<scenes::NamedMotion> motions_ = scenes::motions_by_rule(character_.skeleton);
  Simulator simulator_{character_, {}};
  OdeSimulator reference_{character_, {}};

  std::vector<Rehearsal> rehearsals(double from_s = 0) const {
    std::vector<Rehearsal> result;
    for (const auto& [name, motion] : motions_) {
      result.push_back(simulator_.rehearse(motion, from_s, 1));
    }
    return result;
  }
  /// Balls aimed at the figure and then turned aside, so that many just miss it or glance off.
  std::vector<scenes::Hit> balls(std::size_t count, unsigned seed) const {
    auto hits = scenes::random_hits(character_, motions_, count, seed);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> aside(-0.3, 0.3);
    for (scenes::Hit& hit : hits) {
      hit.ball.position += Eigen::Vector3d(aside(generator), aside(generator), aside(generator));
    }
    return hits;
  }
};

}  // namespace flinch::sim
