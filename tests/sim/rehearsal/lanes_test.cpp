// SPDX-License-Identifier: MIT
// Rehearsals and throws side by side, in the lanes of vector instructions.
#include <gtest/gtest.h>

#include <limits>

#include "sim/rehearsal/throw_simulator.h"
#include "sim/rehearsal/track_lanes.h"
#include "tests/sim/rehearsal/rehearsal_fixture.h"
#include "tests/sim/same_bits.h"

namespace flinch::sim {
namespace {

using motion::Body;

/// The numbers of lanes that this processor has.
std::vector<std::size_t> lane_counts() {
  std::vector<std::size_t> counts;
  for (std::size_t lanes = 1; lanes <= widest_lanes(); lanes *= 2) counts.push_back(lanes);
  return counts;
}

// Of several rehearsals, and among balls that bounce first or miss.
TEST_F(RehearsalTest, ThrowsSideBySideHaveTheBitsOfEachAlone) {
  const auto rehearsed = rehearsals();
  std::vector<Throw> throws;
  for (const scenes::Hit& hit : balls(120, 16)) {
    throws.push_back({rehearsed[hit.motion], hit.ball});
  }
  for (const std::size_t lanes : lane_counts()) {
    SCOPED_TRACE(lanes);
    ThrowSimulator simulator(simulator_, lanes);
    int hits = 0;
    int misses = 0;
    for (int again = 0; again < 2; ++again) {
      const std::vector<SimulationResult> together = simulator.simulate(throws);
      ASSERT_EQ(together.size(), throws.size());
      for (std::size_t i = 0; i < throws.size(); ++i) {
        const SimulationResult alone = simulator_.simulate(throws[i].rehearsal, throws[i].ball);
        scenes::expect_same_bits(alone, together[i]);
        EXPECT_EQ(alone.skipped, together[i].skipped);
        ++(alone.steps > 0 ? hits : misses);
      }
    }
    EXPECT_GT(hits, 2 * 60);
    EXPECT_GT(misses, 2 * 5);
  }
}

void expect_same_bits(const Rehearsal& first, const Rehearsal& second) {
  const Rehearsal::Track& one = first.track();
  const Rehearsal::Track& other = second.track();
  EXPECT_EQ(one.first_kept, other.first_kept);
  EXPECT_EQ(one.step_begins_s, other.step_begins_s);
  ASSERT_EQ(one.reach.size(), other.reach.size());
  for (std::size_t k = 0; k < one.reach.size(); ++k) {
    EXPECT_EQ(one.reach[k].centre, other.reach[k].centre);
    EXPECT_EQ(one.reach[k].radius, other.reach[k].radius);
  }
  ASSERT_EQ(one.figures.size(), other.figures.size());
  for (std::size_t k = 0; k < one.figures.size(); ++k)
    for (const Body body : motion::kBodies) {
      const BodyState& a = one.figures[k][body];
      const BodyState& b = other.figures[k][body];
      EXPECT_EQ(a.position, b.position);
      EXPECT_EQ(a.orientation.coeffs(), b.orientation.coeffs());
      EXPECT_EQ(a.velocity, b.velocity);
      EXPECT_EQ(a.angular_velocity, b.angular_velocity);
    }
}

TEST_F(RehearsalTest, MotionsSideBySideHaveTheBitsOfEachAlone) {
  std::vector<motion::Motion> motions;
  for (const auto& [name, motion] : motions_) motions.push_back(motion);
  for (const double from_s : {0.0, 0.25}) {
    for (const std::size_t lanes : lane_counts()) {
      SCOPED_TRACE(lanes);
      const std::vector<Rehearsal> together = simulator_.rehearse(motions, from_s, 1, lanes);
      ASSERT_EQ(together.size(), motions.size());
      for (std::size_t i = 0; i < motions.size(); ++i)
        expect_same_bits(simulator_.rehearse(motions[i], from_s, 1), together[i]);
    }
  }
}

// They part at different poses, some before and some after what is kept begins; one does not part.
TEST_F(RehearsalTest, WhatMotionsBeginWithInCommonChangesNoBit) {
  const motion::Motion& ducks = motions_[1].motion;
  const motion::Motion& other = motions_[2].motion;
  for (const std::size_t parts : {3UL, 4UL, 12UL, 13UL, 30UL, 200UL}) {
    SCOPED_TRACE(parts);
    std::vector<motion::Motion> motions(3, ducks);
    for (std::size_t k = parts; k < ducks.poses.size() && k < other.poses.size(); ++k)
      motions[1].poses[k] = other.poses[k];
    motions[2].poses.resize(std::min(parts + 5, ducks.poses.size()));
    const std::vector<Rehearsal> together = simulator_.rehearse(motions, 0.22, 0.8);
    for (std::size_t i = 0; i < motions.size(); ++i)
      expect_same_bits(simulator_.rehearse(motions[i], 0.22, 0.8), together[i]);
  }
}

TEST_F(RehearsalTest, BadNumbersAreToldAndChangeNoOtherThrow) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto rehearsed = rehearsals();
  std::vector<Throw> good;
  std::vector<Throw> mixed;
  for (const scenes::Hit& hit : scenes::random_hits(character_, motions_, 40, 17)) {
    good.push_back({rehearsed[hit.motion], hit.ball});
    features::Ball bad = hit.ball;
    if (good.size() % 3 == 0) bad.velocity.y() = kNan;
    if (good.size() % 3 == 1) bad.mass_kg = kNan;
    if (good.size() % 3 == 2) bad.mass_kg = 0;
    mixed.push_back(good.back());
    mixed.push_back({rehearsed[hit.motion], bad});
  }
  for (const std::size_t lanes : lane_counts()) {
    SCOPED_TRACE(lanes);
    ThrowSimulator simulator(simulator_, lanes);
    const std::vector<SimulationResult> alone = simulator.simulate(good);
    const std::vector<SimulationResult> beside = simulator.simulate(mixed);
    int told = 0;
    for (std::size_t i = 0; i < good.size(); ++i) {
      EXPECT_TRUE(alone[i].is_finite);
      scenes::expect_same_bits(alone[i], beside[2 * i]);
      if (alone[i].steps == 0) continue;
      EXPECT_FALSE(beside[2 * i + 1].is_finite) << i;
      ++told;
    }
    EXPECT_GT(told, 25);
  }
}

}  // namespace
}  // namespace flinch::sim
