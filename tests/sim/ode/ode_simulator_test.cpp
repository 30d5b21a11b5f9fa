// SPDX-License-Identifier: MIT
#include "sim/ode/ode_simulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "motion/error.h"
#include "sim/ode/ode_world.h"
#include "tests/scenes/error_of.h"
#include "tests/sim/random_hits.h"
#include "tests/sim/rehearsal/total_impulse.h"
#include "tests/sim/same_bits.h"

namespace flinch::sim {
namespace {

using motion::Body;
using tests::total_impulse;

constexpr double kRestitution = 0.7;

const motion::Physique& character() {
  static const motion::Physique man = motion::default_character();
  return man;
}

motion::Motion standing_still(float duration_s = 1) {
  motion::Motion motion;
  const auto count = static_cast<std::size_t>(duration_s * motion.rate_hz) + 1;
  motion.poses.assign(count, scenes::standing(character().skeleton));
  return motion;
}

Eigen::Vector3d middle_of(Body body, const motion::Pose& pose) {
  const auto frames = forward_kinematics(character().skeleton, pose);
  return centre_of_mass(make_body_model(character()), frames, body).cast<double>();
}

SimulationResult simulate(const motion::Motion& motion, const features::Ball* ball,
                          double duration_s = 1) {
  return OdeSimulator(character(), {}).simulate(motion, ball, duration_s);
}

/// Balls from all sides at all heights, most of which hit.
std::vector<features::Ball> many_balls(const motion::Pose& pose) {
  std::vector<features::Ball> balls;
  for (int i = 0; i < 12; ++i) {
    const double azimuth = 0.55 * i;
    const Body body = motion::kBodies[static_cast<std::size_t>(i * 5 % motion::kBodyCount)];
    const Eigen::Vector3d direction(std::cos(azimuth), std::sin(azimuth), 0.1 * (i % 3));
    balls.push_back(scenes::aimed_ball(middle_of(body, pose), -(10.0 + 1.5 * i) * direction, 0.3));
  }
  return balls;
}

TEST(OdeSimulator, StandsForTwoSecondsWithinACentimetre) {
  const auto result = simulate(standing_still(2), nullptr, 2);
  EXPECT_LT(result.tracking_error_m, 0.01);
  EXPECT_EQ(total_impulse(result), 0);
  EXPECT_TRUE(std::isinf(result.first_contact_s));
}

TEST(OdeSimulator, TracksMotionsByRuleWithinFiveCentimetres) {
  for (const auto& [name, motion] : scenes::motions_by_rule(character().skeleton)) {
    const auto result = simulate(motion, nullptr);
    EXPECT_LT(result.tracking_error_m, 0.05) << name;
    EXPECT_GT(result.steps, 50) << name;
  }
}

TEST(OdeSimulator, HoldsStillBeyondTheEndOfItsMotion) {
  const auto result = simulate(standing_still(0.25F), nullptr, 2);
  EXPECT_LT(result.tracking_error_m, 0.01);
}

TEST(OdeSimulator, AMissGivesNoImpulse) {
  const motion::Motion motion = standing_still();
  const features::Ball wide = scenes::aimed_ball({0, 2, 1}, {-20, 0, 0}, 0.4);
  const features::Ball late = scenes::aimed_ball({0, 0, 1.2}, {-20, 0, 0}, 1.5);
  for (const features::Ball& ball : {wide, late}) {
    const auto result = simulate(motion, &ball);
    EXPECT_EQ(total_impulse(result), 0);
    EXPECT_TRUE(std::isinf(result.first_contact_s));
  }
}

// One hit gives at most (1 + e) m v, the impulse on a wall. A chest with 75 kg behind it gives way
// little.
TEST(OdeSimulator, ImpulseOnTheChestIsNearlyThatOnAWall) {
  const motion::Motion motion = standing_still();
  for (double speed_mps : {10.0, 20.0, 30.0}) {
    const features::Ball ball =
        scenes::aimed_ball(middle_of(Body::chest, motion.poses.front()), {-speed_mps, 0, 0}, 0.3);
    const auto result = simulate(motion, &ball);
    const double wall = (1 + kRestitution) * features::kVolleyballMass_kg * speed_mps;
    EXPECT_LT(result.impulse[Body::chest], 1.01 * wall);
    EXPECT_GT(result.impulse[Body::chest], 0.85 * wall);
    EXPECT_NEAR(total_impulse(result), result.impulse[Body::chest], 1e-12);
  }
}

// A head on a neck takes at least the impulse on a free head and less than that on a wall.
TEST(OdeSimulator, ImpulseOnTheHeadIsBetweenThoseOnAFreeHeadAndOnAWall) {
  const motion::Motion motion = standing_still();
  const features::Ball ball =
      scenes::aimed_ball(middle_of(Body::head, motion.poses.front()), {-25, 0, 0}, 0.3);
  const auto result = simulate(motion, &ball);
  const double wall = (1 + kRestitution) * features::kVolleyballMass_kg * 25;
  EXPECT_GT(result.impulse[Body::head], 0.98 * wall * 4.4 / (4.4 + features::kVolleyballMass_kg));
  EXPECT_LT(result.impulse[Body::head], 1.01 * wall);
}

TEST(OdeSimulator, FirstContactTimeMatchesTheBallsFlight) {
  const motion::Motion motion = standing_still();
  const Eigen::Vector3d chest = middle_of(Body::chest, motion.poses.front());
  const features::Ball ball = scenes::aimed_ball(chest, {-20, 0, 0}, 0.3);
  const auto result = simulate(motion, &ball);
  // From the surface of the chest's box, along X.
  const motion::Shape box = make_body_model(character())[Body::chest].shape;
  const motion::JointFrames frames = forward_kinematics(character().skeleton, motion.poses.front());
  const double front = static_cast<double>(frames.position[motion::Role::chest].x() +
                                           box.centre.x() + box.half_extents.x());
  EXPECT_NEAR(result.first_contact_s, 0.3 - (front + ball.radius - chest.x()) / 20, 5e-4);

  // No impulse is charged before the contact.
  EXPECT_EQ(total_impulse(simulate(motion, &ball, result.first_contact_s - 0.001)), 0);
  EXPECT_GT(total_impulse(simulate(motion, &ball, result.first_contact_s + 0.003)), 0);
}

TEST(OdeSimulator, HandDrivenIntoTheFaceGivesBothAnImpulse) {
  motion::Motion motion;
  motion::Pose bowed = scenes::guarding(character().skeleton);
  scenes::turn(bowed, motion::Role::neck, Eigen::Vector3f::UnitY(), 20);
  scenes::turn(bowed, motion::Role::head, Eigen::Vector3f::UnitY(), 20);
  motion.poses.assign(61, bowed);
  const Eigen::Vector3d head = middle_of(Body::head, motion.poses.front());
  int driven = 0;
  for (Body hand : {Body::left_hand, Body::right_hand}) {
    const Eigen::Vector3d place = middle_of(hand, motion.poses.front());
    Eigen::Vector3d level = head - place;
    level.z() = 0;
    const features::Ball ball = scenes::aimed_ball(place, 25 * level.normalized(), 0.3);
    const auto result = simulate(motion, &ball);
    EXPECT_GT(result.impulse[hand], 1) << name_of(hand);
    if (result.impulse[Body::head] > 0.1) ++driven;
  }
  EXPECT_EQ(driven, 2);
}

TEST(OdeSimulator, ContactOfTheMotionItselfGivesNoImpulse) {
  motion::Pose kneeing = scenes::standing(character().skeleton);
  scenes::turn(kneeing, motion::Role::left_thigh, Eigen::Vector3f::UnitY(), -150);
  scenes::turn(kneeing, motion::Role::left_shin, Eigen::Vector3f::UnitY(), 90);
  scenes::turn(kneeing, motion::Role::abdomen, Eigen::Vector3f::UnitY(), 30);
  const motion::Motion kick =
      scenes::between(scenes::standing(character().skeleton), kneeing, 0.3F);
  constexpr double kSpeed = 20;
  constexpr double kBodySpeed = 8;  // of the knee towards the ball
  int hits = 0;
  for (int i = 0; i < 12; ++i) {
    const double time_s = 0.3 + 0.02 * i;
    const motion::Pose pose = motion::sample(kick, static_cast<float>(time_s));
    const features::Ball ball = scenes::aimed_ball(middle_of(Body::left_thigh, pose),
                                                   Eigen::Vector3d(-kSpeed, 0, -2), time_s);
    const SimulationResult result = simulate(kick, &ball);
    const double bounce = (1 + kRestitution) * features::kVolleyballMass_kg * (kSpeed + kBodySpeed);
    // The ball may hit twice, and each hit may be charged to a body and to the one behind it.
    EXPECT_LT(total_impulse(result), 4 * bounce) << "ball at " << time_s << " s";
    if (total_impulse(result) > 1) ++hits;
  }
  EXPECT_GT(hits, 6);
}

// Guards the results of the study in docs/simulation.md.
TEST(OdeSimulator, ImpulsesConvergeWhenBothStepsAreHalved) {
  const auto motions = scenes::motions_by_rule(character().skeleton);
  const auto hits = scenes::random_hits(character(), motions, 48, 7);
  SimulationOptions half;
  half.free_step_s /= 2;
  half.contact_step_s /= 2;
  const OdeSimulator shipped(character(), {});
  const OdeSimulator halved(character(), half);
  std::vector<double> changes;
  for (const scenes::Hit& hit : hits) {
    const motion::Motion& motion = motions[hit.motion].motion;
    const double coarse = total_impulse(shipped.simulate(motion, &hit.ball, 1));
    const double fine = total_impulse(halved.simulate(motion, &hit.ball, 1));
    if (fine > 0) changes.push_back(std::abs(coarse - fine) / fine);
  }
  ASSERT_GT(changes.size(), hits.size() / 2);
  std::sort(changes.begin(), changes.end());
  EXPECT_LT(changes[changes.size() / 2], 0.02);
  EXPECT_LT(changes[changes.size() * 9 / 10], 0.10);
}

TEST(OdeSimulator, FigureRecoversFromAnyHit) {
  const auto motions = scenes::motions_by_rule(character().skeleton);
  const OdeSimulator simulator(character(), {});
  for (const scenes::Hit& hit : scenes::random_hits(character(), motions, 48, 9)) {
    const auto result = simulator.simulate(motions[hit.motion].motion, &hit.ball, 1);
    EXPECT_LT(result.tracking_error_m, 0.1);
    EXPECT_EQ(result.solver_messages, 0);
    EXPECT_LT(result.steps, 300);
    for (double impulse : result.impulse) EXPECT_TRUE(impulse >= 0 && impulse < 50) << impulse;
  }
}

TEST(OdeSimulator, MirroredScenesGiveMirroredImpulses) {
  const auto motions = scenes::motions_by_rule(character().skeleton);
  for (std::size_t index : {0U, 1U, 3U, 5U}) {
    const motion::Motion& motion = motions[index].motion;
    motion::Motion mirrored = motion;
    for (motion::Pose& pose : mirrored.poses) pose = motion::mirrored(pose);
    for (features::Ball ball : many_balls(motion::sample(motion, 0.3F))) {
      const auto result = simulate(motion, &ball);
      ball.position.y() *= -1;
      ball.velocity.y() *= -1;
      const auto other = simulate(mirrored, &ball);
      for (Body body : motion::kBodies) {
        const Body twin = body_of(motion::mirrored(role_of(body)));
        EXPECT_NEAR(result.impulse[body], other.impulse[twin], 0.02 * total_impulse(result) + 1e-3)
            << motions[index].name << ", " << name_of(body);
      }
    }
  }
}

TEST(OdeSimulator, IsDeterministicWhateverItSimulatedBefore) {
  const auto motions = scenes::motions_by_rule(character().skeleton);
  const motion::Motion& motion = motions[5].motion;
  const auto balls = many_balls(motion::sample(motion, 0.3F));
  const OdeSimulator used(character(), {});
  for (const features::Ball& ball : balls) {
    const auto first = used.simulate(motion, &ball, 0.6);
    const auto other = used.simulate(motions[1].motion, &balls.front(), 0.4);
    EXPECT_GT(other.steps, 0);
    scenes::expect_same_bits(first, used.simulate(motion, &ball, 0.6));
    scenes::expect_same_bits(first, OdeSimulator(character(), {}).simulate(motion, &ball, 0.6));
  }
}

TEST(OdeSimulator, IsDeterministicOnConcurrentThreads) {
  const motion::Motion motion = scenes::motions_by_rule(character().skeleton)[5].motion;
  const auto balls = many_balls(motion::sample(motion, 0.3F));
  const auto run = [&](std::vector<SimulationResult>& results) {
    const OdeSimulator simulator(character(), {});
    for (const features::Ball& ball : balls)
      results.push_back(simulator.simulate(motion, &ball, 0.6));
  };
  scenes::expect_same_bits_on_threads(run);
}

TEST(OdeMessages, AreCountedPerThreadAndNotPrinted) {
  const OdeWorld world;
  const int before = solver_messages_on_this_thread();
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  dMessage(1, "counted %d", 1);
  std::thread([] { dMessage(1, "elsewhere"); }).join();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(solver_messages_on_this_thread() - before, 1);
}

TEST(OdeMessages, FailuresAreThrownAsErrors) {
  const OdeWorld world;
  EXPECT_THROW(dError(7, "out of %s", "order"), Error);
  EXPECT_NE(tests::error_of([] { dDebug(7, "out of %s", "order"); }).find("out of order"),
            std::string::npos);
}

}  // namespace
}  // namespace flinch::sim
