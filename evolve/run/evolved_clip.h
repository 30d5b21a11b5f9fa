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

/// A pose, and the time that its clip takes to it.
struct PacedPose {
  motion::Pose pose;
  double time_s = 0;
};

/// A pose as a clip, by the transitions and with the hold and the way back of authored clips
/// (database/author). The way back is no faster than the way there. Its peak is when the pose is
/// reached.
motion::Clip clip_to(const motion::Figure& figure, const motion::Clip& idle, const PacedPose& paced,
                     const ClipDescription& description);

/// The same, at its pace or, where that breaks a bound of database::QualityBounds, slower.
struct EvolvedClip {
  motion::Clip clip;
  database::ClipQuality quality;
  std::vector<std::string> broken_bounds;  ///< that no pace keeps; empty for a good clip
};
EvolvedClip make_evolved_clip(const motion::Figure& figure, const motion::Clip& idle,
                              const PacedPose& paced, const ClipDescription& description);

/// Mean pain of the balls of some draws against a clip that is played so that its peak is at the
/// impact, N·s.
double clip_pain(const PoseTrial& trial, const motion::Clip& idle, const motion::Clip& clip,
                 std::uint64_t first_draw, std::uint64_t draws);

/// Appends a clip and its mirror image. Throws Error if the library has a clip of that name.
void add_clip(const motion::Clip& clip, database::ClipLibrary& library);

}  // namespace flinch::evolve
