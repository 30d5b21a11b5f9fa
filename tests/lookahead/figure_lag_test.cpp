// SPDX-License-Identifier: MIT
#include "lookahead/figure_lag.h"

#include <gtest/gtest.h>

#include "sim/encounter/encounter.h"
#include "sim/simulation_options.h"
#include "tests/lookahead/trained_library.h"

namespace flinch::lookahead {
namespace {

using Eigen::Vector3d;

constexpr double kStep_s = 1.0 / 60;

/// A pose of the idle clip that is carried along, above the ground, at a constant acceleration, and
/// turned about the vertical at another.
struct CarriedPose {
  Vector3d acceleration_mps2;
  double turn_radps2 = 0;
  sim::ReferenceState pose;

  explicit CarriedPose(const Vector3d& acceleration, double turn)
      : acceleration_mps2(acceleration), turn_radps2(turn) {
    const motion::Pose& idle = tests::trained().library.prepared().idle().poses.front();
    const sim::FigureModel& figure = *tests::trained().data->figure;
    pose = sim::state_at_rest(figure.skeleton, figure.model, idle);
  }

  sim::ReferenceState at(double time_s) const {
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(turn_radps2 * time_s * time_s / 2, Vector3d::UnitZ()));
    const Vector3d spin = turn_radps2 * time_s * Vector3d::UnitZ();
    sim::ReferenceState state = pose;
    for (sim::BodyState& body : state.body) {
      const Vector3d arm = turn * body.position;
      body.position = arm + Vector3d(0, 0, 5) + time_s * time_s / 2 * acceleration_mps2;
      body.orientation = turn * body.orientation;
      body.velocity = spin.cross(arm) + time_s * acceleration_mps2;
      body.angular_velocity = spin;
    }
    return state;
  }
};

/// The figure after `steps` of following it.
motion::PerBody<sim::BodyState> followed(const CarriedPose& reference, int steps) {
  const sim::FigureModel& model = *tests::trained().data->figure;
  const sim::SimulationOptions options;
  sim::ReferenceState now = reference.at(0);
  sim::Encounter<sim::TreeScene> encounter(model, options, 0, model, now.body, nullptr,
                                           options.gravity_mps2);
  for (int step = 0; step < steps; ++step) {
    const double step_s = encounter.begin_step(now, kStep_s);
    const sim::ReferenceState target = reference.at((step + 1) * kStep_s);
    encounter.end_step(now, target, step_s);
    now = target;
  }
  return encounter.scene().bodies();
}

/// Compares lags: the largest of the simulated figure, and by how much the predicted one differs.
void expect_lag(const CarriedPose& reference, double min_lag_m, double tolerance_m,
                double tolerance_rad) {
  constexpr int kSteps = 30;  // up to 5 m/s: no clip moves the pelvis faster
  const double time_s = kSteps * kStep_s;
  const motion::PerBody<sim::BodyState> expected = followed(reference, kSteps);
  FigureLag lag(*tests::trained().data->figure);
  const motion::PerBody<sim::BodyState> found =
      lag.figure({reference.at(time_s - 2 * kStep_s).body, reference.at(time_s - kStep_s).body,
                  reference.at(time_s), reference.at(time_s + kStep_s).body},
                 kStep_s, sim::SimulationOptions{}.gravity_mps2);
  double max_lag_m = 0;
  for (const motion::Body body : motion::kBodies) {
    const Vector3d from = reference.at(time_s).body[body].position;
    max_lag_m = std::max(max_lag_m, (expected[body].position - from).norm());
    EXPECT_LT((found[body].position - expected[body].position).norm(), tolerance_m)
        << name_of(body);
    EXPECT_LT((found[body].velocity - expected[body].velocity).norm(), 0.05) << name_of(body);
    EXPECT_LT(found[body].orientation.angularDistance(expected[body].orientation), tolerance_rad)
        << name_of(body);
  }
  EXPECT_GT(max_lag_m, min_lag_m);
}

TEST(FigureLag, IsTheSagOfAFigureThatHoldsStill) {
  expect_lag(CarriedPose({0, 0, 0}, 0), 2e-3, 2e-5, 2e-4);
}

TEST(FigureLag, IsThatOfALongSimulationAtAConstantAcceleration) {
  expect_lag(CarriedPose({8, -5, 2}, 0), 4e-3, 3e-4, 1.5e-3);
}

TEST(FigureLag, IsThatOfALongSimulationOfATurn) {
  expect_lag(CarriedPose({0, 0, 0}, 3), 2e-3, 4e-4, 5e-4);
}

}  // namespace
}  // namespace flinch::lookahead
