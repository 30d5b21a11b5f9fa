// SPDX-License-Identifier: MIT
#include "motion/offset_spring.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace flinch::motion {
namespace {

struct State {
  double x;
  double v;
};

/// Equation 1 by the classic Runge-Kutta method in steps of 0.1 ms.
State integrated(State state, double time_s) {
  const auto rate = [](State s) { return State{s.v, -50 * s.x - 10 * s.v}; };
  const auto moved = [](State s, State by, double h) {
    return State{s.x + h * by.x, s.v + h * by.v};
  };
  constexpr double kStep_s = 1e-4;
  for (long step = std::lround(time_s / kStep_s); step > 0; --step) {
    const State a = rate(state);
    const State b = rate(moved(state, a, kStep_s / 2));
    const State c = rate(moved(state, b, kStep_s / 2));
    const State d = rate(moved(state, c, kStep_s));
    state.x += kStep_s / 6 * (a.x + 2 * b.x + 2 * c.x + d.x);
    state.v += kStep_s / 6 * (a.v + 2 * b.v + 2 * c.v + d.v);
  }
  return state;
}

State after(State start, float time_s) {
  const OffsetSpring spring = offset_spring(time_s);
  const auto weighed = [&](float x, float v) { return double{x} * start.x + double{v} * start.v; };
  return {weighed(spring.position, spring.velocity),
          weighed(spring.rate.position, spring.rate.velocity)};
}

TEST(OffsetSpring, MatchesFineIntegrationOfEquationOne) {
  for (const State start : {State{0.3, 0}, State{0, 1}, State{-0.1, 0.7}}) {
    for (const float time_s : {0.0F, 0.01F, 0.1F, 0.35F, 1.0F, 2.0F}) {
      const State expected = integrated(start, double{time_s});
      const State closed = after(start, time_s);
      EXPECT_NEAR(closed.x, expected.x, 1e-6) << time_s;
      EXPECT_NEAR(closed.v, expected.v, 4e-6) << time_s;
    }
  }
}

TEST(OffsetSpring, IsTheSameAtAnyFrameRate) {
  const State start{0.2, -0.5};
  const State at_once = after(start, 0.5F);
  for (const int frames : {15, 30, 72}) {
    State state = start;
    for (int k = 0; k < frames; ++k) state = after(state, 0.5F / static_cast<float>(frames));
    EXPECT_NEAR(state.x, at_once.x, 2e-6) << frames;
    EXPECT_NEAR(state.v, at_once.v, 1e-5) << frames;
  }
}

TEST(OffsetSpring, TakesAJumpOfThirtyCentimetresBelowOneInOneAndAHalfSeconds) {
  for (float time_s = 1.5F; time_s < 3; time_s += 0.1F)
    EXPECT_LT(std::abs(after({0.3, 0}, time_s).x), 0.01);
}

}  // namespace
}  // namespace flinch::motion
