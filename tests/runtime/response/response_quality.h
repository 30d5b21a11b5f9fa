// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "runtime/response/response.h"

namespace flinch::tests {

/// How well a response keeps to what bodies do, measured from its poses alone.
struct ResponseQuality {
  /// Farthest that a point of the sole of the foot that carries more weight slips while it is on
  /// the ground, from where it landed, m.
  float support_slip_m = 0;
  float clip_slip_m = 0;     ///< the same of the clip itself, from its onset to its end
  float below_ground_m = 0;  ///< deepest point of a sole
  /// Largest step of a joint's velocity at a seam of the response, over the 99th percentile of such
  /// steps in the clip itself.
  float seam_share = 0;
  std::string seam;  ///< which, and whose
  /// Least distance of the centre of mass inside the sole of the standing foot when the other one
  /// leaves the ground because the response has it step: before the clip's peak or on the way home.
  float lift_margin_m = 1;
  float lift_s = 0;
  /// The same of the extrapolated centre of mass (Hof et al. 2005), which must be over the sole for
  /// a body in motion to be in balance.
  float extrapolated_margin_m = 1;
  /// How far the clip's peak is from the predicted impact, s; none where the clip is too long for
  /// the time that there is.
  std::optional<float> peak_error_s;
};

/// The 99th percentile of the steps of joints' velocities from frame to frame of a clip that is
/// played at `rate`, rad/s.
float velocity_step_of(const motion::Clip& clip, float playback_rate);

ResponseQuality measure_response(const runtime::Response& response, float time_to_impact_s);

}  // namespace flinch::tests
