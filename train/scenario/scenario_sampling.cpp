// SPDX-License-Identifier: MIT
#include "train/scenario/scenario_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// Period of the idle clip, forwards and backwards.
double idle_period_s(const motion::Motion& idle) {
  return 2.0 * idle.duration_s();
}

/// Returns the time in the first period with the same phase.
double in_first_period(double time_s, double period_s) {
  return period_s > 0 ? time_s - period_s * std::floor(time_s / period_s) : 0;
}

}  // namespace

int time_to_impact_count(const ScenarioDistribution& distribution) {
  const double range_s = distribution.max_time_to_impact_s - distribution.min_time_to_impact_s;
  // The range is a whole number of steps, except for rounding.
  return 1 + static_cast<int>(std::floor(range_s / distribution.time_to_impact_step_s + 1e-6));
}

float time_to_impact_s(const ScenarioDistribution& distribution, int time) {
  return static_cast<float>(distribution.min_time_to_impact_s +
                            time * distribution.time_to_impact_step_s);
}

features::CharacterState character_state_at(const ScenarioDistribution& distribution,
                                            const motion::Motion& idle, GridCell cell) {
  const double period_s = idle_period_s(idle);
  const double at_impact_s = cell.idle_phase * period_s / distribution.idle_phase_count;
  const double time_s = double{time_to_impact_s(distribution, cell.time)};
  features::CharacterState state;
  state.idle_time_s = static_cast<float>(in_first_period(at_impact_s - time_s, period_s));
  return state;
}

GridCell grid_cell_of(const ScenarioDistribution& distribution, const motion::Motion& idle,
                      const features::Scenario& scenario) {
  const double time_s = double{scenario.time_to_impact_s};
  const double period_s = idle_period_s(idle);
  GridCell cell;
  cell.time = static_cast<int>(std::lround((time_s - distribution.min_time_to_impact_s) /
                                           distribution.time_to_impact_step_s));
  if (period_s > 0) {
    const double at_impact_s = double{scenario.state.idle_time_s} + time_s;
    cell.idle_phase =
        static_cast<int>(std::lround(at_impact_s / period_s * distribution.idle_phase_count)) %
        distribution.idle_phase_count;
  }
  return cell;
}

// Backwards from the impact, the ball's height is z + v sin(e) t - g t^2 / 2. It is concave in t
// and so lowest at one of its ends: only the start can be below the ground, and it is not if sin(e)
// >= (r - z + g t^2 / 2) / (v t).
double min_feasible_elevation(double speed_mps, double time_to_impact_s, double radius_m,
                              double impact_height_m) {
  const double fall = 0.5 * double{features::kGravity} * time_to_impact_s * time_to_impact_s;
  const double sine = (radius_m - impact_height_m + fall) / (speed_mps * time_to_impact_s);
  return std::asin(std::clamp(sine, -1.0, 1.0));
}

features::FeatureVector described_features(const features::Layout& layout,
                                           const features::ThreatDescription& description,
                                           const motion::PerTarget<Eigen::Vector3f>& centres) {
  features::Scenario scenario;
  scenario.target = description.target;
  scenario.time_to_impact_s = description.time_to_impact_s;
  scenario.threat = features::threat_from_description(description, centres[description.target], 0);
  return features::feature_vector(layout, scenario, centres);
}

motion::PerTarget<Eigen::Vector3f> target_centres(const motion::Skeleton& skeleton,
                                                  const motion::BodyModel& body_model,
                                                  const motion::Pose& pose) {
  const motion::JointFrames frames = motion::forward_kinematics(skeleton, pose);
  motion::PerTarget<Eigen::Vector3f> centres;
  for (const motion::Target target : motion::kTargets)
    centres[target] = motion::target_centre(body_model, frames, target);
  return centres;
}

motion::PerTarget<Eigen::Vector3f> target_centres_in_character_frame(
    const motion::Skeleton& skeleton, const motion::BodyModel& body_model,
    const motion::Pose& pose) {
  const Eigen::Vector3f ground(pose.root_position.x(), pose.root_position.y(), 0);
  const motion::Pose centred = motion::placed(pose, 0, -ground);
  return target_centres(skeleton, body_model,
                        motion::placed(centred, -motion::facing(pose), Eigen::Vector3f::Zero()));
}

features::Scenario sample_scenario(const database::ClipLibrary& library,
                                   const motion::BodyModel& body_model,
                                   const ScenarioDistribution& distribution, std::uint64_t seed,
                                   std::uint64_t number) {
  constexpr int kMaxDraws = 10'000;
  features::Random random(seed, features::RandomStream::scenario, number);
  const motion::Motion& idle = library.idle_clip().motion;

  features::Scenario scenario;
  scenario.target = static_cast<motion::Target>(random.index(motion::kTargetCount));
  GridCell cell;
  cell.idle_phase =
      static_cast<int>(random.index(static_cast<std::uint64_t>(distribution.idle_phase_count)));
  features::ThreatDescription description;
  description.azimuth = static_cast<float>(random.uniform(-std::numbers::pi, std::numbers::pi));
  description.radius = static_cast<float>(distribution.radius_m);
  description.mass_kg = static_cast<float>(distribution.mass_kg);
  const Eigen::Vector3f offset = point_in_ball(distribution.aim_radius_m, random);

  for (int draw = 0; draw < kMaxDraws; ++draw) {
    const double speed = random.uniform(distribution.min_speed_mps, distribution.max_speed_mps);
    cell.time = static_cast<int>(
        random.index(static_cast<std::uint64_t>(time_to_impact_count(distribution))));
    scenario.time_to_impact_s = time_to_impact_s(distribution, cell.time);
    scenario.state = character_state_at(distribution, idle, cell);
    const double time = double{scenario.time_to_impact_s};
    const motion::Pose ahead = features::idle_pose(idle, scenario.state, scenario.time_to_impact_s);
    const Eigen::Vector3f aim =
        target_centres(library.character.skeleton, body_model, ahead)[scenario.target] + offset;
    const double least =
        std::max(distribution.min_elevation,
                 min_feasible_elevation(speed, time, distribution.radius_m, aim.z()));
    if (least > distribution.max_elevation) continue;
    description.speed_mps = static_cast<float>(speed);
    description.time_to_impact_s = scenario.time_to_impact_s;
    description.elevation = static_cast<float>(random.uniform(least, distribution.max_elevation));
    scenario.threat = features::threat_from_description(description, aim, scenario.state.facing);
    return scenario;
  }
  throw Error("",
              "no threat of the distribution stays above the ground; raise its speed or "
              "elevation, or shorten its time to impact");
}

}  // namespace flinch::train
