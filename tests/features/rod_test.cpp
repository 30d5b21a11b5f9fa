// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <complex>
#include <numbers>
#include <random>

#include "features/ball.h"
#include "features/impact_prediction.h"
#include "features/known_kind.h"
#include "motion/collision_shape.h"
#include "tests/features/moving_figure.h"
#include "tests/motion/random_motion.h"
#include "tests/scenes/sample_count.h"

namespace flinch::features {
namespace {

using tests::samples;
using tests::uniform;

const tests::SwayingFigure& struck_figure() {
  static const tests::SwayingFigure figure;
  return figure;
}

/// A bat that is swung, or a stick that is thrown, at 18 m/s from 50 degrees to the left.
ThreatDescription described(bool is_swung) {
  ThreatDescription description;
  description.azimuth = motion::radians(50.0F);
  description.elevation = motion::radians(20.0F);
  description.speed_mps = 18;
  description.radius = 0.03F;
  description.mass_kg = 0.9F;
  description.falls = !is_swung;
  description.rod = RodDescription{.length_m = 0.84F, .balance = 0.6F, .strikes_at = 0.8F};
  description.rod->tilt = 0.4F;
  if (is_swung) {
    description.reach_m = 1.2F;
    description.rod->grip_share = 0.25F;
    description.rod->grip_mass_kg = 2;
  } else {
    description.rod->spin = 9;
  }
  return description;
}

TEST(Rod, ThePointThatStrikesReachesTheImpactPointWithTheDescribedVelocity) {
  const Eigen::Vector3f impact(0.3F, -0.2F, 1.5F);
  for (const bool is_swung : {false, true}) {
    const ThreatDescription description = described(is_swung);
    const Threat threat = threat_from_description(description, impact, 0.7F);
    ASSERT_TRUE(is_usable(threat));
    const StrikingPoint strikes = striking_point(threat, description.time_to_impact_s, impact);
    EXPECT_LT((strikes.position - impact).norm(), 2e-5F);
    const float yaw = 0.7F + description.azimuth;
    const Eigen::Vector3f from(std::cos(description.elevation) * std::cos(yaw),
                               std::cos(description.elevation) * std::sin(yaw),
                               std::sin(description.elevation));
    EXPECT_LT((strikes.velocity + 18 * from).norm(), 1e-3F);
    const Rod rod = *advanced(threat, description.time_to_impact_s).rod;
    EXPECT_NEAR(rod.axis.dot(from), 0, 1e-5F);
    EXPECT_NEAR(rod.to_butt_m + rod.to_tip_m + 2 * threat.radius, 0.84F, 1e-6F);
  }
}

// In the plane of its swing, a point at s of the axis is at g0 + v t + s e^{i (a + w t)}.
TEST(Rod, ASwungRodTurnsAboutAGripThatMovesStraight) {
  Threat threat;
  threat.position = {1, 2, 10};
  threat.velocity = {-3, 1, 0};
  threat.rod = Rod{.axis = {std::cos(0.3F), std::sin(0.3F), 0},
                   .angular_velocity = {0, 0, 11},
                   .to_butt_m = 0.1F,
                   .to_tip_m = 0.7F,
                   .to_mass_m = 0.4F,
                   .grip_mass_kg = 2};
  threat.stroke = Stroke{0, 0.3F};
  const Ball ball = ball_of(threat);
  for (const double time_s : {0.0, 0.07, 0.21, 0.3}) {
    const Ball then = ball.at(time_s);
    const auto at = [&](double s) {
      return std::complex<double>(1 - 3 * time_s, 2 + time_s) +
             s * std::polar(1.0, 0.3 + 11 * time_s);
    };
    for (const auto& [along, s] :
         {std::pair{-then.rod.to_butt_m, -0.1}, {then.rod.to_tip_m, 0.7}}) {
      const Eigen::Vector3d end = then.position + along * then.rod.axis;
      EXPECT_NEAR(end.x(), at(s).real(), 1e-6);
      EXPECT_NEAR(end.y(), at(s).imag(), 1e-6);
      const std::complex<double> velocity =
          std::complex<double>(-3, 1) +
          std::complex<double>(0, 11) * s * std::polar(1.0, 0.3 + 11 * time_s);
      EXPECT_NEAR(then.velocity_of(end).x(), velocity.real(), 1e-5);
      EXPECT_NEAR(then.velocity_of(end).y(), velocity.imag(), 1e-5);
    }
  }
  // Its stroke is over; the tip points to the negative x then.
  const StrikingPoint tip = striking_point(threat, 0.5F, {-100, 0, 10});
  const std::complex<double> stopped =
      std::complex<double>(1 - 3 * 0.3, 2 + 0.3) + 0.7 * std::polar(1.0, 0.3 + 11 * 0.3);
  EXPECT_NEAR(tip.position.x(), stopped.real(), 1e-5);
}

TEST(Rod, TheMiddleOfAThrownRodFliesOnAParabolaWhileItSpins) {
  Threat threat;
  threat.position = {5, 0, 3};
  threat.velocity = {-9, 0, 2};
  threat.rod = Rod{.axis = Eigen::Vector3f::UnitZ(), .angular_velocity = {0, 8, 0}};
  const Ball then = ball_of(threat).at(0.4);
  EXPECT_NEAR(then.position.x(), 5 - 9 * 0.4, 1e-6);
  EXPECT_NEAR(then.position.z(), 3 + 2 * 0.4 - 0.5 * 9.81 * 0.16, 1e-6);
  EXPECT_NEAR(then.rod.axis.z(), std::cos(3.2), 1e-6);
  EXPECT_NEAR(then.rod.axis.x(), std::sin(3.2), 1e-6);
  EXPECT_NEAR(then.velocity.z(), 2 - 9.81 * 0.4, 1e-6);
}

// A stick that falls without spin reaches the ground with its lower end.
TEST(Rod, ARodIsOverWhenItsLowestPointReachesTheGround) {
  Threat threat;
  threat.radius = 0.02F;
  threat.position = {0, 0, 2};
  threat.rod = Rod{.axis = Eigen::Vector3f(0.6F, 0, 0.8F)};
  const Ball ball = ball_of(threat);
  const double fall_m = 2 - 0.5 * 0.8 - 0.02;
  EXPECT_NEAR(ball.window.until_s, std::sqrt(2 * fall_m / 9.81), 1e-4);
  // One that spins: brute force.
  threat.rod->angular_velocity = {0, 15, 0};
  double time_s = 0;
  while (lowest_point_m(ball_of(threat).at(time_s)) > 1e-4) time_s += 1e-5;
  EXPECT_NEAR(ball_of(threat).window.until_s, time_s, 2e-5);
  EXPECT_FALSE(time_of_bounce(ball, 10, 0));
}

// 1/m + r^2 / I, with I = m L^2 / 12.
TEST(Rod, EffectiveMassesFollowFromMassAndInertia) {
  const Rod thrown{.to_butt_m = 0.4F, .to_tip_m = 0.4F};
  const RodInertia free = inertia_of(thrown, 0.05F, 1.2F);
  const double inertia = 1.2 * 0.9 * 0.9 / 12;
  EXPECT_NEAR(free.inertia_kgm2, inertia, 1e-6);
  EXPECT_NEAR(free.effective_mass_kg(0), 1.2, 1e-6);
  EXPECT_NEAR(free.effective_mass_kg(-0.3), 1 / (1 / 1.2 + 0.09 / inertia), 1e-6);
  Rod held{.to_butt_m = 0, .to_tip_m = 0.8F, .to_mass_m = 0.5F, .grip_mass_kg = 1e6F};
  const double about_grip = inertia + 1.2 * 0.25;
  EXPECT_NEAR(inertia_of(held, 0.05F, 1.2F).effective_mass_kg(0.7), about_grip / 0.49, 1e-4);
  held.grip_mass_kg = 0;
  EXPECT_NEAR(inertia_of(held, 0.05F, 1.2F).effective_mass_kg(0.5), 1.2, 1e-6);
}

/// A rod that turns and flies at the figure.
Threat random_rod(std::mt19937& random, const motion::Pose& pose) {
  const bool is_swung = random() % 2 == 0;
  ThreatDescription description = described(is_swung);
  description.azimuth = uniform(random, -3, 3);
  description.elevation = uniform(random, -0.2F, 0.8F);
  description.speed_mps = uniform(random, 6, 30);
  description.time_to_impact_s = uniform(random, 0.1F, 0.8F);
  description.rod->tilt = uniform(random, -3, 3);
  description.rod->strikes_at = uniform(random, 0.4F, 1);
  const Eigen::Vector3f aside = 0.5F * tests::random_vector(random, 1);
  return threat_from_description(description, pose.root_position + aside, 0);
}

// Every 2 ms the least gap of the rod's axis to all outlines, from 100 points of the axis.
TEST(Rod, PredictedImpactsMatchDenseSampling) {
  std::mt19937 random(8);
  constexpr double kTouch_m = 1e-3;
  int impacts = 0;
  int misses = 0;
  for (int i = 0; i < samples(120); ++i) {
    motion::Pose pose = tests::random_pose(random, 0.8F);
    pose.root_position = {0, 0, 1};
    const Threat threat = random_rod(random, pose);
    const PredictedImpact impact =
        predict_impact(threat, struck_figure().collision_figure, pose, {.horizon_s = 1.2F});
    ASSERT_NE(impact.outcome, Outcome::unusable);
    const Ball ball = ball_of(threat);
    const motion::PerBody<motion::CollisionShape> outlines = struck_figure().outlines(pose);
    const auto gap_at = [&](double time_s) {
      const Ball then = ball.at(time_s);
      double least = 1;
      for (int k = 0; k <= 100; ++k) {
        const double along =
            -then.rod.to_butt_m + k / 100.0 * (then.rod.to_butt_m + then.rod.to_tip_m);
        const Eigen::Vector3d point = then.position + along * then.rod.axis;
        for (const motion::CollisionShape& outline : outlines)
          least = std::min(least, motion::gap(point, then.radius, outline));
      }
      return least;
    };
    SCOPED_TRACE(i);
    const double until_s = std::min(ball.window.until_s, 1.2);
    if (impact.outcome == Outcome::miss) {
      ++misses;
      for (double time_s = std::max(ball.window.from_s, 0.0); time_s < until_s; time_s += 2e-3)
        ASSERT_GT(gap_at(time_s), 0) << "touches at " << time_s;
      continue;
    }
    ++impacts;
    const auto touch_s = static_cast<double>(impact.touch_s);
    EXPECT_LE(gap_at(touch_s), kTouch_m + 1e-3);  // the nearest of the points is beside the nearest
    for (double time_s = std::max(ball.window.from_s, 0.0); time_s < touch_s - 1e-3; time_s += 2e-3)
      ASSERT_GT(gap_at(time_s), 0) << "touches before, at " << time_s;
    EXPECT_GE(impact.time_to_impact_s, impact.touch_s);
    EXPECT_LE(struck_figure().gap_of(impact.body, pose, impact.point.cast<double>(), 0), 1e-5);
  }
  EXPECT_GT(impacts, samples(50));
  EXPECT_GT(misses, samples(10));
}

// What scenarios call the time to impact is that at which the rod is nearest to the target.
TEST(Rod, TheTimeToImpactIsThatOfTheNearestPassage) {
  motion::Pose pose;
  pose.root_position = {0, 0, 1};
  const motion::JointFrames frames =
      motion::forward_kinematics(*struck_figure().collision_figure.skeleton, pose);
  for (const bool is_swung : {false, true}) {
    ThreatDescription description = described(is_swung);
    description.target = motion::Target::head;
    const Eigen::Vector3f centre = motion::target_centre(*struck_figure().collision_figure.model,
                                                         frames, motion::Target::head);
    const Threat threat = threat_from_description(description, centre, 0);
    const PredictedImpact impact = predict_impact(threat, struck_figure().collision_figure, pose);
    ASSERT_EQ(impact.outcome, Outcome::impact);
    EXPECT_EQ(impact.aimed_at, motion::Target::head);
    EXPECT_NEAR(impact.time_to_impact_s, description.time_to_impact_s, 2e-4F);
  }
}

TEST(Rod, TheBallInItsPlaceStrikesWhereItDoes) {
  const Eigen::Vector3f impact(0.3F, -0.2F, 1.5F);
  const ThreatDescription description = described(true);
  const Threat bat = threat_from_description(description, impact, 0);
  const Threat ball = striking_ball(bat, description.time_to_impact_s, impact);
  EXPECT_LT((position_at(ball, description.time_to_impact_s) - impact).norm(), 2e-5F);
  EXPECT_NEAR(ball.velocity.norm(), 18, 1e-3F);
  EXPECT_LT(ball.mass_kg, bat.mass_kg);
  EXPECT_FALSE(ball.rod || ball.stroke);
}

TEST(Rod, UnsoundRodsAreRefused) {
  const Eigen::Vector3f impact(0, 0, 1.5F);
  const Threat swung = threat_from_description(described(true), impact, 0);
  const Threat thrown = threat_from_description(described(false), impact, 0);
  ASSERT_TRUE(is_usable(swung));
  ASSERT_TRUE(is_usable(thrown));
  const auto refused = [](Threat threat, auto change) {
    change(*threat.rod);
    return !is_usable(threat);
  };
  EXPECT_TRUE(refused(swung, [](Rod& rod) { rod.axis *= 1.1F; }));
  EXPECT_TRUE(refused(swung, [](Rod& rod) { rod.axis.setZero(); }));
  EXPECT_TRUE(refused(swung, [](Rod& rod) { rod.to_tip_m = 5.1F; }));
  EXPECT_TRUE(refused(swung, [](Rod& rod) { rod.to_butt_m = -0.1F; }));
  EXPECT_TRUE(refused(swung, [](Rod& rod) { rod.to_mass_m = 1; }));
  EXPECT_TRUE(refused(swung, [](Rod& rod) { rod.grip_mass_kg = -1; }));
  EXPECT_TRUE(refused(swung, [](Rod& rod) { rod.angular_velocity += rod.axis; }));
  EXPECT_TRUE(refused(thrown, [](Rod& rod) { rod.to_mass_m = 0.1F; }));
  EXPECT_TRUE(refused(thrown, [](Rod& rod) { rod.grip_mass_kg = 1; }));
  EXPECT_TRUE(refused(thrown, [](Rod& rod) { rod.to_tip_m = std::nanf(""); }));
}

TEST(Rod, TheLargestImpulseOfAKindIsThatOfItsHeaviestPlace) {
  KnownKind kind;
  kind.shape = ThreatShape::rod;
  kind.radius_m = {0.03, 0.03};
  kind.mass_kg = {0.8, 0.9};
  kind.speed_mps = {10, 30};
  kind.bounce.restitution = 0.1;
  kind.rod = {.length_m = {1.06, 1.06}, .strikes_at = {0.9, 1}, .balance = 0.5};
  ASSERT_TRUE(is_sound(kind));
  const double inertia = 0.9 * 1.06 * 1.06 / 12;
  const double mass_kg = 1 / (1 / 0.9 + 0.4 * 0.4 / inertia);
  EXPECT_NEAR(largest_impulse_ns(kind), 1.1 * mass_kg * 30, 1e-4);
  kind.rod.strikes_at = {0.3, 1};
  EXPECT_NEAR(largest_impulse_ns(kind), 1.1 * 0.9 * 30, 1e-4);
}

}  // namespace
}  // namespace flinch::features
