// SPDX-License-Identifier: MIT
#include "database/author/protective_motion.h"

#include <cmath>

namespace flinch::database {

using motion::Pose;

ProtectivePoses protective_poses(const motion::Figure& figure, const motion::Motion& motion,
                                 float time_s, const AimedThreat& threat,
                                 const RuleControls& controls, bool with_startle) {
  ProtectivePoses poses;
  poses.start = sample(motion, time_s);
  if (with_startle) {
    poses.startled = startle(figure, sample(motion, time_s + kStartleLookAhead), threat);
  }
  poses.sustained =
      balanced_pose(figure, sample(motion, time_s + kSustainedLookAhead), threat, controls);
  return poses;
}

motion::Motion protective_motion(const motion::Figure& figure, const Pose& start,
                                 const std::optional<Pose>& startled, const Pose& sustained,
                                 const ProtectiveTiming& timing, float rate_hz) {
  const Transition flinch = make_transition(figure, start, startled.value_or(start));
  const Transition protect = make_transition(figure, startled.value_or(start), sustained);
  const Transition recover = make_transition(figure, start, sustained);  // played backwards
  const float startle_s = startled ? kStartle : 0;
  const float hold_until = timing.protect_s + timing.hold_s;
  const float duration = hold_until + timing.recover_s;

  motion::Motion motion;
  motion.rate_hz = rate_hz;
  const int count = static_cast<int>(std::ceil(duration * rate_hz)) + 1;
  for (int k = 0; k < count; ++k) {
    const float time = static_cast<float>(k) / rate_hz;
    if (time < startle_s) {
      motion.poses.push_back(pose_at(figure, flinch, time / startle_s));
    } else if (time < hold_until) {
      const float part = (time - startle_s) / (timing.protect_s - startle_s);
      motion.poses.push_back(pose_at(figure, protect, part));
    } else {
      motion.poses.push_back(pose_at(figure, recover, 1 - (time - hold_until) / timing.recover_s));
    }
  }
  return motion;
}

}  // namespace flinch::database
