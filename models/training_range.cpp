// SPDX-License-Identifier: MIT
#include "models/training_range.h"

#include <algorithm>
#include <cmath>

namespace flinch::models {
namespace {

/// Adds a number unless it is in the range. Numbers of scenarios are floats, and they are computed.
void add(std::string_view name, double value, const features::ValueRange& trained,
         OutsideTrainings& outside) {
  constexpr double kTolerance = 1e-3;
  const double tolerance = kTolerance * std::max(std::abs(trained.min), std::abs(trained.max));
  if (value >= trained.min - tolerance && value <= trained.max + tolerance) return;
  outside.numbers[outside.count++] = {name, value, trained};
}

/// The velocity of what strikes, at the impact, near where the character's target is.
Eigen::Vector3d impact_velocity(const Selector& selector, const features::Scenario& scenario) {
  const features::CharacterState& state = scenario.state;
  const Eigen::AngleAxisf turn(state.facing, Eigen::Vector3f::UnitZ());
  const Eigen::Vector3f centre = turn * selector.target_centres[scenario.target] +
                                 Eigen::Vector3f(state.position.x(), state.position.y(), 0);
  return striking_point(scenario.threat, scenario.time_to_impact_s, centre).velocity.cast<double>();
}

}  // namespace

OutsideTrainings outside_training(const Selector& selector, const features::Scenario& scenario) {
  OutsideTrainings outside;
  const features::Threat& threat = scenario.threat;
  const auto kind_index = static_cast<std::size_t>(threat.kind);
  if (threat.kind < 0 || kind_index >= selector.kinds.size()) {
    add("kind", threat.kind, {0, static_cast<double>(selector.kinds.size()) - 1}, outside);
    return outside;
  }
  const features::KnownKind& kind = selector.kinds[kind_index];
  const Eigen::Vector3d velocity = impact_velocity(selector, scenario);
  const double speed_mps = velocity.norm();
  const double elevation =
      speed_mps > 0 ? std::asin(std::clamp(-velocity.z() / speed_mps, -1.0, 1.0)) : 0;
  const features::ValueRange elevations{motion::degrees(kind.elevation.min),
                                        motion::degrees(kind.elevation.max)};
  add("radius_m", double{threat.radius}, kind.radius_m, outside);
  add("mass_kg", double{threat.mass_kg}, kind.mass_kg, outside);
  add("speed_mps", speed_mps, kind.speed_mps, outside);
  add("elevation_degrees", motion::degrees(elevation), elevations, outside);
  add("time_to_impact_s", double{scenario.time_to_impact_s}, kind.time_to_impact_s, outside);
  // One that starts at perception has perhaps moved before.
  if (threat.stroke && threat.stroke->starts_in_s > 0) {
    const float moves_s = threat.rod ? scenario.time_to_impact_s - threat.stroke->starts_in_s
                                     : threat.stroke->lasts_s;
    add("reach_m", speed_mps * double{moves_s}, kind.reach_m, outside);
  }
  if (threat.rod)
    add("length_m", double{threat.rod->to_butt_m + threat.rod->to_tip_m + 2 * threat.radius},
        kind.rod.length_m, outside);
  return outside;
}

}  // namespace flinch::models
