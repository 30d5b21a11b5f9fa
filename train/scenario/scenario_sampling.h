// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "database/library/library.h"
#include "features/feature_layout.h"
#include "features/scenario.h"
#include "motion/body.h"
#include "motion/loop.h"
#include "train/scenario/threat_kind.h"

namespace flinch::train {

/// How often characters are in a stance when they perceive a threat.
struct StanceShare {
  int stance = 0;     ///< index in database::stance_clips
  std::string name;   ///< of its clip, for readers; may be empty for the idle clip
  double weight = 1;  ///< relative to the other stances
};

/// Distribution of the scenarios that are trained for. Kinds of threats by default: a volleyball.
struct ScenarioDistribution {
  std::vector<ThreatKind> kinds = std::vector<ThreatKind>(1);  ///< at least one
  /// Times to impact are the least of all kinds plus a whole number of steps, so that scenarios can
  /// share responses. The step is three frames at 60 Hz: a response that starts one step later has
  /// its frames at the same times before the impact.
  double time_to_impact_step_s = 0.05;
  std::vector<StanceShare> stances = std::vector<StanceShare>(1);  ///< at least one
  /// Number of phases that the idle clip can have at the predicted impact.
  int idle_phase_count = 4;
  /// The same of each other stance, in which more changes.
  int moving_phase_count = 8;

  /// Whether characters may be in another stance than the idle clip.
  bool has_stances() const { return stances.size() > 1 || stances.front().stance != 0; }
};

/// The variables, besides the clip, that a response depends on, as indices of a grid.
struct GridCell {
  /// Phase of the stance at the predicted impact; those of the distribution's stances in turn.
  int state = 0;
  int time = 0;  ///< steps of the time to impact above the least of all kinds
  auto operator<=>(const GridCell&) const = default;
};

/// Returns the number of times to impact, over all kinds.
int time_to_impact_count(const ScenarioDistribution& distribution);
float time_to_impact_s(const ScenarioDistribution& distribution, int time);

/// Returns the motions of a library's stances, in the order of database::stance_clips. They refer
/// to the library.
std::vector<motion::Loop> stance_loops(const database::ClipLibrary& library);

/// Returns the number of GridCell::state.
int state_count(const ScenarioDistribution& distribution);

/// Returns the state of the character at perception. Its stance has the cell's phase at the impact.
/// Then a character whose stance travels is where the stance's own motion is in its first cycle, so
/// that it is in the same place whatever the time to the impact; others stand at the origin.
/// `stances` are those of the library.
features::CharacterState character_state_at(const ScenarioDistribution& distribution,
                                            std::span<const motion::Loop> stances, GridCell cell);

/// Returns the grid cell of a scenario that was drawn from this distribution.
GridCell grid_cell_of(const ScenarioDistribution& distribution,
                      std::span<const motion::Loop> stances, const features::Scenario& scenario);

/// Returns the largest impulse that a threat of the distribution can give, N·s.
double largest_impulse_ns(const ScenarioDistribution& distribution);

/// Draws scenario `number`: kind, target, stance, grid cell, azimuth, size, mass, speed, elevation
/// and aim point, kind, target and stance by their weights and each of the others uniformly over
/// its range. The threat's centre reaches the aim point at `time_to_impact_s`, so the surfaces
/// touch a few centimetres of flight earlier.
///
/// A ball in free fall that arrives slowly, late and level would have started below the ground. The
/// elevation is drawn from the part of its range in which the ball starts above the ground; if
/// there is no such part, speed and time to impact are drawn again.
///
/// The same arguments give the same bits. Throws Error if the distribution allows no threat.
features::Scenario sample_scenario(const database::ClipLibrary& library,
                                   const motion::BodyModel& body_model,
                                   const ScenarioDistribution& distribution, std::uint64_t seed,
                                   std::uint64_t number);

/// Returns the minimum elevation at the impact, radians, of a threat that hits at `impact_height_m`
/// and was not below the ground at perception; pi/2 if every threat was. It falls or flies
/// straight.
double min_feasible_elevation(double speed_mps, double time_to_impact_s, double radius_m,
                              double impact_height_m, bool falls = true);

/// Returns the features of a threat to a character that stands still: it hits the target's centre
/// (`centres`, in the frame of the features) while the character neither moves nor turns. Frames,
/// flight and features are computed as for a sampled scenario.
features::FeatureVector described_features(const features::Layout& layout,
                                           const features::ThreatDescription& description,
                                           const motion::PerTarget<Eigen::Vector3f>& centres);

/// Returns the centres of the targets of an idling character, world, m.
motion::PerTarget<Eigen::Vector3f> target_centres(const motion::Skeleton& skeleton,
                                                  const motion::BodyModel& body_model,
                                                  const motion::Pose& pose);

/// Returns the same in the frame of the features: origin on the ground below the pelvis, X along
/// the facing.
motion::PerTarget<Eigen::Vector3f> target_centres_in_character_frame(
    const motion::Skeleton& skeleton, const motion::BodyModel& body_model,
    const motion::Pose& pose);

}  // namespace flinch::train
