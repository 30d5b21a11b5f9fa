// SPDX-License-Identifier: MIT
#pragma once

#include "features/predicted_motion.h"
#include "motion/loop.h"
#include "runtime/response/footwork.h"

namespace flinch::runtime {

/// A moment of a walk that is nearest to standing: one foot stands and the other passes it.
struct Passing {
  float time_s = 0;           ///< in the cycle
  float until_landing_s = 0;  ///< from then until the other foot is down
};

/// A stance with precomputed data.
struct PreparedStance {
  int clip = 0;  ///< index in the library
  motion::Loop loop;
  features::MotionBounds bounds;     ///< of its motion
  motion::PerSide<Passing> passing;  ///< by the foot that stands; only where the loop travels
};

PreparedStance prepare_stance(const motion::Skeleton& skeleton, const motion::BodyModel& bodies,
                              const motion::PerSide<Sole>& soles, int clip,
                              const motion::Loop& loop);

}  // namespace flinch::runtime
