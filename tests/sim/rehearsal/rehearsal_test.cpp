// SPDX-License-Identifier: MIT
#include "sim/rehearsal/rehearsal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "motion/error.h"
#include "sim/figure/figure_rows.h"
#include "sim/rehearsal/first_contact.h"
#include "sim/rehearsal/throw_simulator.h"
#include "sim/rehearsal/track_lanes.h"
#include "tests/sim/rehearsal/rehearsal_fixture.h"
#include "tests/sim/rehearsal/total_impulse.h"
#include "tests/sim/same_bits.h"

namespace flinch::sim {
namespace {

using motion::Body;
using tests::total_impulse;

/// sum over the bodies |J - J'|, divided by the greater total.
double change(const SimulationResult& first, const SimulationResult& second) {
  double sum = 0;
  for (Body body : motion::kBodies) sum += std::abs(first.impulse[body] - second.impulse[body]);
  const double whole = std::max(total_impulse(first), total_impulse(second));
  return whole > 0 ? sum / whole : 0;
}

TEST_F(RehearsalTest, ImpulsesMatchTheFullSimulation) {
  const auto rehearsed = rehearsals();
  int hits = 0;
  int misses = 0;
  int other = 0;
  for (const scenes::Hit& hit : balls(150, 11)) {
    const auto slow = reference_.simulate(motions_[hit.motion].motion, &hit.ball, 1);
    const auto fast = simulator_.simulate(rehearsed[hit.motion], hit.ball);
    EXPECT_EQ(total_impulse(slow) > 0, total_impulse(fast) > 0);
    if (total_impulse(slow) == 0) {
      ++misses;
      EXPECT_TRUE(std::isinf(fast.first_contact_s));
      continue;
    }
    ++hits;
    EXPECT_NEAR(slow.first_contact_s, fast.first_contact_s, 1e-6);
    EXPECT_LE(fast.steps, slow.steps);
    EXPECT_EQ(fast.solver_messages, 0);
    if (change(slow, fast) > 0.005) ++other;
  }
  EXPECT_GT(hits, 90);
  EXPECT_GT(misses, 5);
  EXPECT_LE(other, 2);
}

/// The same balls as fists and blades: heavy and straight, or small; neither bounces. A third of
/// the strokes ends before the contact, and another third starts after it.
std::vector<scenes::Hit> struck(std::vector<scenes::Hit> hits) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    features::Ball& ball = hits[i].ball;
    ball.bounce = {0, 0.5};
    if (i % 2 == 0) {
      ball.radius = 0.012;
      continue;
    }
    const features::Ball then = ball.at(0.5);  // near the figure
    ball.velocity = then.velocity;
    ball.position = then.position - 0.5 * then.velocity;
    ball.gravity_mps2 = 0;
    ball.mass_kg = 3;
    ball.radius = 0.05;
    const double until_s = i % 3 == 0 ? 0.2 : i % 3 == 1 ? 0.6 : 1;
    ball.window = {until_s - 0.3, until_s};
  }
  return hits;
}

TEST_F(RehearsalTest, ImpulsesOfFistsAndBladesMatchTheFullSimulation) {
  const auto rehearsed = rehearsals();
  int hits = 0;
  int strokes = 0;
  int other = 0;
  const std::vector<scenes::Hit> thrown = struck(balls(60, 12));
  for (const scenes::Hit& hit : thrown) {
    const auto slow = reference_.simulate(motions_[hit.motion].motion, &hit.ball, 1);
    const auto fast = simulator_.simulate(rehearsed[hit.motion], hit.ball);
    EXPECT_EQ(total_impulse(slow) > 0, total_impulse(fast) > 0);
    if (total_impulse(slow) == 0) continue;
    ++hits;
    strokes += hit.ball.gravity_mps2 == 0;
    EXPECT_GE(fast.first_contact_s, hit.ball.window.from_s);
    EXPECT_LE(fast.first_contact_s, hit.ball.window.until_s);
    EXPECT_NEAR(slow.first_contact_s, fast.first_contact_s, 1e-6);
    if (change(slow, fast) > 0.005) ++other;
  }
  EXPECT_GT(hits, 20);
  EXPECT_GT(strokes, 5);
  EXPECT_LE(other, 2);
}

/// The same balls as rods: every second one is swung at the figure about a grip, the others are
/// thrown and spin. Those of the last third are over before they could hit.
std::vector<scenes::Hit> drawn_out(std::vector<scenes::Hit> hits) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const features::Ball then = hits[i].ball.at(0.5);  // near the figure
    const double x = number(generator);
    const double y = number(generator);
    const double z = number(generator);
    const bool is_swung = i % 2 == 0;
    const Eigen::Vector3f along = then.velocity.normalized().cast<float>();
    features::ThreatDescription description;
    description.azimuth = std::atan2(-along.y(), -along.x());
    description.elevation = std::asin(-along.z());
    description.speed_mps = static_cast<float>(then.velocity.norm());
    description.radius = 0.03F;
    description.mass_kg = 0.9F;
    description.bounce = {0, 0.4};
    description.falls = !is_swung;
    if (is_swung) description.reach_m = 1.2F;
    description.rod = features::RodDescription{.length_m = 0.8F,
                                               .balance = is_swung ? 0.66F : 0.5F,
                                               .strikes_at = 0.7F + 0.2F * static_cast<float>(x),
                                               .tilt = 3 * static_cast<float>(y),
                                               .grip_share = is_swung ? 0.2F : 0,
                                               .grip_mass_kg = is_swung ? 2.0F : 0,
                                               .spin = is_swung ? 0 : 12 * static_cast<float>(z)};
    hits[i].ball = features::ball_of(
        features::threat_from_description(description, then.position.cast<float>(), 0));
    if (i % 3 == 2) hits[i].ball.window.until_s = std::min(hits[i].ball.window.until_s, 0.3);
  }
  return hits;
}

// With the steps of the full simulation; longer ones for what rests are tested below.
TEST_F(RehearsalTest, ImpulsesOfRodsMatchTheFullSimulation) {
  SimulationOptions short_steps;
  short_steps.resting_step_s = short_steps.contact_step_s;
  OdeSimulator reference(character_, short_steps);
  const Simulator simulator(character_, short_steps);
  const auto rehearsed = rehearsals();
  int hits = 0;
  int other = 0;
  for (const scenes::Hit& hit : drawn_out(balls(90, 13))) {
    const auto slow = reference.simulate(motions_[hit.motion].motion, &hit.ball, 1);
    const auto fast = simulator.simulate(rehearsed[hit.motion], hit.ball);
    EXPECT_EQ(total_impulse(slow) > 0, total_impulse(fast) > 0);
    if (total_impulse(slow) == 0) continue;
    ++hits;
    EXPECT_NEAR(slow.first_contact_s, fast.first_contact_s, 1e-6);
    EXPECT_EQ(fast.solver_messages, 0);
    if (change(slow, fast) > 0.005) ++other;
  }
  EXPECT_GT(hits, 25);
  EXPECT_LE(other, 1);
}

/// The same balls as medicine balls: heavy, slow and dead.
std::vector<scenes::Hit> heavy(std::vector<scenes::Hit> hits) {
  for (scenes::Hit& hit : hits) {
    const features::Ball then = hit.ball.at(0.5);  // near the figure
    hit.ball.mass_kg = 4;
    hit.ball.bounce = {0.2, 0.5};
    hit.ball.velocity = 0.3 * then.velocity;
    hit.ball.position = then.position - 0.5 * hit.ball.velocity;
    hit.ball.gravity_mps2 = 0;
  }
  return hits;
}

/// How much the impulses of hits change, with steps of contacts for those that rest; relative to
/// what all of them give.
struct RestingChange {
  double mean = 0;    ///< of the whole impulse of a hit, with its sign
  double spread = 0;  ///< sum over hits and bodies of |J - J'|
  double steps = 0;   ///< share of the steps that are left
};

RestingChange change_by_resting(const motion::Physique& character,
                                const std::vector<scenes::NamedMotion>& motions,
                                const std::vector<scenes::Hit>& hits) {
  SimulationOptions short_steps;
  short_steps.resting_step_s = short_steps.contact_step_s;
  const Simulator fine(character, short_steps);
  const Simulator coarse(character, {});
  RestingChange change;
  double whole = 0;
  double fine_steps = 0;
  for (const scenes::Hit& hit : hits) {
    const motion::Motion& motion = motions[hit.motion].motion;
    const auto exact = fine.simulate(fine.rehearse(motion, 0, 1), hit.ball);
    const auto found = coarse.simulate(coarse.rehearse(motion, 0, 1), hit.ball);
    EXPECT_EQ(exact.first_contact_s, found.first_contact_s);
    whole += total_impulse(exact);
    change.mean += total_impulse(found) - total_impulse(exact);
    for (Body body : motion::kBodies)
      change.spread += std::abs(found.impulse[body] - exact.impulse[body]);
    fine_steps += exact.steps;
    change.steps += found.steps;
  }
  return {change.mean / whole, change.spread / whole, change.steps / fine_steps};
}

TEST_F(RehearsalTest, LongStepsOfRestingContactsChangeImpulsesLittle) {
  const std::pair<const char*, std::vector<scenes::Hit>> cases[] = {
      {"heavy", heavy(balls(60, 14))},
      {"struck", struck(balls(60, 15))},
      {"rods", drawn_out(balls(60, 16))}};
  for (const auto& [name, hits] : cases) {
    SCOPED_TRACE(name);
    const RestingChange change = change_by_resting(character_, motions_, hits);
    EXPECT_LT(std::abs(change.mean), 0.01);
    EXPECT_LT(change.spread, 0.05);
    EXPECT_LT(change.steps, 0.95);
  }
}

// What bounces is simulated as ever.
TEST_F(RehearsalTest, RestingContactsChangeNoBitOfBalls) {
  for (const scenes::Hit& hit : balls(40, 17)) {
    SimulationOptions short_steps;
    short_steps.resting_step_s = short_steps.contact_step_s;
    const Simulator fine(character_, short_steps);
    const motion::Motion& motion = motions_[hit.motion].motion;
    const auto exact = fine.simulate(fine.rehearse(motion, 0, 1), hit.ball);
    const auto found = simulator_.simulate(simulator_.rehearse(motion, 0, 1), hit.ball);
    EXPECT_EQ(exact.steps, found.steps);
    for (Body body : motion::kBodies) EXPECT_EQ(exact.impulse[body], found.impulse[body]);
  }
}

// The ball falls before the shins, bounces off the ground and hits them on its way up.
TEST_F(RehearsalTest, FindsHitsAfterABounceOffTheGround) {
  const Rehearsal standing = simulator_.rehearse(motions_[0].motion, 0, 1);
  int hits = 0;
  for (int i = 0; i < 12; ++i) {
    const features::Ball ball =
        scenes::aimed_ball({0.45 + 0.02 * i, 0.1, 0.106}, {-4.0, 0, -4.0}, 0.3);
    const auto slow = reference_.simulate(motions_[0].motion, &ball, 1);
    const auto fast = simulator_.simulate(standing, ball);
    EXPECT_LT(change(slow, fast), 0.005);
    if (total_impulse(slow) > 0 && slow.first_contact_s > 0.3) ++hits;
  }
  EXPECT_GT(hits, 6);
}

// Compares with the paths of figure and ball sampled so finely that a gap changes by at most 2 mm.
TEST_F(RehearsalTest, NothingTouchesBeforeTheFirstContact) {
  const FigureModel figure_model(character_);
  const SimulationOptions options;
  std::vector<std::unique_ptr<Rehearsal::Track>> tracks;
  for (const auto& [name, motion] : motions_) {
    tracks.push_back(std::make_unique<Rehearsal::Track>(figure_model, options, motion, 0, 1));
  }
  record(figure_model, options, tracks, widest_lanes());
  int met = 0;
  std::size_t samples = 0;
  for (const scenes::Hit& hit : balls(120, 12)) {
    if (hit.ball.position.z() < hit.ball.radius) continue;  // thrown from below the ground
    const Rehearsal::Track& track = *tracks[hit.motion];
    const auto contact = first_contact(figure_model, track, hit.ball);
    if (contact) ++met;
    const double until_s = contact ? contact->time_s : track.duration_s;
    for (std::size_t step = 0; step < track.step_begins_s.size(); ++step) {
      const auto& next = track.figure_at(step + 1);
      constexpr int kSamples = 250;
      for (int k = 0; k < kSamples; ++k) {
        const double later_s = options.free_step_s * k / kSamples;
        const double time_s = track.step_begins_s[step] + later_s;
        if (time_s >= until_s) break;
        ++samples;
        const Eigen::Vector3d centre = hit.ball.position_at(time_s);
        ASSERT_GT(centre.z(), hit.ball.radius);
        for (Body body : motion::kBodies) {
          // A step moves bodies with the velocity at its end.
          BodyState state = track.figure_at(step)[body];
          state.velocity = next[body].velocity;
          state.angular_velocity = next[body].angular_velocity;
          const MovingShape there = placed_shape(figure_model.outline[body], state);
          if ((there.centre - centre).norm() > 1) continue;
          ASSERT_GT(clearance(centre, hit.ball.radius, there.at(later_s)).gap, 0);
        }
      }
    }
  }
  EXPECT_GT(met, 80);
  EXPECT_GT(samples, 250'000U);
}

// The first contact is one: there the ball touches a part, or the ground.
TEST_F(RehearsalTest, TheFirstContactTouches) {
  const FigureModel figure_model(character_);
  const std::array tracks{std::make_unique<Rehearsal::Track>(figure_model, SimulationOptions{},
                                                             motions_[1].motion, 0, 1)};
  record(figure_model, {}, tracks, 1);
  const Rehearsal::Track& track = *tracks.front();
  int parts = 0;
  int bounces = 0;
  for (const scenes::Hit& hit : balls(120, 15)) {
    const auto contact = first_contact(figure_model, track, hit.ball);
    if (!contact || contact->time_s < 1e-3) continue;  // thrown from where it touches
    const features::Ball ball = hit.ball.at(contact->time_s);
    double gap = ball.position.z() - ball.radius;
    for (Body body : motion::kBodies) {
      const MovingShape shape = placed_shape(figure_model.outline[body], contact->figure[body]);
      gap = std::min(gap, motion::gap(ball.position, ball.radius, shape));
    }
    EXPECT_LE(gap, 1e-4 + 1e-12);
    EXPECT_GT(gap, 0);
    EXPECT_EQ(contact->is_bounce, ball.position.z() - ball.radius <= 1e-4 + 1e-12);
    ++(contact->is_bounce ? bounces : parts);
  }
  EXPECT_GT(parts, 20);
  EXPECT_GT(bounces, 5);
}

// The ground carries a rolling ball in every step, which is no contact that ends a step.
TEST_F(RehearsalTest, ARollingBallDoesNotShortenTheSteps) {
  const Rehearsal standing = simulator_.rehearse(motions_[0].motion, 0, 1);
  features::Ball rolling;
  rolling.position = {2, 2, rolling.radius};
  rolling.velocity = {0.5, 0, 0};
  EXPECT_LE(reference_.simulate(motions_[0].motion, &rolling, 1).steps, 62);
  EXPECT_EQ(simulator_.simulate(standing, rolling).steps, 0);
}

TEST_F(RehearsalTest, SkipsBallsThatCannotTouch) {
  const Rehearsal standing = simulator_.rehearse(motions_[0].motion, 0, 1);
  const features::Ball wide = scenes::aimed_ball({0, 3, 2}, {-20, 0, 0}, 0.4);
  const auto missed = simulator_.simulate(standing, wide);
  EXPECT_TRUE(missed.skipped);
  EXPECT_EQ(missed.steps, 0);
  EXPECT_EQ(total_impulse(missed), 0);
  const features::Ball aimed = scenes::aimed_ball({0, 0, 1.2}, {-20, 0, 0}, 0.4);
  const auto hit = simulator_.simulate(standing, aimed);
  EXPECT_FALSE(hit.skipped);
  EXPECT_GT(total_impulse(hit), 1);
}

TEST_F(RehearsalTest, IsDeterministicOnConcurrentThreads) {
  const auto rehearsed = rehearsals();
  const auto hits = balls(40, 13);
  const auto run = [&](std::vector<SimulationResult>& results) {
    for (const scenes::Hit& hit : hits) {
      results.push_back(simulator_.simulate(rehearsed[hit.motion], hit.ball));
    }
  };
  scenes::expect_same_bits_on_threads(run);
}

// Balls of a fifth of a gram and of two tonnes, against parts of 0.4 to 15 kg.
TEST_F(RehearsalTest, BallsOfAnyMassHaveFiniteImpulses) {
  const auto rehearsed = rehearsals();
  std::vector<Throw> throws;
  for (scenes::Hit& hit : scenes::random_hits(character_, motions_, 60, 18)) {
    hit.ball.mass_kg = throws.size() % 2 == 0 ? 2e-4 : 2e3;
    throws.push_back({rehearsed[hit.motion], hit.ball});
  }
  ThrowSimulator simulator(simulator_);
  for (const SimulationResult& result : simulator.simulate(throws)) {
    EXPECT_TRUE(result.is_finite);
    EXPECT_TRUE(std::isfinite(total_impulse(result)));
  }
}

TEST_F(RehearsalTest, LaterStartGivesTheSameBitsInLessMemory) {
  const auto whole = rehearsals();
  const auto late = rehearsals(0.25);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_LT(late[i].byte_count(), whole[i].byte_count());
    EXPECT_EQ(late[i].from_s(), 0.25);
  }
  int hits = 0;
  for (const scenes::Hit& hit : scenes::random_hits(character_, motions_, 40, 14)) {
    const auto expected = simulator_.simulate(whole[hit.motion], hit.ball);
    if (expected.first_contact_s < 0.32) continue;
    try {
      scenes::expect_same_bits(expected, simulator_.simulate(late[hit.motion], hit.ball));
      ++hits;
    } catch (const Error&) {  // came near the figure before 0.25 s, or hit it
    }
  }
  EXPECT_GT(hits, 10);
}

TEST_F(RehearsalTest, RejectsABallThatArrivesBeforeItsStart) {
  const Rehearsal late = simulator_.rehearse(motions_[0].motion, 0.6, 1);
  const features::Ball early = scenes::aimed_ball({0, 0, 1.2}, {-20, 0, 0}, 0.3);
  EXPECT_THROW(simulator_.simulate(late, early), Error);
}

}  // namespace
}  // namespace flinch::sim
