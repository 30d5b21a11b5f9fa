// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "database/export/gltf_writer.h"
#include "features/threat.h"
#include "lookahead/look_ahead.h"
#include "motion/clip.h"
#include "runtime/library.h"

namespace flinch::program {

/// How a reaction to a blow ends.
enum class Ending : std::uint8_t {
  clip,    ///< with the library's clip that fits the blow, if there is one, else as `stance`
  stance,  ///< in the response, and back to the stance
  none,    ///< there is no reaction: balls move nothing
};

/// A threat that will hit `target` in `time_to_impact_s`.
struct RecordedThreat {
  features::Threat threat;
  motion::Target target = motion::Target::head;
  float time_to_impact_s = 0;
};

/// What is recorded.
struct RecordedScene {
  int stance = 0;                       ///< that the character is in
  float stance_time_s = 0;              ///< how far it is in it
  std::vector<RecordedThreat> threats;  ///< at least one, the first to hit first
  std::optional<int> clip;              ///< that answers the first threat, which is the only one
  bool by_rule = false;                 ///< Character::brace() answers the first threat
  bool startles = false;                ///< by rule
  runtime::PerceptionLimits limits;
  std::uint64_t seed = 1;  ///< of the character's errors
  Ending ending = Ending::clip;
};

/// A blow.
struct RecordedHit {
  float contact_s = std::numeric_limits<float>::infinity();  ///< infinite if the ball hits nothing
  float impulse_ns = 0;                                      ///< on all bodies
  motion::Body hit_body{};  ///< the one with the largest impulse, if the ball hits
};

/// A response from perception until the character is in its stance again, with everything that
/// happens in between.
struct ResponseRecording {
  motion::Motion motion;
  database::BallTrack ball;
  bool is_noticed = true;            ///< false: the character has not noticed the threat
  int clip = 0;                      ///< clip of the response, or runtime::kNoClip
  std::optional<int> reaction_clip;  ///< clip that takes over after the blow
  float impact_s = 0;                ///< of the first threat, predicted
  std::vector<RecordedHit> hits;     ///< of each threat
  bool knocked_over = false;
};

/// Plays the response of a character at the origin, facing +X, to the scene's threats: the run
/// time's motion and, from shortly before each impact, the physical reaction (reaction/reaction.h).
/// Chooses by looking ahead at so many candidates, if `look_ahead` is memory for that. Throws Error
/// if the run time refuses a threat.
ResponseRecording record_response(const runtime::Library& library, const RecordedScene& scene,
                                  lookahead::LookAheadWorkspace* look_ahead = nullptr,
                                  int candidates = 1, float rate_hz = 60);

}  // namespace flinch::program
