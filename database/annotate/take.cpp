// SPDX-License-Identifier: MIT
#include "database/annotate/take.h"

#include <algorithm>

#include "database/annotate/signals.h"
#include "database/annotate/trajectory.h"
#include "database/import/retarget.h"
#include "database/import/source_character.h"
#include "database/import/source_file.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

constexpr float kRate_hz = 60;
constexpr float kStature_m = 1.75F;

// Exporters put their pose into the first frames, not into the middle.
constexpr double kMaxLeadIn_s = 0.5;

// Returns the first pose of the recording proper.
std::size_t first_recorded(const Trajectory& trajectory) {
  const float farthest = kMaxBodySpeed_mps / trajectory.rate_hz;
  const std::size_t end =
      std::min(frames_in(kMaxLeadIn_s, trajectory.rate_hz), trajectory.count() - 1);
  std::size_t first = 0;
  for (std::size_t i = 0; i < end; ++i) {
    // The pose after a jump may itself be interpolated between the two sides.
    if (pose_distance(trajectory.joints[i], trajectory.joints[i + 1]) > farthest) first = i + 2;
  }
  return std::min(first, trajectory.count() - 1);
}

}  // namespace

Take read_take(const std::string& path, const SourceOptions& options) {
  const Source source = analyse_source(read_source_file(path), options);
  if (source.bvh.frame_count < 2) {
    throw Error(path, "has one frame; a take needs motion to be annotated");
  }
  check_frame_count(path, {0, source.bvh.duration_s(), 0}, kRate_hz);
  const SourceMotion recorded = source_motion(source);
  CharacterOptions character;
  character.height_m = kStature_m;
  Take take;
  take.source = source.report;
  take.figure = motion::make_figure(character_of(source, character));
  take.motion = retarget(recorded, take.figure.skeleton(), {0, recorded.duration_s(), 0}, kRate_hz);
  const std::size_t first = first_recorded(trajectory_of(take.figure, take.motion));
  take.start_s = recorded.start_s + static_cast<double>(first) / static_cast<double>(kRate_hz);
  take.motion.poses.erase(take.motion.poses.begin(),
                          take.motion.poses.begin() + static_cast<std::ptrdiff_t>(first));
  return take;
}

}  // namespace flinch::database
