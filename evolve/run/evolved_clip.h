// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/library/library.h"
#include "database/quality/quality.h"
#include "evolve/trial/pose_trial.h"

namespace flinch::evolve {

/// What an evolved clip answers, and its name.
struct ClipDescription {
  std::string name;
  motion::Target target = motion::Target::head;
  double azimuth = 0;  ///< where the ball comes from, radians; annotated to the nearest 45 degrees
  std::string source;
};

/// A pose as a clip: by the transitions and with the hold and the way back of authored clips
/// (database/author), as fast as the pose was tested or, where that breaks a bound of
/// database::QualityBounds, slower.
struct EvolvedClip {
  motion::Clip clip;
  database::ClipQuality quality;
  std::vector<std::string> broken_bounds;  ///< that no pace keeps; empty for a good clip
};
EvolvedClip make_evolved_clip(const PoseTrial& trial, const motion::Clip& idle,
                              const motion::Pose& pose, const ClipDescription& description);

/// Mean pain of the balls of some draws against a clip that is played so that its peak is at the
/// impact, N·s.
double clip_pain(const PoseTrial& trial, const motion::Clip& idle, const motion::Clip& clip,
                 std::uint64_t first_draw, std::uint64_t draws);

/// Appends a clip and its mirror image. Throws Error if the library has a clip of that name.
void add_clip(const motion::Clip& clip, database::ClipLibrary& library);

}  // namespace flinch::evolve
