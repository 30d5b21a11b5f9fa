// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::sim {

/// An impulse that a body received in a contact step, and where.
struct PlacedImpulse {
  motion::Body body{};
  bool from_ball = true;                            ///< or from a body that the ball drove into it
  double time_s = 0;                                ///< of the start of the step
  double impulse_ns = 0;                            ///< magnitude, N·s
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< in the frame of the body's joint, m
  Eigen::Vector3d point_world = Eigen::Vector3d::Zero();  ///< m
};

}  // namespace flinch::sim
