// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/export/gltf_writer.h"
#include "features/threat.h"
#include "lookahead/look_ahead.h"
#include "motion/clip.h"
#include "runtime/library.h"

namespace flinch::program {

/// A response from perception until the character idles again, with everything that happens in
/// between.
struct ResponseRecording {
  motion::Motion motion;
  database::BallTrack ball;
  int clip = 0;                      ///< clip of the response
  std::optional<int> reaction_clip;  ///< clip that takes over after the blow
  float impact_s = 0;                ///< predicted
  float contact_s = 0;               ///< of ball and body; infinite if the ball hits nothing
  float impulse_ns = 0;              ///< on all bodies
  motion::Body hit_body{};           ///< the one with the largest impulse, if the ball hits
  bool knocked_over = false;
};

/// Plays the response of a character at the origin, facing +X, to a threat that will hit `target`
/// in `time_to_impact_s`: the run time's motion and, from shortly before the impact, the physical
/// reaction (reaction/reaction.h). Chooses by looking ahead at so many candidates, if `look_ahead`
/// is memory for that. Throws Error if the run time refuses the threat.
ResponseRecording record_response(const runtime::Library& library, const features::Threat& threat,
                                  motion::Target target, float time_to_impact_s,
                                  lookahead::LookAheadWorkspace* look_ahead = nullptr,
                                  int candidates = 1, float rate_hz = 60);

}  // namespace flinch::program
