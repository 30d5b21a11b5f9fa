// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "features/impact_prediction.h"
#include "tests/scenes/synthetic_library.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch::train {
namespace {

// The features that a game computes from position and velocity alone are those that selectors are
// trained on.
TEST(PredictImpact, FindsTheTargetAndTimeOfScenarios) {
  constexpr int kScenarios = 3000;
  const database::ClipLibrary library = scenes::synthetic_library();
  const motion::BodyModel model = make_body_model(library.character);
  const motion::Skeleton& skeleton = library.character.skeleton;
  const motion::Motion& idle = library.idle_clip().motion;
  const features::CollisionFigure figure = features::make_collision_figure(skeleton, model);
  const features::MotionBounds motion_bounds = features::motion_bounds_of(skeleton, model, idle);
  int impacts = 0;
  int aimed = 0;
  for (int i = 0; i < kScenarios; ++i) {
    const features::Scenario scenario =
        sample_scenario(library, model, {}, 1, static_cast<std::uint64_t>(i));
    const features::PredictedImpact impact =
        features::predict_impact(scenario.threat, figure, idle, motion_bounds, scenario.state);
    if (impact.outcome != features::Outcome::impact) continue;
    ++impacts;
    EXPECT_LT(impact.touch_s, scenario.time_to_impact_s);
    if (impact.aimed_at != scenario.target) continue;
    ++aimed;
    // The aim is up to 0.1 m off the centre, and the speed at least 8 m/s.
    EXPECT_NEAR(impact.time_to_impact_s, scenario.time_to_impact_s, 0.1 / 8 + 1e-3);
  }
  EXPECT_GT(impacts, 0.98 * kScenarios);
  EXPECT_GT(aimed, 0.995 * impacts);
}

}  // namespace
}  // namespace flinch::train
