// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "motion/body.h"

namespace flinch::sim {

/// Impulse of a measured contact in a step, N·s: the magnitude of its force, normal and friction,
/// times the step.
struct ContactImpulse {
  motion::Body first{};
  std::optional<motion::Body> second;  ///< empty if the ball hit `first`
  double impulse_ns = 0;
};

}  // namespace flinch::sim
