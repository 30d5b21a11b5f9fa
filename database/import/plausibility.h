// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/import/retarget.h"
#include "database/import/source_motion.h"
#include "motion/figure.h"

namespace flinch::database {

// Whether what was read is a human who moves. Each function returns notes, one line each: what is
// odd and where, then the option that mends it; none where nothing is odd. docs/importing.md has
// the bounds and their sources.

/// How many poses a second are judged.
inline constexpr float kJudged_hz = 10;

/// Judges a source's figure and its frame rate: stature and mass, bones in proportion to the thigh
/// and to those of the other side, feet that point forward.
std::vector<std::string> judge_figure(const Source& source);

/// Judges whether the rotations of a BVH file, which are in degrees, look like radians: all within
/// a turn of radians, and those of a human if they are read as such. `options` are the source's.
std::vector<std::string> judge_angles(const Source& source, const SourceOptions& options);

/// A clip and what it was made from.
struct JudgedClip {
  const Source& source;
  const SourceMotion& motion;
  const Segment& segment;
  const motion::Figure& figure;
  const motion::Clip& clip;
};

/// Judges the motion of a clip: whether its source begins with a T-pose or leaves its first pose
/// faster than a body can, jumps later, and, by the measures of quality.h at ten poses a second,
/// joints beyond their limits and feet that slip. Names frames of the file, counted from 1.
std::vector<std::string> judge_motion(const JudgedClip& judged);

/// Throws Error if the clip goes farther than a library may hold (kMaxDistance_m), and names the
/// frames that do not. `where` is the clip's place in a file, for the message.
void require_near(const std::string& where, const JudgedClip& judged);

}  // namespace flinch::database
