// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/library/library.h"
#include "motion/figure.h"

namespace flinch::database {

/// Measures of how human one clip looks.
struct ClipQuality {
  std::string name;
  /// largest excess of a joint over its human limit in the clip, degrees
  float limit_excess_deg = 0;
  std::string limit_joint;  ///< that joint; empty where none exceeds its limit
  /// Largest excess that a joint has for half of the clip, the median over the poses, degrees.
  float usual_limit_excess_deg = 0;
  std::string usual_limit_joint;  ///< that joint; empty where that is none
  /// Smallest distance between a hand's capsule and head or trunk, m: negative where they
  /// intersect.
  float hand_clearance_m = 0;
  /// Largest slip of a sole point while it is on the ground under the support foot, m.
  float support_drift_m = 0;
  float foot_below_ground_m = 0;  ///< deepest point of a sole, m; 0 if none is below the ground
  /// Smallest distance of the centre of mass inside the soles' convex hull over the rest poses
  /// (first, peak and last), m. Negative outside.
  float balance_margin_m = 0;
  /// Largest ratio of a joint's speed to that joint's human peak speed.
  float speed_share = 0;
  std::string speed_joint;
  float peak_acceleration_mps2 = 0;  ///< of any body's centre of mass
};

/// Bounds for a good clip. Acceleration bounds are three times the median of the recorded clips
/// that the library was compared with (docs/authoring.md).
struct QualityBounds {
  float limit_excess_deg = 0.1F;
  float hand_clearance_m = 0;
  float support_drift_m = 0.002F;
  float foot_below_ground_m = 0.002F;
  float balance_margin_m = 0;
  float speed_share = 1;
  float peak_acceleration_mps2 = 204;
};

/// A foot up to this far above the ground counts as standing on it, m.
inline constexpr float kContactHeight = 0.005F;

/// Measures one clip of the figure, authored or recorded.
ClipQuality measure_quality(const motion::Figure& figure, const motion::Clip& clip);

/// The measures of joints and feet alone, from about `rate_hz` poses a second: a quick look at a
/// clip. The others are 0.
ClipQuality measure_joints_and_feet(const motion::Figure& figure, const motion::Clip& clip,
                                    float rate_hz);

/// Measures all clips of a library, in its order.
std::vector<ClipQuality> measure_quality(const ClipLibrary& library);

/// Returns the names of the measures that break a bound; empty for a good clip.
std::vector<std::string> broken_bounds(const ClipQuality& quality,
                                       const QualityBounds& bounds = {});

/// Returns the human peak speed for a row of human_joint_limits(), degrees per second.
float peak_human_speed_dps(std::string_view joint);

}  // namespace flinch::database
