// SPDX-License-Identifier: MIT
// Where the ball and the bodies that it drives hit.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/ode/ode_simulator.h"
#include "sim/rehearsal/simulator.h"
#include "tests/sim/random_hits.h"

namespace flinch::sim {
namespace {

using motion::Body;

SimulationOptions with_places() {
  SimulationOptions options;
  options.keeps_places = true;
  return options;
}

class PlacesTest : public testing::Test {
 protected:
  motion::Physique character_ = motion::default_character();
  motion::BodyModel bodies_ = make_body_model(character_);
  std::vector<scenes::NamedMotion> motions_ = scenes::motions_by_rule(character_.skeleton);
  std::vector<scenes::Hit> hits_ = scenes::random_hits(character_, motions_, 60, 5);

  SimulationResult fast(const SimulationOptions& options, const scenes::Hit& hit) const {
    const Simulator simulator(character_, options);
    return simulator.simulate(simulator.rehearse(motions_[hit.motion].motion, 0, 1), hit.ball);
  }
  SimulationResult slow(const SimulationOptions& options, const scenes::Hit& hit) const {
    return OdeSimulator(character_, options).simulate(motions_[hit.motion].motion, &hit.ball, 1);
  }
};

TEST_F(PlacesTest, ImpulsesOfThePlacesAddUpToThoseOfTheBodies) {
  int from_bodies = 0;
  for (const scenes::Hit& hit : hits_) {
    for (const SimulationResult& result : {fast(with_places(), hit), slow(with_places(), hit)}) {
      motion::PerBody<double> sum;
      for (const PlacedImpulse& place : result.places) {
        sum[place.body] += place.impulse_ns;
        from_bodies += place.from_ball ? 0 : 1;
      }
      for (const Body body : motion::kBodies)
        EXPECT_NEAR(sum[body], result.impulse[body], 1e-12 + 1e-12 * sum[body]) << name_of(body);
      if (!result.places.empty()) {
        EXPECT_DOUBLE_EQ(result.places.front().time_s, result.first_contact_s);
      }
    }
  }
  EXPECT_GT(from_bodies, 10);
}

TEST_F(PlacesTest, LieOnTheSurfaceOfTheirBodyAsTheReferenceFindsThem) {
  int compared = 0;
  for (const scenes::Hit& hit : hits_) {
    const SimulationResult found = fast(with_places(), hit);
    for (const PlacedImpulse& place : found.places) {
      const double gap = motion::gap(place.point, 0, collision_shape_of(bodies_[place.body].shape));
      // Bodies that press each other overlap by some millimetres.
      EXPECT_NEAR(gap, 0, place.from_ball ? 2e-4 : 6e-3) << name_of(place.body);
    }
    const SimulationResult expected = slow(with_places(), hit);
    if (found.places.empty() || expected.places.empty()) continue;
    EXPECT_EQ(found.places.front().body, expected.places.front().body);
    EXPECT_LT((found.places.front().point - expected.places.front().point).norm(), 1e-4);
    EXPECT_LT((found.places.front().point_world - expected.places.front().point_world).norm(),
              1e-4);
    ++compared;
  }
  EXPECT_GT(compared, 40);
}

TEST_F(PlacesTest, AreLeftOutUnlessAskedForAndChangeNothing) {
  for (const scenes::Hit& hit : hits_) {
    const SimulationResult without = fast({}, hit);
    EXPECT_TRUE(without.places.empty());
    EXPECT_EQ(without.impulse, fast(with_places(), hit).impulse);
  }
}

TEST_F(PlacesTest, ABallPassesThroughBodiesThatItDoesNotMeet) {
  SimulationOptions options = with_places();
  const auto hit_bodies = [](const SimulationResult& result) {
    BodySet bodies = 0;
    for (const PlacedImpulse& place : result.places)
      if (place.from_ball) bodies |= set_of(place.body);
    return bodies;
  };
  int passed = 0;
  for (const scenes::Hit& hit : hits_) {
    const SimulationResult all = fast(options, hit);
    if (all.places.empty()) continue;
    const Body first = all.places.front().body;
    SimulationOptions fewer = options;
    fewer.ball_meets = kAllBodies & ~set_of(first);
    const SimulationResult found = fast(fewer, hit);
    const SimulationResult expected = slow(fewer, hit);
    EXPECT_FALSE(contains(hit_bodies(found), first));
    EXPECT_EQ(found.places.empty(), expected.places.empty());
    if (!found.places.empty()) {
      EXPECT_NEAR(found.first_contact_s, expected.first_contact_s, 1e-6);
      EXPECT_GE(found.first_contact_s, all.first_contact_s - 1e-9);
    }
    ++passed;
  }
  EXPECT_GT(passed, 40);
}

}  // namespace
}  // namespace flinch::sim
