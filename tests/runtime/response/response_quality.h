// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "runtime/response/response.h"

namespace flinch::tests {

/// Measures of how physically plausible a response is, computed from its poses alone.
struct ResponseQuality {
  /// Largest slip of a point of the sole that carries more weight, from where it landed, while it
  /// is on the ground, m.
  float support_slip_m = 0;
  float clip_slip_m = 0;     ///< the same for the clip itself, from its onset to its end
  float below_ground_m = 0;  ///< largest depth of a sole's point
  /// Largest change of a joint's velocity at a seam of the response, divided by the 99th percentile
  /// of such changes in the clip itself.
  float seam_share = 0;
  std::string seam;  ///< name of the seam and of the joint
  /// Smallest distance of the centre of mass inside the sole of the standing foot when the other
  /// foot leaves the ground because the response makes it step: before the clip's peak or on the
  /// way home.
  float lift_margin_m = 1;
  float lift_s = 0;
  /// The same of the extrapolated centre of mass (Hof et al. 2005), which must be over the sole for
  /// a body in motion to be in balance.
  float extrapolated_margin_m = 1;
  /// Time of the clip's peak less that of the predicted impact, s; none if the clip is too long for
  /// the available time.
  std::optional<float> peak_error_s;
};

/// Returns the 99th percentile of the changes of joints' velocities from frame to frame of a clip
/// that is played at `playback_rate`, rad/s.
float velocity_step_of(const motion::Clip& clip, float playback_rate);

ResponseQuality measure_response(const runtime::Response& response, float time_to_impact_s);

}  // namespace flinch::tests
