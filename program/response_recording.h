// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/export/gltf_writer.h"
#include "features/threat.h"
#include "motion/clip.h"
#include "runtime/library.h"

namespace flinch::program {

/// A response from perception until the character idles again, with all that happens on the way.
struct ResponseRecording {
  motion::Motion motion;
  database::BallTrack ball;
  int clip = 0;                      ///< that answers
  std::optional<int> reaction_clip;  ///< that the body is given back to after the blow
  float impact_s = 0;                ///< predicted
  float contact_s = 0;               ///< of ball and body; infinite where the ball hits nothing
  float impulse_ns = 0;              ///< that the body took
  bool knocked_over = false;
};

/// Plays what a character at the origin, facing +X, does about a threat that is to hit `target` in
/// `time_to_impact_s`: the run time's motion, and from shortly before the impact the physical
/// reaction (sim/reaction.h). Throws Error where the run time refuses the threat.
ResponseRecording record_response(const runtime::Library& library, const features::Threat& threat,
                                  motion::Target target, float time_to_impact_s,
                                  float rate_hz = 60);

}  // namespace flinch::program
