// SPDX-License-Identifier: MIT
#include "sim/work.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/default_character.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kPi = std::numbers::pi;

motion::Motion moved_rest_pose(const motion::Physique& character, float rate_hz, int poses,
                               double (*offset_at)(double time_s)) {
  motion::Motion motion;
  motion.rate_hz = rate_hz;
  for (int k = 0; k < poses; ++k) {
    motion.poses.push_back(rest_pose(character.skeleton));
    motion.poses.back().root_position.x() =
        static_cast<float>(offset_at(k / static_cast<double>(rate_hz)));
  }
  return motion;
}

// x = A sin(2 pi f t) along a line: W = m int |a v| dt = m A^2 w^2 per half period, 2 m A^2 w^2 per
// period. At 1 Hz the effect of the low-pass is negligible.
TEST(MechanicalWork, OfASinusoidMatchesTheClosedForm) {
  const motion::Physique character = motion::default_character();
  const auto motion = moved_rest_pose(character, 240, 240 * 3 + 1,
                                      [](double t) { return 0.2 * std::sin(2 * kPi * t); });
  const double omega = 2 * kPi;
  const double per_kg = 3 * 2 * 0.2 * 0.2 * omega * omega;
  const motion::BodyModel model = make_body_model(character);
  const auto work = mechanical_work(character, motion);
  for (Body body : motion::kBodies) {
    const double expected = static_cast<double>(model[body].mass_kg) * per_kg;
    EXPECT_NEAR(work[body], expected, 0.01 * expected) << name_of(body);
  }
}

TEST(MechanicalWork, OfConstantVelocityIsZero) {
  const motion::Physique character = motion::default_character();
  const auto moving = moved_rest_pose(character, 60, 120, [](double t) { return 2 * t; });
  EXPECT_LT(sum(mechanical_work(character, moving)), 0.05);  // J; float positions' noise
}

TEST(MechanicalWork, OfStandingStillIsZero) {
  const motion::Physique character = motion::default_character();
  const auto still = moved_rest_pose(character, 60, 120, [](double) { return 0.0; });
  EXPECT_LT(sum(mechanical_work(character, still)), 1e-12);
}

TEST(MechanicalWork, OfTooFewPosesIsZero) {
  const motion::Physique character = motion::default_character();
  const auto motion = moved_rest_pose(character, 60, 3, [](double t) { return t * t; });
  EXPECT_EQ(sum(mechanical_work(character, motion)), 0);
}

// Both speeding up and slowing down cost work: from rest to rest the signed sum is zero.
TEST(MechanicalWork, FromRestToRestIsTwiceTheKineticEnergy) {
  const motion::Physique character = motion::default_character();
  const auto motion = moved_rest_pose(character, 240, 481, [](double t) {
    return 0.5 * (1 - std::cos(kPi * std::fmin(std::fmax(t - 0.5, 0.0), 1.0)));
  });
  const double peak_speed = 0.5 * kPi;
  const double expected = static_cast<double>(character.mass_kg) * peak_speed * peak_speed;
  EXPECT_NEAR(sum(mechanical_work(character, motion)), expected, 0.03 * expected);
}

double amplitude_after(double frequency_hz, double rate_hz) {
  std::vector<Eigen::Vector3d> path;
  for (int k = 0; k < 4000; ++k) {
    path.push_back(std::sin(2 * kPi * frequency_hz * k / rate_hz) * Eigen::Vector3d::UnitX());
  }
  const auto smooth = low_pass_filtered(path, rate_hz);
  double squares = 0;
  for (std::size_t k = 800; k < 3200; ++k) squares += smooth[k].squaredNorm();
  return std::sqrt(2 * squares / 2400);
}

TEST(LowPass, HalvesTheAmplitudeAtTheCutoff) {
  EXPECT_NEAR(20 * std::log10(amplitude_after(12, 120)), -6.02, 0.05);
  EXPECT_NEAR(20 * std::log10(amplitude_after(12, 60)), -6.02, 0.05);
}

// |H|^2 of two passes is 1 / (1 + (tan(pi f/fs) / tan(pi fc/fs))^4).
TEST(LowPass, GainMatchesButterworth) {
  for (double frequency_hz : {2.0, 6.0, 20.0, 40.0}) {
    const double ratio = std::tan(kPi * frequency_hz / 120) / std::tan(kPi * 12 / 120);
    EXPECT_NEAR(amplitude_after(frequency_hz, 120), 1 / (1 + std::pow(ratio, 4)), 1e-3)
        << frequency_hz;
  }
}

TEST(LowPass, KeepsConstantsAndStraightLines) {
  std::vector<Eigen::Vector3d> path;
  for (int k = 0; k < 40; ++k) path.emplace_back(3, 0.01 * k, -1 - 0.2 * k);
  const auto smooth = low_pass_filtered(path, 60);
  ASSERT_EQ(smooth.size(), path.size());
  for (std::size_t k = 0; k < path.size(); ++k) {
    EXPECT_LT((smooth[k] - path[k]).norm(), 2e-3) << k;
  }
}

TEST(LowPass, HasNoPhaseShift) {
  std::vector<Eigen::Vector3d> path(201, Eigen::Vector3d::Zero());
  path[100].x() = 1;
  const auto smooth = low_pass_filtered(path, 60);
  for (std::size_t k = 1; k < 60; ++k) {
    EXPECT_NEAR(smooth[100 + k].x(), smooth[100 - k].x(), 1e-9) << k;
  }
}

}  // namespace
}  // namespace flinch::sim
