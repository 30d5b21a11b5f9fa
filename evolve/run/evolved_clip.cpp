// SPDX-License-Identifier: MIT
#include "evolve/run/evolved_clip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "database/author/protective_motion.h"
#include "database/files/pose_packer.h"
#include "motion/error.h"
#include "motion/mirror.h"
#include "sim/rehearsal/throw_simulator.h"

namespace flinch::evolve {
namespace {

/// Rounds to a multiple of a quarter of pi in (-pi, pi].
float nearest_direction(double azimuth) {
  constexpr double kEighth = std::numbers::pi / 4;
  const double eighths = std::remainder(std::round(azimuth / kEighth), 8.0);
  return static_cast<float>((eighths <= -4 ? 4 : eighths) * kEighth);
}

}  // namespace

motion::Clip clip_to(const motion::Figure& figure, const motion::Clip& idle, const PacedPose& paced,
                     const ClipDescription& description) {
  database::ProtectiveTiming timing;
  timing.protect_s = static_cast<float>(paced.time_s);
  timing.recover_s = std::max(timing.recover_s, timing.protect_s);
  motion::Clip clip;
  clip.name = description.name;
  clip.kind = "evolved";
  clip.source = description.source;
  clip.motion = database::protective_motion(figure, idle.motion.poses.front(), std::nullopt,
                                            paced.pose, timing, idle.motion.rate_hz);
  motion::Annotation annotation;
  annotation.target = description.target;
  annotation.direction = nearest_direction(description.azimuth);
  annotation.degree = motion::Degree::exaggerated;
  annotation.peak_s = timing.protect_s + timing.settle_s;
  annotation.end_s = clip.motion.duration_s();
  clip.annotation = annotation;
  return clip;
}

EvolvedClip make_evolved_clip(const motion::Figure& figure, const motion::Clip& idle,
                              const PacedPose& paced, const ClipDescription& description) {
  constexpr double kSlowest = 2.5;  // times the pace
  constexpr double kSlower = 1.1;
  PacedPose slower = paced;
  for (;; slower.time_s *= kSlower) {
    EvolvedClip made;
    made.clip = clip_to(figure, idle, slower, description);
    made.quality = database::measure_quality(figure, made.clip);
    made.broken_bounds = broken_bounds(made.quality);
    if (made.broken_bounds.empty() || slower.time_s * kSlower > kSlowest * paced.time_s)
      return made;
  }
}

double clip_pain(const PoseTrial& trial, const motion::Clip& idle, const motion::Clip& clip,
                 std::uint64_t first_draw, std::uint64_t draws) {
  const double begin_s =
      trial.options().thrown.time_to_impact_s - static_cast<double>(clip.annotation->peak_s);
  motion::Motion played;
  played.rate_hz = idle.motion.rate_hz;
  const auto count = static_cast<std::size_t>(std::ceil(trial.duration_s() * played.rate_hz)) + 3;
  for (std::size_t k = 0; k < count; ++k) {
    const auto since = static_cast<float>(static_cast<double>(k) / played.rate_hz - begin_s);
    played.poses.push_back(sample(clip.motion, since));
  }
  const sim::Rehearsal rehearsal = trial.simulator().rehearse(played, 0, trial.duration_s());
  std::vector<sim::Throw> throws;
  for (std::uint64_t draw = first_draw; draw < first_draw + draws; ++draw)
    for (const features::Ball& ball : trial.balls(draw)) throws.push_back({rehearsal, ball});
  return trial.mean_pain(sim::ThrowSimulator(trial.simulator()).simulate(throws));
}

void add_clip(const motion::Clip& clip, database::ClipLibrary& library) {
  motion::Clip mirror = motion::mirrored(clip);
  for (const motion::Clip& other : library.clips) {
    if (other.name == clip.name || other.name == mirror.name)
      throw Error("", "the library has a clip '" + other.name + "' already");
  }
  for (const motion::Clip& added : {clip, mirror}) {
    library.clips.push_back(added);
    database::snap(library.clips.back().motion);
  }
}

}  // namespace flinch::evolve
