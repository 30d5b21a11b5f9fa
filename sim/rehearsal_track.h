// SPDX-License-Identifier: MIT
#pragma once

#include "motion/clip.h"
#include "sim/rehearsal.h"

namespace flinch::sim {

/// What a rehearsal keeps.
struct Rehearsal::Track {
  motion::Motion motion;
  double from_s = 0;
  double duration_s = 0;
};

}  // namespace flinch::sim
