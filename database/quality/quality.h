// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/library/library.h"
#include "motion/figure.h"

namespace flinch::database {

/// How human one clip is.
struct ClipQuality {
  std::string name;
  float limit_excess_deg = 0;  ///< worst joint beyond its human limit over the clip, degrees
  std::string limit_joint;     ///< which one; empty where none is
  /// Least distance of a hand's capsule and head or trunk, m: negative where it goes through.
  float hand_clearance_m = 0;
  /// Farthest that a sole's point slips while it is on the ground under the support foot, m.
  float support_drift_m = 0;
  float foot_below_ground_m = 0;  ///< deepest point of a sole, m; 0 above
  /// Least distance of the centre of mass inside the soles' hull over the rest poses: the first,
  /// the peak's and the last. Negative outside.
  float balance_margin_m = 0;
  /// Largest of joint speed over the human one of that joint, and whose it is.
  float speed_share = 0;
  std::string speed_joint;
  float peak_acceleration_mps2 = 0;  ///< of any body's centre of mass
};

/// What a good clip keeps to. Accelerations: three times the median over the real clips that the
/// library was compared with (docs/authoring.md).
struct QualityBounds {
  float limit_excess_deg = 0.1F;
  float hand_clearance_m = 0;
  float support_drift_m = 0.002F;
  float foot_below_ground_m = 0.002F;
  float balance_margin_m = 0;
  float speed_share = 1;
  float peak_acceleration_mps2 = 204;
};

/// A foot that is up to this far above the ground stands on it, m.
inline constexpr float kContactHeight = 0.005F;

/// Measures one clip. Works for any clip of the figure, authored or recorded.
ClipQuality measure_quality(const motion::Figure& figure, const motion::Clip& clip);

/// All clips of a library, in its order.
std::vector<ClipQuality> measure_quality(const ClipLibrary& library);

/// Names of the measures that break a bound; empty for a good clip.
std::vector<std::string> broken_bounds(const ClipQuality& quality,
                                       const QualityBounds& bounds = {});

/// Human peak speed of a row of human_joint_limits(), degrees a second.
float peak_human_speed_dps(std::string_view joint);

}  // namespace flinch::database
