// SPDX-License-Identifier: MIT
#include "sim/contact/rod_step.h"

#include <algorithm>
#include <cmath>

namespace flinch::sim {

features::Ball rod_after_step(const features::Ball& rod, const Twist& velocity, double step_s,
                              bool is_struck) {
  features::Ball moving = rod;
  moving.velocity = velocity.linear;
  moving.rod.angular_velocity = velocity.angular;
  moving.gravity_mps2 = 0;
  features::Ball after = moving.at(step_s);
  after.gravity_mps2 = rod.gravity_mps2;
  const bool is_thrown = std::isinf(after.window.from_s);
  if (is_struck && is_thrown) after.window.until_s = std::numeric_limits<double>::infinity();
  if (lowest_point_m(after) <= 0) after.window.until_s = std::min(after.window.until_s, -step_s);
  if (after.window.is_over()) {
    after.velocity.setZero();
    after.rod.angular_velocity.setZero();
  }
  return after;
}

}  // namespace flinch::sim
