// SPDX-License-Identifier: MIT
#include "train/scenario/scenario_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "features/feature_vector.h"
#include "motion/error.h"
#include "tests/scenes/synthetic_library.h"
#include "train/objective/observation.h"

namespace flinch::train {
namespace {

constexpr int kScenarios = 2000;

class ScenarioSampling : public testing::Test {
 protected:
  features::Scenario sample(std::uint64_t number, std::uint64_t seed = 1) const {
    return sample_scenario(library_, model_, distribution_, seed, number);
  }
  const motion::Motion& idle() const { return library_.clips[0].motion; }

  database::ClipLibrary library_ = scenes::synthetic_library();
  motion::BodyModel model_ = motion::make_body_model(library_.character);
  ScenarioDistribution distribution_;
};

TEST_F(ScenarioSampling, ThreatsPassNearTheTargetsCentreAtTheTimeOfImpact) {
  double farthest = 0;
  for (int number = 0; number < kScenarios; ++number) {
    const features::Scenario scenario = sample(static_cast<std::uint64_t>(number));
    // Free fall, p + v t - g t^2 / 2.
    const double t = double{scenario.time_to_impact_s};
    Eigen::Vector3d at_impact =
        scenario.threat.position.cast<double>() + t * scenario.threat.velocity.cast<double>();
    at_impact.z() -= 0.5 * 9.81 * t * t;
    const motion::JointFrames frames = motion::forward_kinematics(
        library_.character.skeleton,
        features::idle_pose(idle(), scenario.state, scenario.time_to_impact_s));
    const Eigen::Vector3d centre =
        motion::target_centre(model_, frames, scenario.target).cast<double>();
    const double distance = (at_impact - centre).norm();
    EXPECT_LE(distance, distribution_.aim_radius_m + 1e-4) << "scenario " << number;
    farthest = std::max(farthest, distance);
  }
  EXPECT_GT(farthest, 0.95 * distribution_.aim_radius_m);
}

TEST_F(ScenarioSampling, ThreatsAreWithinTheDistributionAndAboveTheGround) {
  motion::PerTarget<int> per_target{};
  std::array<int, 8> per_sector{};
  for (int number = 0; number < kScenarios; ++number) {
    const features::Scenario scenario = sample(static_cast<std::uint64_t>(number));
    const float t = scenario.time_to_impact_s;
    EXPECT_GE(t, 0.25F);
    EXPECT_LE(t, 1.2F);
    const Eigen::Vector3f impact_velocity = features::velocity_at(scenario.threat, t);
    EXPECT_GE(impact_velocity.norm(), 8 - 1e-3F);
    EXPECT_LE(impact_velocity.norm(), 30 + 1e-3F);
    const double elevation = std::asin(double{-impact_velocity.z() / impact_velocity.norm()});
    EXPECT_GE(motion::degrees(elevation), -10.01);
    EXPECT_LE(motion::degrees(elevation), 45.01);
    for (const float share : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
      EXPECT_GE(features::position_at(scenario.threat, share * t).z(),
                scenario.threat.radius - 1e-3F);
    }
    ++per_target[scenario.target];
    const double azimuth =
        std::atan2(-double{impact_velocity.y()}, -double{impact_velocity.x()}) + M_PI;
    ++per_sector[std::min<std::size_t>(7, static_cast<std::size_t>(azimuth / (M_PI / 4)))];
  }
  for (const int count : per_target) EXPECT_NEAR(count, kScenarios / 4, 80);
  for (const int count : per_sector) EXPECT_NEAR(count, kScenarios / 8, 65);
}

TEST_F(ScenarioSampling, TimesAndIdlePhasesAreOnTheirGrid) {
  std::array<int, 20> per_time{};
  std::array<int, 4> per_state{};
  ASSERT_EQ(time_to_impact_count(distribution_), 20);
  const float period_s = 2 * idle().duration_s();
  for (int number = 0; number < kScenarios; ++number) {
    const features::Scenario scenario = sample(static_cast<std::uint64_t>(number));
    const float steps = (scenario.time_to_impact_s - 0.25F) / 0.05F;
    EXPECT_NEAR(steps, std::round(steps), 1e-4F);
    // Phase of the idle clip at the impact, in quarters of its period.
    const float quarters = 4 * (scenario.state.idle_time_s + scenario.time_to_impact_s) / period_s;
    EXPECT_NEAR(quarters, std::round(quarters), 1e-4F);
    EXPECT_GE(scenario.state.idle_time_s, 0);
    EXPECT_LE(scenario.state.idle_time_s, period_s);
    const GridCell cell = grid_cell_of(distribution_, idle(), scenario);
    EXPECT_EQ(cell.time, std::lround(steps));
    EXPECT_EQ(cell.idle_phase, std::lround(quarters) % 4);
    EXPECT_EQ(character_state_at(distribution_, idle(), cell).idle_time_s,
              scenario.state.idle_time_s);
    ++per_time[static_cast<std::size_t>(cell.time)];
    ++per_state[static_cast<std::size_t>(cell.idle_phase)];
  }
  for (const int count : per_time) EXPECT_NEAR(count, kScenarios / 20, 45);
  for (const int count : per_state) EXPECT_NEAR(count, kScenarios / 4, 80);
}

TEST_F(ScenarioSampling, TheSameNumberGivesTheSameBits) {
  const features::Scenario once = sample(17);
  const features::Scenario again = sample(17);
  EXPECT_EQ(std::memcmp(&once.threat, &again.threat, sizeof once.threat), 0);
  EXPECT_EQ(once.time_to_impact_s, again.time_to_impact_s);
  EXPECT_NE(once.threat.velocity, sample(18).threat.velocity);
  EXPECT_NE(once.threat.velocity, sample(17, 2).threat.velocity);
}

TEST_F(ScenarioSampling, RejectsADistributionWithoutFeasibleThreats) {
  distribution_.max_speed_mps = 8;
  distribution_.min_time_to_impact_s = 3;
  distribution_.max_time_to_impact_s = 4;
  EXPECT_THROW(sample(0), Error);
}

TEST(MinFeasibleElevation, PutsTheStartOnTheGround) {
  const double elevation = min_feasible_elevation(12, 0.9, 0.105, 1.1);
  // Height at the start, from the closed form.
  const double start = 1.1 + 12 * std::sin(elevation) * 0.9 - 0.5 * 9.81 * 0.9 * 0.9;
  EXPECT_NEAR(start, 0.105, 1e-6);
  EXPECT_DOUBLE_EQ(min_feasible_elevation(1, 5, 0.105, 1.1), M_PI / 2);
}

TEST_F(ScenarioSampling, ADescribedThreatHasTheFeaturesOfACharacterStandingStill) {
  motion::PerTarget<Eigen::Vector3f> centres{};
  centres[motion::Target::head] = {0.1F, 0, 1.6F};
  features::ThreatDescription threat;
  threat.azimuth = static_cast<float>(M_PI) / 2;
  threat.speed_mps = 20;
  threat.time_to_impact_s = 0.5F;
  const features::FeatureVector x =
      described_features(features::feature_set_named("paper")->layout, threat, centres);
  EXPECT_NEAR(x[0], 0.1F, 1e-4F);       // from the left: no motion along X
  EXPECT_NEAR(x[1], 20 * 0.5F, 1e-4F);  // starts 10 m to the left
  EXPECT_EQ(x[7], 0.5F);
  EXPECT_EQ(x[8], 1.0F);
  EXPECT_EQ(x[12], 0.0F);  // look-ahead: the character stays, facing the front
  EXPECT_EQ(x[15], 1.0F);
}

TEST_F(ScenarioSampling, TargetCentresInTheCharactersFrameDoNotDependOnItsPlace) {
  const motion::Skeleton& skeleton = library_.character.skeleton;
  const motion::Pose pose = idle().poses.front();
  const motion::PerTarget<Eigen::Vector3f> here =
      target_centres_in_character_frame(skeleton, model_, pose);
  const motion::PerTarget<Eigen::Vector3f> there =
      target_centres_in_character_frame(skeleton, model_, motion::placed(pose, 1.2F, {3, -2, 0}));
  for (const motion::Target target : motion::kTargets)
    EXPECT_LT((here[target] - there[target]).norm(), 1e-5F) << name_of(target);
  EXPECT_GT(here[motion::Target::head].z(), here[motion::Target::trunk].z());
  EXPECT_GT(here[motion::Target::pelvis].z(), here[motion::Target::legs].z());
}

}  // namespace
}  // namespace flinch::train
