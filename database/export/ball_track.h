// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "features/threat.h"

namespace flinch::database {

/// A ball, or a rod, that is exported with a motion.
struct BallTrack {
  float radius = static_cast<float>(features::kVolleyballRadius_m);  ///< m
  /// Position of its centre for each pose of the motion, world, m; nothing where the ball is not
  /// visible. It is then scaled to 0 and stays where it was last visible, or will first be visible.
  std::vector<std::optional<Eigen::Vector3f>> positions;
  /// From the centre of a rod to those of its rounded ends, m; 0 for a ball.
  float half_length = 0;
  std::vector<Eigen::Vector3f> axes{};  ///< of a rod, for each pose, unit; none for a ball
};

}  // namespace flinch::database
