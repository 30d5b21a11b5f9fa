// SPDX-License-Identifier: MIT
#include "train/scenario/scenario_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "database/author/authored_library.h"
#include "features/feature_vector.h"
#include "motion/default_character.h"
#include "motion/error.h"
#include "motion/loop.h"
#include "tests/motion/random_motion.h"
#include "tests/scenes/synthetic_library.h"
#include "tests/scenes/walk.h"
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
  ThreatKind& kind_ = distribution_.kinds.front();
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
    EXPECT_LE(distance, kind_.aim_radius_m + 1e-4) << "scenario " << number;
    farthest = std::max(farthest, distance);
  }
  EXPECT_GT(farthest, 0.95 * kind_.aim_radius_m);
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
    const GridCell cell = grid_cell_of(distribution_, stance_loops(library_), scenario);
    EXPECT_EQ(cell.time, std::lround(steps));
    EXPECT_EQ(cell.state, std::lround(quarters) % 4);
    EXPECT_EQ(character_state_at(distribution_, stance_loops(library_), cell).idle_time_s,
              scenario.state.idle_time_s);
    ++per_time[static_cast<std::size_t>(cell.time)];
    ++per_state[static_cast<std::size_t>(cell.state)];
  }
  for (const int count : per_time) EXPECT_NEAR(count, kScenarios / 20, 45);
  for (const int count : per_state) EXPECT_NEAR(count, kScenarios / 4, 80);
}

class StanceSampling : public ScenarioSampling {
 protected:
  StanceSampling() {
    library_ = tests::with_walk(database::authored_library(motion::default_character()));
    model_ = motion::make_body_model(library_.character);
    loops_ = stance_loops(library_);
    distribution_.stances = {{0, "idle", 1}, {1, "guard", 1}, {2, "walk", 2}};
  }

  std::vector<motion::Loop> loops_;
};

TEST_F(StanceSampling, StancesAreDrawnByTheirWeights) {
  std::array<int, 3> per_stance{};
  for (int number = 0; number < kScenarios; ++number)
    ++per_stance[static_cast<std::size_t>(sample(static_cast<std::uint64_t>(number)).state.stance)];
  EXPECT_NEAR(per_stance[0], kScenarios / 4, 80);
  EXPECT_NEAR(per_stance[1], kScenarios / 4, 80);
  EXPECT_NEAR(per_stance[2], kScenarios / 2, 90);
}

TEST_F(StanceSampling, ACellGivesTheStateBack) {
  for (int number = 0; number < 300; ++number) {
    const features::Scenario scenario = sample(static_cast<std::uint64_t>(number));
    const GridCell cell = grid_cell_of(distribution_, loops_, scenario);
    ASSERT_LT(cell.state, state_count(distribution_));
    const features::CharacterState state = character_state_at(distribution_, loops_, cell);
    EXPECT_EQ(state.stance, scenario.state.stance);
    EXPECT_EQ(state.idle_time_s, scenario.state.idle_time_s);
    EXPECT_EQ(state.position, scenario.state.position);
    EXPECT_EQ(state.facing, scenario.state.facing);
  }
}

TEST_F(StanceSampling, AThreatLeadsACharacterThatGoesOn) {
  for (int number = 0; number < 300; ++number) {
    const features::Scenario scenario = sample(static_cast<std::uint64_t>(number));
    const motion::Loop& loop = loops_[static_cast<std::size_t>(scenario.state.stance)];
    const motion::JointFrames frames = motion::forward_kinematics(
        library_.character.skeleton,
        features::idle_pose(loop, scenario.state, scenario.time_to_impact_s));
    const Eigen::Vector3f centre = motion::target_centre(model_, frames, scenario.target);
    const Eigen::Vector3f at_impact =
        features::position_at(scenario.threat, scenario.time_to_impact_s);
    EXPECT_LE((at_impact - centre).norm(), kind_.aim_radius_m + 1e-3) << number;
  }
}

// So that responses can be shared: seen from the impact, they are the same motion.
TEST_F(StanceSampling, AWalkerIsAtTheSamePlaceAtTheImpactWhateverTheTime) {
  for (int state = 0; state < state_count(distribution_); ++state) {
    const auto at_impact = [&](int time) {
      const features::CharacterState then =
          character_state_at(distribution_, loops_, {state, time});
      return features::idle_pose(loops_[static_cast<std::size_t>(then.stance)], then,
                                 time_to_impact_s(distribution_, time));
    };
    for (const int time : {3, 11, 19})
      EXPECT_LT(tests::distance(at_impact(0), at_impact(time)), 1e-3F) << state;
  }
}

TEST_F(ScenarioSampling, TheSameNumberGivesTheSameBits) {
  const features::Scenario once = sample(17);
  const features::Scenario again = sample(17);
  EXPECT_EQ(std::memcmp(&once.threat.position, &again.threat.position, sizeof(Eigen::Vector3f)), 0);
  EXPECT_EQ(std::memcmp(&once.threat.velocity, &again.threat.velocity, sizeof(Eigen::Vector3f)), 0);
  EXPECT_EQ(once.threat.radius, again.threat.radius);
  EXPECT_EQ(once.threat.mass_kg, again.threat.mass_kg);
  EXPECT_EQ(once.time_to_impact_s, again.time_to_impact_s);
  EXPECT_NE(once.threat.velocity, sample(18).threat.velocity);
  EXPECT_NE(once.threat.velocity, sample(17, 2).threat.velocity);
}

TEST_F(ScenarioSampling, RejectsADistributionWithoutFeasibleThreats) {
  kind_.speed_mps.max = 8;
  kind_.time_to_impact_s = {3, 4};
  EXPECT_THROW(sample(0), Error);
}

TEST_F(ScenarioSampling, KindsAndTargetsComeByTheirWeightsAndNumbersFromTheirRanges) {
  kind_.weight = 3;
  ThreatKind rock;
  rock.name = "rock";
  rock.radius_m = {0.02, 0.04};
  rock.mass_kg = {0.2, 0.4};
  rock.speed_mps = {10, 12};
  rock.azimuth = {{motion::radians(-30.0), motion::radians(0.0)},
                  {motion::radians(170.0), motion::radians(190.0)}};
  rock.elevation = {motion::radians(5.0), motion::radians(15.0)};
  rock.time_to_impact_s = {0.4, 0.6};
  rock.target_weight = {1, 0, 3, 0};
  rock.aim_radius_m = 0.01;
  rock.bounce = {0.25, 0.125};
  rock.falls = false;
  distribution_.kinds.push_back(rock);
  int rocks = 0;
  int pelvises = 0;
  int ahead = 0;
  ValueRange mass{1, 0};
  ValueRange time{1, 0};
  for (int number = 0; number < kScenarios; ++number) {
    const features::Scenario scenario = sample(static_cast<std::uint64_t>(number));
    const features::Threat& threat = scenario.threat;
    if (threat.kind == 0) {
      EXPECT_EQ(threat.bounce, features::Bounce{});
      EXPECT_TRUE(threat.falls);
      continue;
    }
    ASSERT_EQ(threat.kind, 1);
    ++rocks;
    EXPECT_EQ(threat.bounce, rock.bounce);
    EXPECT_FALSE(threat.falls);
    EXPECT_GE(threat.radius, 0.02F);
    EXPECT_LE(threat.radius, 0.04F);
    EXPECT_GE(threat.velocity.norm(), 10 - 1e-4F);
    EXPECT_LE(threat.velocity.norm(), 12 + 1e-4F);
    mass = {std::min(mass.min, double{threat.mass_kg}), std::max(mass.max, double{threat.mass_kg})};
    const auto time_s = double{scenario.time_to_impact_s};
    time = {std::min(time.min, time_s), std::max(time.max, time_s)};
    const Eigen::Vector3d from = -threat.velocity.cast<double>().normalized();
    EXPECT_GE(motion::degrees(std::asin(from.z())), 5 - 1e-3);
    EXPECT_LE(motion::degrees(std::asin(from.z())), 15 + 1e-3);
    const double azimuth = motion::degrees(std::atan2(from.y(), from.x()));
    const bool is_ahead = azimuth > -30.001 && azimuth < 0.001;
    EXPECT_TRUE(is_ahead || std::abs(azimuth) > 169.999) << azimuth;
    ahead += is_ahead;
    const motion::PerTarget<Eigen::Vector3f> centres =
        target_centres(library_.character.skeleton, model_,
                       features::idle_pose(idle(), scenario.state, scenario.time_to_impact_s));
    const Eigen::Vector3f there = threat.position + scenario.time_to_impact_s * threat.velocity;
    EXPECT_LT((there - centres[scenario.target]).norm(), 0.01F + 1e-4F);
    const bool is_pelvis = scenario.target == motion::Target::pelvis;
    EXPECT_TRUE(is_pelvis || scenario.target == motion::Target::head);
    pelvises += is_pelvis;
    const GridCell cell = grid_cell_of(distribution_, stance_loops(library_), scenario);
    EXPECT_EQ(time_to_impact_s(distribution_, cell.time), scenario.time_to_impact_s);
  }
  // Within four standard deviations of a binomial distribution.
  EXPECT_NEAR(rocks, kScenarios / 4, 4 * std::sqrt(kScenarios * 0.25 * 0.75));
  EXPECT_NEAR(pelvises, 0.75 * rocks, 4 * std::sqrt(rocks * 0.75 * 0.25));
  EXPECT_NEAR(ahead, 0.6 * rocks, 4 * std::sqrt(rocks * 0.6 * 0.4));
  EXPECT_LT(mass.min, 0.21);
  EXPECT_GT(mass.max, 0.39);
  EXPECT_NEAR(time.min, 0.4, 1e-6);
  EXPECT_NEAR(time.max, 0.6, 1e-6);
}

// (1 + 0.5) 2 kg 9 m/s and (1 + 0.7) 0.27 kg 30 m/s.
TEST_F(ScenarioSampling, TheLargestImpulseIsThatOfTheKindThatCanGiveMost) {
  EXPECT_DOUBLE_EQ(largest_impulse_ns(distribution_), 13.77);
  ThreatKind heavy;
  heavy.mass_kg = {1, 2};
  heavy.speed_mps = {5, 9};
  heavy.bounce.restitution = 0.5;
  distribution_.kinds.push_back(heavy);
  EXPECT_DOUBLE_EQ(largest_impulse_ns(distribution_), 27);
}

TEST(MinFeasibleElevation, OfAStraightFlightIsThatOfALine) {
  // From 0.2 m above the ground to 1.1 m, 10 m along the line.
  EXPECT_NEAR(std::sin(min_feasible_elevation(20, 0.5, 0.2, 1.1, false)), -0.09, 1e-12);
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
