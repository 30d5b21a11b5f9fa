// SPDX-License-Identifier: MIT
#pragma once

#include "features/ball.h"
#include "sim/contact/contact_constraint.h"
#include "sim/contact/next_step.h"
#include "sim/figure/figure_rows.h"

namespace flinch::sim {

/// Path of a ball from a given time on, bouncing off the ground without spin.
class BouncingBall {
 public:
  BouncingBall(const features::Ball& ball, double time_s) : ball_(ball), time_s_(time_s) {}

  features::Ball at(double time_s) {
    while (const auto bounce =
               features::time_of_bounce(ball_, time_s - time_s_, kContactDistance_m)) {
      advance(*bounce);
      if (-ball_.velocity.z() <= kMinBounceSpeed_mps) {
        ball_.velocity.z() = 0;
        ball_.gravity_mps2 = 0;
      } else {
        ball_.velocity.z() *= -ball_.bounce.restitution;
      }
    }
    advance(time_s - time_s_);
    return ball_;
  }

 private:
  void advance(double by_s) {
    ball_ = ball_.at(by_s);
    time_s_ += by_s;
  }

  features::Ball ball_;
  double time_s_;
};

}  // namespace flinch::sim
