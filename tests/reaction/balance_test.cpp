// SPDX-License-Identifier: MIT
#include "reaction/balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/sim/figure_motions.h"

namespace flinch::reaction {
namespace {

using motion::Body;

TEST(DistanceOutside, EqualsTheDistanceToTheNearestConvexCombination) {
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int inside = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<Eigen::Vector2d> points(3 + i % 6);
    for (auto& point : points) point = {uniform(generator), uniform(generator)};
    const Eigen::Vector2d from(1.5 * uniform(generator), 1.5 * uniform(generator));
    // Every point of a convex hull is inside a triangle of three of the points.
    constexpr int kGrid = 60;
    double nearest = 10;
    for (const auto& a : points) {
      for (const auto& b : points) {
        for (const auto& c : points) {
          for (int u = 0; u <= kGrid; ++u) {
            for (int v = 0; u + v <= kGrid; v += c == b ? kGrid : 1) {
              const Eigen::Vector2d at = (u * a + v * b + (kGrid - u - v) * c) / kGrid;
              nearest = std::min(nearest, (at - from).norm());
            }
          }
        }
      }
    }
    const double distance = distance_outside(points, from);
    EXPECT_NEAR(distance, nearest, 0.03);
    EXPECT_LE(distance, nearest + 1e-12);
    if (distance == 0) ++inside;
  }
  EXPECT_GT(inside, 10);
  EXPECT_LT(inside, 90);
}

TEST(DistanceOutside, WorksForALineAndAPoint) {
  const std::vector<Eigen::Vector2d> line{{0, 0}, {2, 0}, {1, 0}};
  EXPECT_DOUBLE_EQ(distance_outside(line, {1, 3}), 3);
  EXPECT_DOUBLE_EQ(distance_outside(line, {5, 4}), 5);
  EXPECT_DOUBLE_EQ(distance_outside(line, {0.5, 0}), 0);
  EXPECT_DOUBLE_EQ(distance_outside(std::span(line).first(1), {3, 4}), 5);
}

motion::PerBody<sim::BodyState> standing_that_moves(const sim::FigureModel& figure_model,
                                                    const Eigen::Vector3d& velocity) {
  auto bodies = sim::state_at_rest(figure_model.skeleton, figure_model.model,
                                   scenes::standing(figure_model.skeleton))
                    .body;
  for (sim::BodyState& body : bodies) body.velocity = velocity;
  return bodies;
}

TEST(Balance, IsLostWhenTheExtrapolatedCentreOfMassPassesTheToes) {
  const sim::FigureModel figure_model(motion::default_character());
  const auto still = standing_that_moves(figure_model, Eigen::Vector3d::Zero());
  EXPECT_EQ(out_of_balance_m(figure_model, still), 0);
  double toes = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  const auto frames =
      forward_kinematics(figure_model.skeleton, scenes::standing(figure_model.skeleton));
  centre = motion::centre_of_mass(figure_model.model, frames).cast<double>();
  toes = static_cast<double>((frames.position[motion::Role::left_toes] +
                              figure_model.skeleton.tip[motion::Role::left_toes])
                                 .x());
  for (double speed : {0.5, 1.0, 3.0}) {
    const double beyond = centre.x() + speed * std::sqrt(centre.z() / 9.81) - toes;  // Hof's XcoM
    const auto moving = standing_that_moves(figure_model, {speed, 0, 0});
    EXPECT_NEAR(out_of_balance_m(figure_model, moving), std::max(beyond, 0.0), 0.01) << speed;
  }
}

TEST(Balance, AStepRecoversFromOneMetrePerSecondButNotFromThree) {
  const sim::FigureModel figure_model(motion::default_character());
  const auto out_m = [&](double speed) {
    return out_of_balance_m(figure_model, standing_that_moves(figure_model, {0, speed, 0}));
  };
  EXPECT_FALSE(is_beyond_a_step(figure_model, out_m(0)));
  EXPECT_FALSE(is_beyond_a_step(figure_model, out_m(1)));
  EXPECT_TRUE(is_beyond_a_step(figure_model, out_m(3)));
}

}  // namespace
}  // namespace flinch::reaction
