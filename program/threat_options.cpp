// SPDX-License-Identifier: MIT
#include "program/threat_options.h"

#include <algorithm>

#include "motion/error.h"
#include "motion/rotation.h"
#include "program/document.h"
#include "program/table.h"
#include "reaction/reaction.h"

namespace flinch::program {
namespace {

// The speed is that at the impact. A ball that falls may be faster before it, by up to 100 m/s
// after 10 s, and must not exceed there what a reaction accepts.
constexpr double kMaxSpeed_mps = 0.9 * reaction::kMaxBallSpeed_mps;

/// Returns the index of the kind that the options name, or of the first.
int kind_index(const ThreatOptions& options, const models::Selector& selector) {
  if (!options.kind) return 0;
  std::string names;
  for (std::size_t i = 0; i < selector.kinds.size(); ++i) {
    if (selector.kinds[i].name == *options.kind) return static_cast<int>(i);
    names += (i == 0 ? "" : ", ") + selector.kinds[i].name;
  }
  throw Error(
      "", "the selector was not trained for --threat " + *options.kind + "; it knows: " + names);
}

/// A rod in the middle of its kind.
features::RodDescription usual_rod(const features::RodRanges& kind) {
  const auto middle = [](const features::ValueRange& range) {
    return static_cast<float>(0.5 * (range.min + range.max));
  };
  return {.length_m = middle(kind.length_m),
          .balance = static_cast<float>(kind.balance),
          .strikes_at = middle(kind.strikes_at),
          .tilt = middle(kind.tilt),
          .grip_share = middle(kind.grip_share),
          .grip_mass_kg = static_cast<float>(kind.grip_mass_kg),
          .spin = middle(kind.spin)};
}

}  // namespace

std::vector<std::string> target_names() {
  std::vector<std::string> names;
  for (const motion::Target target : motion::kTargets) names.emplace_back(motion::name_of(target));
  return names;
}

std::vector<Option> threat_options(ThreatOptions& threat) {
  return {
      {"--threat", "kind of threat, one that the selector was trained for (default: its first)",
       &threat.kind},
      {"--azimuth", "direction it comes from, degrees: 0 the front, 90 the character's left",
       &threat.azimuth, Range{-360, 360}},
      {"--elevation",
       "angle above the horizontal at the impact, degrees (default: level, or "
       "as high as a falling ball must)",
       &threat.elevation, Range{-89, 89}},
      {"--speed", "speed at the impact, m/s (default: 20, or the nearest of its kind)",
       &threat.speed_mps, Range{0.1, kMaxSpeed_mps}},
      {"--target", "threatened part: head, trunk, pelvis or legs", &threat.target,
       OneOf{target_names()}},
      {"--time-to-impact", "time from perception, s", &threat.time_to_impact_s, Range{0.01, 10}},
      {"--radius", "radius of the ball, m (default: a volleyball's, or the nearest of its kind)",
       &threat.radius_m, Range{reaction::kMinBallRadius_m, reaction::kMaxBallRadius_m}},
      {"--mass", "mass of the ball, kg (default: a volleyball's, or the nearest of its kind)",
       &threat.mass_kg, Range{reaction::kMinBallMass_kg, reaction::kMaxBallMass_kg}}};
}

features::ThreatDescription described(const ThreatOptions& options,
                                      const models::Selector& selector) {
  constexpr double kUsualSpeed_mps = 20;
  features::ThreatDescription threat;
  threat.kind = kind_index(options, selector);
  const features::KnownKind& kind = selector.kinds[static_cast<std::size_t>(threat.kind)];
  const auto given_or_near = [](const std::optional<double>& given, double usual,
                                const features::ValueRange& range) {
    return given.value_or(std::clamp(usual, range.min, range.max));
  };
  const double speed_mps = given_or_near(options.speed_mps, kUsualSpeed_mps, kind.speed_mps);
  const double radius_m =
      given_or_near(options.radius_m, features::kVolleyballRadius_m, kind.radius_m);
  const double mass_kg = given_or_near(options.mass_kg, features::kVolleyballMass_kg, kind.mass_kg);
  threat.target = *motion::target_named(options.target);
  double moves_s = options.time_to_impact_s;
  if (kind.is_driven()) {
    threat.reach_m = static_cast<float>(kind.reach_m.max);
    moves_s = std::min(moves_s, kind.reach_m.max / speed_mps);
  }
  if (kind.shape == features::ThreatShape::rod) threat.rod = usual_rod(kind.rod);
  const double min_elevation = rounded_degrees(train::min_feasible_elevation(
      speed_mps, moves_s, radius_m, double{selector.target_centres[threat.target].z()},
      kind.falls));
  const double elevation = options.elevation.value_or(std::max(0.0, min_elevation));
  if (min_elevation >= 90)
    throw Error("", "a ball this slow would come from below the ground " +
                        fixed(options.time_to_impact_s, 2) +
                        " s before the impact; raise --speed or shorten --time-to-impact");
  if (elevation < min_elevation)
    throw Error("", "the ball would come from below the ground; raise --elevation to at least " +
                        fixed(min_elevation, 1) + ", raise --speed or shorten --time-to-impact");
  threat.azimuth = static_cast<float>(motion::radians(options.azimuth));
  threat.elevation = static_cast<float>(motion::radians(elevation));
  threat.speed_mps = static_cast<float>(speed_mps);
  threat.time_to_impact_s = static_cast<float>(options.time_to_impact_s);
  threat.radius = static_cast<float>(radius_m);
  threat.mass_kg = static_cast<float>(mass_kg);
  threat.bounce = kind.bounce;
  threat.falls = kind.falls;
  return threat;
}

}  // namespace flinch::program
