// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <numbers>

#include "database/library/library.h"
#include "features/feature_layout.h"
#include "features/scenario.h"
#include "motion/body.h"

namespace flinch::train {

/// Which threats are trained for: the design's defaults, a volleyball thrown or spiked from
/// anywhere. Angles in radians.
struct ScenarioDistribution {
  double radius_m = 0.105;
  double mass_kg = 0.27;
  double min_speed_mps = 8;  ///< at the impact
  double max_speed_mps = 30;
  double min_elevation = -10 * std::numbers::pi / 180;  ///< at the impact
  double max_elevation = 45 * std::numbers::pi / 180;
  double min_time_to_impact_s = 0.25;
  double max_time_to_impact_s = 1.2;
  /// Times to impact are the least and whole steps more, so that responses can be shared. Three
  /// frames at 60 Hz: a response that begins a step later has its frames where they were, seen from
  /// the impact.
  double time_to_impact_step_s = 0.05;
  /// In how many places of its way to and fro the idle clip can be at the predicted impact.
  int idle_phase_count = 4;
  /// Threats aim at a point drawn uniformly from a ball of this radius about the target's centre:
  /// about the half-width of a head or a thigh, so that some threats graze and some miss.
  double aim_radius_m = 0.1;
};

/// A place on the grid of what a response depends on beside its clip.
struct GridCell {
  int idle_phase = 0;  ///< where the idle clip is at the predicted impact
  int time = 0;        ///< steps of the time to impact above the least
  auto operator<=>(const GridCell&) const = default;
};

/// How many times to impact there are.
int time_to_impact_count(const ScenarioDistribution& distribution);
float time_to_impact_s(const ScenarioDistribution& distribution, int time);

/// The character at perception, standing at the origin, from where the idle clip is at the impact.
features::CharacterState character_state_at(const ScenarioDistribution& distribution,
                                            const motion::Motion& idle, GridCell cell);

/// The place of a scenario that was drawn from this distribution.
GridCell grid_cell_of(const ScenarioDistribution& distribution, const motion::Motion& idle,
                      const features::Scenario& scenario);

/// A scenario drawn by number: target, place on the grid, azimuth, speed, elevation and aim point,
/// each uniform over its range. The threat's centre comes to the aim point at `time_to_impact_s`,
/// so the surfaces touch a few centimetres of flight earlier.
///
/// A ball in free fall that arrives slowly, late and level would have come from below the ground:
/// the elevation is drawn from the part of its range in which the ball starts above it, and speed
/// and time to impact are drawn again where there is no such part.
///
/// The same arguments give the same bits. Throws Error if the distribution allows no threat.
features::Scenario sample_scenario(const database::ClipLibrary& library,
                                   const motion::BodyModel& body_model,
                                   const ScenarioDistribution& distribution, std::uint64_t seed,
                                   std::uint64_t number);

/// The least elevation at the impact, radians, from which a threat that hits at `impact_height_m`
/// was not below the ground at perception; pi/2 if it always was.
double min_feasible_elevation(double speed_mps, double time_to_impact_s, double radius_m,
                              double impact_height_m);

using features::TargetCentres;

/// A threat to one target of a character that stands still, as a person describes it.
struct DescribedThreat {
  motion::Target target = motion::Target::head;
  features::ThreatDescription approach;
};

/// The features of a described threat: it comes to the target's centre (`centres`, in the frame of
/// the features), and the character neither moves nor turns until then. The same frames, flight
/// and features as of a sampled scenario.
features::FeatureVector described_features(const features::Layout& layout,
                                           const DescribedThreat& threat,
                                           const TargetCentres& centres);

/// Centres of the targets of an idling character, world, m.
TargetCentres target_centres(const motion::Skeleton& skeleton, const motion::BodyModel& body_model,
                             const motion::Pose& pose);

/// The same in the frame of the features: origin on the ground below the pelvis, X along the
/// facing.
TargetCentres target_centres_in_character_frame(const motion::Skeleton& skeleton,
                                                const motion::BodyModel& body_model,
                                                const motion::Pose& pose);

}  // namespace flinch::train
