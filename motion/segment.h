// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace flinch::motion {

/// Returns the point of the segment from `from` to `to` that is nearest to `point`. The two ends
/// may coincide.
template <class Scalar, int size>
Eigen::Matrix<Scalar, size, 1> nearest_on_segment(const Eigen::Matrix<Scalar, size, 1>& from,
                                                  const Eigen::Matrix<Scalar, size, 1>& to,
                                                  const Eigen::Matrix<Scalar, size, 1>& point) {
  const Eigen::Matrix<Scalar, size, 1> edge = to - from;
  const Scalar squared_length = edge.squaredNorm();
  const Scalar along =
      squared_length > 0 ? std::clamp(edge.dot(point - from) / squared_length, Scalar(0), Scalar(1))
                         : Scalar(0);
  return from + along * edge;
}

}  // namespace flinch::motion
