// SPDX-License-Identifier: MIT
#include "train/scenario_sampling.h"

#include <algorithm>
#include <cmath>

#include "features/random.h"
#include "motion/error.h"

namespace flinch::train {

namespace {

Eigen::Vector3f point_in_ball(double radius, features::Random& random) {
  for (;;) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double z = random.uniform(-1, 1);
    if (x * x + y * y + z * z <= 1) return (radius * Eigen::Vector3d(x, y, z)).cast<float>();
  }
}

/// A full swing of the idle clip to and fro.
double idle_period_s(const motion::Motion& idle) {
  return 2.0 * idle.duration_s();
}

}  // namespace

// Backwards from the impact the ball's height is z + v sin(e) t - g t^2 / 2, which is concave in t:
// lowest at one of its ends, so only the start can be under the ground. It is not where
// sin(e) >= (r - z + g t^2 / 2) / (v t).
double least_feasible_elevation(double speed_mps, double time_to_impact_s, double radius_m,
                                double impact_height_m) {
  const double fall = 0.5 * double{features::kGravity} * time_to_impact_s * time_to_impact_s;
  const double sine = (radius_m - impact_height_m + fall) / (speed_mps * time_to_impact_s);
  return std::asin(std::clamp(sine, -1.0, 1.0));
}

features::FeatureVector described_features(const features::Layout& layout,
                                           const DescribedThreat& threat,
                                           const TargetCentres& centres) {
  features::Scenario scenario;
  scenario.target = threat.target;
  scenario.time_to_impact_s = threat.approach.time_to_impact_s;
  scenario.threat = features::threat_from_approach(
      threat.approach, centres[static_cast<std::size_t>(threat.target)], 0);
  return features::feature_vector(layout, scenario, centres);
}

TargetCentres target_centres(const motion::Skeleton& skeleton, const motion::BodyModel& body_model,
                             const motion::Pose& pose) {
  const motion::JointFrames frames = motion::forward_kinematics(skeleton, pose);
  TargetCentres centres;
  for (std::size_t i = 0; i < centres.size(); ++i)
    centres[i] = motion::target_centre(body_model, frames, static_cast<motion::Target>(i));
  return centres;
}

TargetCentres target_centres_in_character_frame(const motion::Skeleton& skeleton,
                                                const motion::BodyModel& body_model,
                                                const motion::Pose& pose) {
  const Eigen::Vector3f ground(pose.root_position.x(), pose.root_position.y(), 0);
  const motion::Pose centred = motion::placed(pose, 0, -ground);
  return target_centres(skeleton, body_model,
                        motion::placed(centred, -motion::facing(pose), Eigen::Vector3f::Zero()));
}

features::Scenario sample_scenario(const database::Library& library,
                                   const motion::BodyModel& body_model,
                                   const ScenarioDistribution& distribution, std::uint64_t seed,
                                   std::uint64_t number) {
  constexpr int kMostDraws = 10'000;
  features::Random random(seed, features::Purpose::scenario, number);
  const motion::Motion& idle = library.clips[static_cast<std::size_t>(library.idle)].motion;

  features::Scenario scenario;
  scenario.target = static_cast<motion::Target>(random.index(motion::kTargetCount));
  scenario.state.idle_time_s = static_cast<float>(random.uniform(0, idle_period_s(idle)));
  features::Approach approach;
  approach.azimuth = static_cast<float>(random.uniform(-std::numbers::pi, std::numbers::pi));
  approach.radius = static_cast<float>(distribution.radius_m);
  approach.mass_kg = static_cast<float>(distribution.mass_kg);
  const Eigen::Vector3f offset = point_in_ball(distribution.aim_radius_m, random);

  for (int draw = 0; draw < kMostDraws; ++draw) {
    const double speed = random.uniform(distribution.least_speed_mps, distribution.most_speed_mps);
    const double time =
        random.uniform(distribution.least_time_to_impact_s, distribution.most_time_to_impact_s);
    scenario.time_to_impact_s = static_cast<float>(time);
    const motion::Pose ahead = features::idle_pose(idle, scenario.state, scenario.time_to_impact_s);
    const Eigen::Vector3f aim = target_centres(library.character.skeleton, body_model,
                                               ahead)[static_cast<std::size_t>(scenario.target)] +
                                offset;
    const double least =
        std::max(distribution.least_elevation,
                 least_feasible_elevation(speed, time, distribution.radius_m, aim.z()));
    if (least > distribution.most_elevation) continue;
    approach.speed_mps = static_cast<float>(speed);
    approach.time_to_impact_s = scenario.time_to_impact_s;
    approach.elevation = static_cast<float>(random.uniform(least, distribution.most_elevation));
    scenario.threat = features::threat_from_approach(approach, aim, scenario.state.facing);
    return scenario;
  }
  throw Error("",
              "no threat of the distribution stays above the ground; raise its speed or "
              "elevation, or shorten its time to impact");
}

}  // namespace flinch::train
