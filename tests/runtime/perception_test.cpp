// SPDX-License-Identifier: MIT
#include "runtime/perception.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "features/impact_prediction.h"
#include "motion/default_character.h"
#include "tests/scenes/allocation_count.h"
#include "tests/scenes/not_finite.h"

namespace flinch::runtime {
namespace {

using features::Threat;
using tests::kInfinity;
using tests::kNan;

constexpr int kDraws = 100'000;
const Eigen::Vector3f kEye(0.123F, -1.77F, 1.671F);

Threat thrown() {
  Threat threat;
  threat.position = {9, 8, 3};
  threat.velocity = {-14, -11, 2};
  threat.radius = 0.1F;
  threat.mass_kg = 0.3F;
  return threat;
}

bool same_bits(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  for (int i = 0; i < 3; ++i) {
    if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i])) return false;
  }
  return true;
}

bool same_bits(const Threat& a, const Threat& b) {
  return same_bits(a.position, b.position) && same_bits(a.velocity, b.velocity);
}

/// Mean and standard deviation of the values added.
class Sample {
 public:
  void add(double value) {
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }
  double mean() const { return sum_ / count_; }
  double deviation() const { return std::sqrt(squares_ / count_ - mean() * mean()); }

 private:
  double count_ = 0;
  double sum_ = 0;
  double squares_ = 0;
};

/// Expects the mean within 5 standard errors and the deviation within 1.5 % (5 standard errors are
/// 1.1 %).
void expect_normal(const Sample& sample, double deviation) {
  EXPECT_NEAR(sample.mean(), 0, 5 * deviation / std::sqrt(kDraws));
  EXPECT_NEAR(sample.deviation(), deviation, 0.015 * deviation);
}

/// Samples of the angles by which a vector is turned, up and sideways as seen along it, and of the
/// logarithm of its length's factor.
struct Errors {
  Sample up;
  Sample aside;
  Sample log_length;

  void add(const Eigen::Vector3f& truth, const Eigen::Vector3f& seen) {
    const Eigen::Vector3d along = truth.cast<double>().normalized();
    const Eigen::Vector3d side = along.cross(Eigen::Vector3d::UnitZ()).normalized();
    const Eigen::Vector3d direction = seen.cast<double>().normalized();
    // Both angles are tiny, so each is its component of the arc.
    const double angle = std::acos(std::min(direction.dot(along), 1.0));
    const Eigen::Vector3d across = (direction - direction.dot(along) * along).normalized();
    up.add(angle > 0 ? angle * across.dot(side.cross(along)) : 0);
    aside.add(angle > 0 ? angle * across.dot(side) : 0);
    log_length.add(std::log(static_cast<double>(seen.norm() / truth.norm())));
  }
};

TEST(Perception, NoiseMatchesTheMeanAndDeviationOfTheLimits) {
  const PerceptionLimits limits{
      .bearing_noise = 0.02F, .distance_noise = 0.1F, .heading_noise = 0.05F, .speed_noise = 0.2F};
  Errors position;
  Errors velocity;
  Sample log_time;
  for (std::uint64_t number = 0; number < kDraws; ++number) {
    const Perceived perceived = perceive(thrown(), kEye, limits, 3, number);
    position.add(thrown().position - kEye, perceived.threat.position - kEye);
    velocity.add(thrown().velocity, perceived.threat.velocity);
    log_time.add(std::log(static_cast<double>(
        (perceived.threat.position - kEye).norm() * thrown().velocity.norm() /
        ((thrown().position - kEye).norm() * perceived.threat.velocity.norm()))));
  }
  expect_normal(position.up, 0.02);
  expect_normal(position.aside, 0.02);
  expect_normal(position.log_length, 0.1);
  expect_normal(velocity.up, 0.05);
  expect_normal(velocity.aside, 0.05);
  expect_normal(velocity.log_length, std::hypot(0.1, 0.2));
  expect_normal(log_time, 0.2);  // an error of the distance does not change it
}

TEST(Perception, FailureRateMatchesTheLimits) {
  for (float chance : {0.0F, 0.03F, 0.4F, 1.0F}) {
    const PerceptionLimits limits{.chance_to_fail = chance};
    int failed = 0;
    for (std::uint64_t number = 0; number < kDraws; ++number) {
      if (!perceive(thrown(), kEye, limits, 5, number).noticed) ++failed;
    }
    const double p = static_cast<double>(chance);
    EXPECT_NEAR(failed, kDraws * p, 5 * std::sqrt(kDraws * p * (1 - p)));
  }
}

TEST(Perception, WithoutLimitsChangesNothing) {
  for (std::uint64_t number = 0; number < 1000; ++number) {
    Threat threat = thrown();
    threat.position.x() += 0.37F * static_cast<float>(number);
    const Perceived perceived = perceive(threat, kEye, {}, 7, number);
    EXPECT_TRUE(perceived.noticed);
    EXPECT_EQ(perceived.delay_s, 0);
    EXPECT_TRUE(same_bits(perceived.threat, threat));
  }
}

TEST(Perception, IsDeterministicPerSeedAndNumber) {
  const PerceptionLimits limits = human_limits();
  const Perceived once = perceive(thrown(), kEye, limits, 11, 4);
  EXPECT_TRUE(same_bits(once.threat, perceive(thrown(), kEye, limits, 11, 4).threat));
  EXPECT_FALSE(same_bits(once.threat, perceive(thrown(), kEye, limits, 11, 5).threat));
  EXPECT_FALSE(same_bits(once.threat, perceive(thrown(), kEye, limits, 12, 4).threat));
  EXPECT_EQ(once.threat.radius, thrown().radius);
  EXPECT_EQ(once.threat.mass_kg, thrown().mass_kg);
}

TEST(Perception, LimitsDrawIndependently) {
  PerceptionLimits heading{.heading_noise = 0.1F};
  const Threat one = perceive(thrown(), kEye, heading, 1, 2).threat;
  EXPECT_TRUE(same_bits(one.position, thrown().position));
  for (std::uint64_t number = 0; number < 100; ++number) {
    Threat threat = thrown();
    threat.position *= 1 + 0.0137F * static_cast<float>(number);
    EXPECT_TRUE(
        same_bits(perceive(threat, kEye, heading, 1, number).threat.position, threat.position));
  }
  heading.bearing_noise = 0.2F;
  heading.chance_to_fail = 0.5F;
  const Threat both = perceive(thrown(), kEye, heading, 1, 2).threat;
  EXPECT_TRUE(same_bits(one.velocity, both.velocity));
  EXPECT_FALSE(same_bits(one.position, both.position));
}

TEST(Perception, HumansTakeLongerOverMoreChoices) {
  EXPECT_TRUE(is_valid(human_limits()));
  EXPECT_FLOAT_EQ(human_limits().reaction_delay_s, 0.22F);
  EXPECT_FLOAT_EQ(human_limits(0).reaction_delay_s, 0.22F);
  EXPECT_NEAR(human_limits(2).reaction_delay_s, 0.37F, 1e-6F);
  EXPECT_NEAR(human_limits(8).reaction_delay_s, 0.67F, 1e-6F);
  EXPECT_EQ(perceive(thrown(), kEye, human_limits(2), 1, 1).delay_s,
            human_limits(2).reaction_delay_s);
}

TEST(Perception, IgnoresInvalidLimits) {
  for (float PerceptionLimits::*member :
       {&PerceptionLimits::reaction_delay_s, &PerceptionLimits::bearing_noise,
        &PerceptionLimits::distance_noise, &PerceptionLimits::heading_noise,
        &PerceptionLimits::speed_noise, &PerceptionLimits::chance_to_fail}) {
    for (float bad : {kNan, kInfinity, -0.1F}) {
      PerceptionLimits limits = human_limits();
      limits.*member = bad;
      EXPECT_FALSE(is_valid(limits));
      const Perceived perceived = perceive(thrown(), kEye, limits, 1, 1);
      EXPECT_TRUE(perceived.noticed);
      EXPECT_EQ(perceived.delay_s, 0);
      EXPECT_TRUE(same_bits(perceived.threat, thrown()));
    }
  }
  PerceptionLimits limits;
  limits.chance_to_fail = 1.1F;
  EXPECT_FALSE(is_valid(limits));
  EXPECT_TRUE(is_valid(PerceptionLimits{}));
}

TEST(Perception, WhatNoiseOfAnySizeMakesOfAThreatIsUsableIfNoticed) {
  int noticed = 0;
  int unnoticed = 0;
  for (float noise : {0.1F, 10.0F, 1e6F, 3e38F}) {
    const PerceptionLimits limits{.bearing_noise = noise,
                                  .distance_noise = noise,
                                  .heading_noise = noise,
                                  .speed_noise = noise};
    for (std::uint64_t number = 0; number < 200; ++number) {
      const Perceived perceived = perceive(thrown(), kEye, limits, 2, number);
      (perceived.noticed ? noticed : unnoticed) += 1;
      EXPECT_TRUE(!perceived.noticed || features::is_usable(perceived.threat)) << noise;
    }
  }
  EXPECT_GT(noticed, 200);
  EXPECT_GT(unnoticed, 200);
}

TEST(Perception, PassesNonFiniteThreatsThrough) {
  for (int i = 0; i < 3; ++i) {
    Threat threat = thrown();
    threat.velocity[i] = kNan;
    EXPECT_TRUE(same_bits(perceive(threat, kEye, human_limits(), 1, 1).threat, threat));
    threat = thrown();
    threat.position[i] = kNan;
    EXPECT_TRUE(same_bits(perceive(threat, kEye, human_limits(), 1, 1).threat, threat));
    Eigen::Vector3f eye = kEye;
    eye[i] = kNan;
    EXPECT_TRUE(same_bits(perceive(thrown(), eye, human_limits(), 1, 1).threat, thrown()));
  }
}

TEST(Perception, IsFiniteForAThreatAtRestOrAtTheEye) {
  Threat threat;
  threat.position = kEye;
  for (std::uint64_t number = 0; number < 100; ++number) {
    const Threat perceived = perceive(threat, kEye, human_limits(), 1, number).threat;
    EXPECT_TRUE(same_bits(perceived, threat));
  }
}

TEST(Perception, AllocatesNothingWithThePrediction) {
  const motion::Physique character = motion::default_character();
  const motion::BodyModel model = make_body_model(character);
  motion::Motion idle;
  for (int i = 0; i < 10; ++i) idle.poses.push_back(rest_pose(character.skeleton));
  const std::size_t before = tests::allocation_count();
  const features::CollisionFigure figure =
      features::make_collision_figure(character.skeleton, model);
  const features::MotionBounds motion_bounds =
      features::motion_bounds_of(character.skeleton, model, idle);
  int impacts = 0;
  for (std::uint64_t number = 0; number < 50; ++number) {
    Threat threat;
    threat.position = {8, 0, 1.3F};
    threat.velocity = {-20, 0, 1.5F};
    const Perceived perceived = perceive(threat, {0, 0, 1.7F}, human_limits(), 1, number);
    for (const features::PredictedImpact& impact :
         {features::predict_impact(perceived.threat, figure, idle, motion_bounds, {}),
          features::predict_impact(perceived.threat, figure, idle.poses.front())}) {
      if (impact.outcome == features::Outcome::impact) ++impacts;
    }
  }
  EXPECT_EQ(tests::allocation_count(), before);
  EXPECT_GT(impacts, 50);
}

}  // namespace
}  // namespace flinch::runtime
