// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>

#include "motion/body.h"

namespace flinch::motion {

/// Where the bodies of a character are and how they move, seen from its facing with the origin on
/// the ground below the pelvis. So weighted that the distance D of two is, with the mass m_b,
/// position x_b and velocity v_b of each body's centre of mass, and the total mass M,
///
///     D^2 = sum over b of m_b / M (|x_b - x'_b|^2 + T^2 |v_b - v'_b|^2),   T = 0.1 s,
///
/// as Zordan et al. 2005 compare poses; velocities stand for their window of frames. A column per
/// body, heaviest first: position, then velocity.
using PoseFeatures = Eigen::Matrix<float, 6, kBodyCount>;

/// Makes the features of a character's poses.
class PoseMetric {
 public:
  explicit PoseMetric(const Physique& character);
  /// Of a character in pose `now` that was in pose `before` `dt_s` (above 0) earlier, world.
  PoseFeatures features(const Pose& before, const Pose& now, float dt_s) const noexcept;

 private:
  Skeleton skeleton_;
  BodyModel model_;
  std::array<Body, kBodyCount> order_;
  PerBody<float> weight_;  // sqrt(m_b / M)
};

/// The largest distance D of two poses of which one may follow the other, m. In a blend over half a
/// second, a body that is 0.15 m off moves 0.3 m/s faster than it would: less than bodies differ in
/// one person's own motion.
inline constexpr float kMaxSeamDistance_m = 0.15F;

/// D^2, m^2. Where it is more than `bound`, returns any number above that as soon as it is known.
float squared_distance(const PoseFeatures& one, const PoseFeatures& other,
                       float bound = std::numeric_limits<float>::infinity()) noexcept;

}  // namespace flinch::motion
