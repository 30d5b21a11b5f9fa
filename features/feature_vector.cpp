// SPDX-License-Identifier: MIT
#include "features/feature_vector.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"

namespace flinch::features {

Features features_of(const Scenario& scenario, const motion::Loop& stance) {
  const CharacterState& state = scenario.state;
  const Eigen::Quaternionf to_character(Eigen::AngleAxisf(-state.facing, Eigen::Vector3f::UnitZ()));
  const motion::Pose now = idle_pose(stance, state, 0);
  const motion::Pose then = idle_pose(stance, state, scenario.time_to_impact_s);
  const Eigen::Vector3f origin(now.root_position.x(), now.root_position.y(), 0);

  const Threat& threat = scenario.threat;
  const Eigen::Vector3f position = to_character * (threat.position - origin);
  // a zero vector stays zero
  const Eigen::Vector3f heading = to_character * threat.velocity.normalized();
  const Eigen::Vector3f ahead = to_character * (then.root_position - origin);
  const float ahead_facing = motion::facing(then) - state.facing;
  const auto is_target = [&](motion::Target target) {
    return scenario.target == target ? 1.0F : 0.0F;
  };

  return {.position_x = position.x(),
          .position_y = position.y(),
          .position_z = position.z(),
          .heading_x = heading.x(),
          .heading_y = heading.y(),
          .heading_z = heading.z(),
          .speed_mps = threat.velocity.norm(),
          .time_to_impact_s = scenario.time_to_impact_s,
          .target_head = is_target(motion::Target::head),
          .target_trunk = is_target(motion::Target::trunk),
          .target_pelvis = is_target(motion::Target::pelvis),
          .target_legs = is_target(motion::Target::legs),
          .ahead_x = ahead.x(),
          .ahead_y = ahead.y(),
          .ahead_facing_sin = std::sin(ahead_facing),
          .ahead_facing_cos = std::cos(ahead_facing)};
}

FeatureVector to_vector(const Features& features) {
  const Features& f = features;
  return {f.position_x,  f.position_y,   f.position_z,       f.heading_x,
          f.heading_y,   f.heading_z,    f.speed_mps,        f.time_to_impact_s,
          f.target_head, f.target_trunk, f.target_pelvis,    f.target_legs,
          f.ahead_x,     f.ahead_y,      f.ahead_facing_sin, f.ahead_facing_cos};
}

// A float can hold it.
constexpr double kMaxScaled = 1e30;

void Scaling::apply(std::span<const float> raw, std::span<double> scaled) const {
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const double range = max[i] - min[i];
    const double value = range > 0 ? -1 + 2 * (static_cast<double>(raw[i]) - min[i]) / range : 0;
    scaled[i] = static_cast<double>(static_cast<float>(std::clamp(value, -kMaxScaled, kMaxScaled)));
  }
}

Scaling make_scaling(std::span<const FeatureVector> rows, std::span<const std::string> names) {
  if (rows.empty()) throw Error("", "no observations to make a feature scaling from");
  Scaling scaling;
  const std::span<const float> first = std::span(rows.front()).first(names.size());
  scaling.min.assign(first.begin(), first.end());
  scaling.max = scaling.min;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double value = rows[row][i];
      if (!std::isfinite(value)) {
        throw Error("", "feature " + names[i] + " of observation " + std::to_string(row) +
                            " is not a finite number");
      }
      scaling.min[i] = std::min(scaling.min[i], value);
      scaling.max[i] = std::max(scaling.max[i], value);
    }
  }
  return scaling;
}

}  // namespace flinch::features
