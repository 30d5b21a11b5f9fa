// SPDX-License-Identifier: MIT
#include "train/scenario/scenario_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "features/ball.h"
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

/// Returns a number of the range. A range of one number draws nothing.
double draw(const ValueRange& range, features::Random& random) {
  return range.min < range.max ? random.uniform(range.min, range.max) : range.min;
}

/// Returns an index by the weights. Draws nothing where there is no choice, and as Random::index
/// does where all are alike.
template <class Weights>
std::size_t draw_index(const Weights& weights, features::Random& random) {
  const std::size_t count = weights.size();
  if (count == 1) return 0;
  if (std::all_of(weights.begin(), weights.end(), [&](double w) { return w == *weights.begin(); }))
    return static_cast<std::size_t>(random.index(count));
  double total = 0;
  for (const double weight : weights) total += weight;
  double left = random.uniform(0, total);
  std::size_t last = 0;  // of those with a weight: rounding must not choose another
  std::size_t index = 0;
  for (const double weight : weights) {
    if (weight > 0) {
      last = index;
      if (left < weight) break;
      left -= weight;
    }
    ++index;
  }
  return last;
}

std::size_t draw_kind(const std::vector<ThreatKind>& kinds, features::Random& random) {
  std::vector<double> weights;
  for (const ThreatKind& kind : kinds) weights.push_back(kind.weight);
  return draw_index(weights, random);
}

double draw_azimuth(const std::vector<ValueRange>& sectors, features::Random& random) {
  std::vector<double> widths;
  for (const ValueRange& sector : sectors) widths.push_back(sector.max - sector.min);
  return draw(sectors[draw_index(widths, random)], random);
}

/// Draws a rod; half of them have their tip on the other side. Nothing for other shapes.
std::optional<features::RodDescription> draw_rod(const ThreatKind& kind, features::Random& random) {
  if (kind.shape != features::ThreatShape::rod) return std::nullopt;
  const features::RodRanges& ranges = kind.rod;
  features::RodDescription rod;
  rod.length_m = static_cast<float>(draw(ranges.length_m, random));
  rod.balance = static_cast<float>(ranges.balance);
  rod.strikes_at = static_cast<float>(draw(ranges.strikes_at, random));
  const double tilt = draw(ranges.tilt, random);
  rod.tilt = static_cast<float>(random.index(2) == 0 ? tilt : std::numbers::pi - tilt);
  rod.grip_share = static_cast<float>(draw(ranges.grip_share, random));
  rod.grip_mass_kg = static_cast<float>(ranges.grip_mass_kg);
  rod.spin = static_cast<float>(draw(ranges.spin, random));
  return rod;
}

/// Whether all of a rod stays above the ground until it strikes.
bool stays_above_ground(const features::Scenario& scenario) {
  if (!scenario.threat.rod) return true;
  const features::Ball rod = features::ball_of(scenario.threat);
  return rod.window.until_s >= double{scenario.time_to_impact_s};
}

/// The least time to impact of all kinds.
double min_time_to_impact_s(const ScenarioDistribution& distribution) {
  double least = distribution.kinds.front().time_to_impact_s.min;
  for (const ThreatKind& kind : distribution.kinds)
    least = std::min(least, kind.time_to_impact_s.min);
  return least;
}

/// How many steps fit into a range, which is a whole number of them, except for rounding.
int steps_in(double range_s, double step_s) {
  return static_cast<int>(std::floor(range_s / step_s + 1e-6));
}

std::size_t draw_stance(const std::vector<StanceShare>& stances, features::Random& random) {
  std::vector<double> weights;
  for (const StanceShare& share : stances) weights.push_back(share.weight);
  return draw_index(weights, random);
}

int phase_count(const ScenarioDistribution& distribution, const StanceShare& share) {
  return share.stance == 0 ? distribution.idle_phase_count : distribution.moving_phase_count;
}

/// The first of a stance's states.
int first_state(const ScenarioDistribution& distribution, std::size_t share) {
  int first = 0;
  for (std::size_t i = 0; i < share; ++i)
    first += phase_count(distribution, distribution.stances[i]);
  return first;
}

/// Returns the time in the first period with the same phase.
double in_first_period(double time_s, double period_s) {
  return period_s > 0 ? time_s - period_s * std::floor(time_s / period_s) : 0;
}

}  // namespace

int time_to_impact_count(const ScenarioDistribution& distribution) {
  double most_s = 0;
  for (const ThreatKind& kind : distribution.kinds)
    most_s = std::max(most_s, kind.time_to_impact_s.max);
  return 1 +
         steps_in(most_s - min_time_to_impact_s(distribution), distribution.time_to_impact_step_s);
}

float time_to_impact_s(const ScenarioDistribution& distribution, int time) {
  return static_cast<float>(min_time_to_impact_s(distribution) +
                            time * distribution.time_to_impact_step_s);
}

std::vector<motion::Loop> stance_loops(const database::ClipLibrary& library) {
  std::vector<motion::Loop> loops;
  for (const int clip : database::stance_clips(library))
    loops.push_back(database::loop_of(library, clip));
  return loops;
}

int state_count(const ScenarioDistribution& distribution) {
  return first_state(distribution, distribution.stances.size());
}

features::CharacterState character_state_at(const ScenarioDistribution& distribution,
                                            std::span<const motion::Loop> stances, GridCell cell) {
  std::size_t share = 0;
  while (cell.state >= first_state(distribution, share + 1)) ++share;
  const int stance = distribution.stances[share].stance;
  const motion::Loop& loop = stances[static_cast<std::size_t>(stance)];
  const double period_s = double{loop.period_s()};
  const int phase = cell.state - first_state(distribution, share);
  const double at_impact_s =
      phase * period_s / phase_count(distribution, distribution.stances[share]);
  const double time_s = double{time_to_impact_s(distribution, cell.time)};
  features::CharacterState state;
  state.stance = stance;
  if (loop.has_cycles()) {
    state.idle_time_s = static_cast<float>(at_impact_s - time_s);
    return features::later(loop, state, 0);
  }
  state.idle_time_s = static_cast<float>(in_first_period(at_impact_s - time_s, period_s));
  return state;
}

GridCell grid_cell_of(const ScenarioDistribution& distribution,
                      std::span<const motion::Loop> stances, const features::Scenario& scenario) {
  const double time_s = double{scenario.time_to_impact_s};
  const auto share = static_cast<std::size_t>(
      std::ranges::find(distribution.stances, scenario.state.stance, &StanceShare::stance) -
      distribution.stances.begin());
  const auto stance = static_cast<std::size_t>(scenario.state.stance);
  const double period_s = double{stances[stance].period_s()};
  const int phases = phase_count(distribution, distribution.stances[share]);
  GridCell cell;
  cell.state = first_state(distribution, share);
  cell.time = static_cast<int>(std::lround((time_s - min_time_to_impact_s(distribution)) /
                                           distribution.time_to_impact_step_s));
  if (period_s > 0) {
    const double at_impact_s = double{scenario.state.idle_time_s} + time_s;
    cell.state += static_cast<int>(std::lround(at_impact_s / period_s * phases)) % phases;
  }
  return cell;
}

double largest_impulse_ns(const ScenarioDistribution& distribution) {
  double most = 0;
  for (const ThreatKind& kind : distribution.kinds) most = std::max(most, largest_impulse_ns(kind));
  return most;
}

// Backwards from the impact, the ball's height is z + v sin(e) t - g t^2 / 2, with g = 0 if it
// flies straight. It is concave in t and so lowest at one of its ends: only the start can be below
// the ground, and it is not if sin(e) >= (r - z + g t^2 / 2) / (v t).
double min_feasible_elevation(double speed_mps, double time_to_impact_s, double radius_m,
                              double impact_height_m, bool falls) {
  const double gravity_mps2 = falls ? double{features::kGravity} : 0;
  const double fall = 0.5 * gravity_mps2 * time_to_impact_s * time_to_impact_s;
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
  const std::vector<motion::Loop> stances = stance_loops(library);

  const std::size_t kind_index = draw_kind(distribution.kinds, random);
  const ThreatKind& kind = distribution.kinds[kind_index];
  const double step_s = distribution.time_to_impact_step_s;
  const int first_time =
      steps_in(kind.time_to_impact_s.min - min_time_to_impact_s(distribution), step_s);
  const int times = 1 + steps_in(kind.time_to_impact_s.max - kind.time_to_impact_s.min, step_s);

  features::Scenario scenario;
  scenario.target = static_cast<motion::Target>(draw_index(kind.target_weight, random));
  GridCell cell;
  const std::size_t share = draw_stance(distribution.stances, random);
  const StanceShare& stance = distribution.stances[share];
  cell.state =
      first_state(distribution, share) +
      static_cast<int>(random.index(static_cast<std::uint64_t>(phase_count(distribution, stance))));
  features::ThreatDescription description;
  description.azimuth = static_cast<float>(draw_azimuth(kind.azimuth, random));
  const double radius_m = draw(kind.radius_m, random);
  description.radius = static_cast<float>(radius_m);
  description.mass_kg = static_cast<float>(draw(kind.mass_kg, random));
  description.bounce = kind.bounce;
  description.falls = kind.falls;
  description.kind = static_cast<int>(kind_index);
  const double reach_m = draw(kind.reach_m, random);
  if (kind.is_driven()) description.reach_m = static_cast<float>(reach_m);
  description.rod = draw_rod(kind, random);
  const Eigen::Vector3f offset = point_in_ball(kind.aim_radius_m, random);

  for (int draws = 0; draws < kMaxDraws; ++draws) {
    const double speed = draw(kind.speed_mps, random);
    cell.time = first_time + static_cast<int>(random.index(static_cast<std::uint64_t>(times)));
    scenario.time_to_impact_s = time_to_impact_s(distribution, cell.time);
    scenario.state = character_state_at(distribution, stances, cell);
    const double time = double{scenario.time_to_impact_s};
    const double moves_s = kind.is_driven() ? std::min(time, reach_m / speed) : time;
    const motion::Pose ahead = features::idle_pose(stances[static_cast<std::size_t>(stance.stance)],
                                                   scenario.state, scenario.time_to_impact_s);
    const Eigen::Vector3f aim =
        target_centres(library.character.skeleton, body_model, ahead)[scenario.target] + offset;
    const double least = std::max(
        kind.elevation.min, min_feasible_elevation(speed, moves_s, radius_m, aim.z(), kind.falls));
    if (least > kind.elevation.max) continue;
    description.speed_mps = static_cast<float>(speed);
    description.time_to_impact_s = scenario.time_to_impact_s;
    description.elevation = static_cast<float>(draw({least, kind.elevation.max}, random));
    scenario.threat = features::threat_from_description(description, aim, scenario.state.facing);
    if (stays_above_ground(scenario)) return scenario;
  }
  throw Error("", "no " + kind.name +
                      " of the distribution stays above the ground; raise its speed or "
                      "elevation, or shorten its time to impact");
}

}  // namespace flinch::train
