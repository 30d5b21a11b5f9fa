// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "motion/body.h"

namespace flinch::sim {

/// What a measured contact gave in a step: the magnitude of its force, normal and friction, times
/// the step.
struct ContactImpulse {
  motion::Body first{};
  std::optional<motion::Body> second;  ///< none: the ball hit `first`
  double impulse_ns = 0;
};

}  // namespace flinch::sim
