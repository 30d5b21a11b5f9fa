// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <memory>

namespace flinch::sim {

/// Memory of a matrix or vector whose size changes from step to step. It only grows, so that steps
/// of sizes that it has met allocate nothing.
class Scratch {
 public:
  using Matrix = Eigen::Map<Eigen::MatrixXd, Eigen::Aligned16>;
  using Vector = Eigen::Map<Eigen::VectorXd, Eigen::Aligned16>;

  explicit Scratch(Eigen::Index reserved) { reserve(reserved); }

  /// Returns a matrix of that size, valid until the next call. Its values are not set.
  Matrix matrix(Eigen::Index rows, Eigen::Index columns) {
    reserve(rows * columns);
    return {values_.get(), rows, columns};
  }
  Vector vector(Eigen::Index size) {
    reserve(size);
    return {values_.get(), size};
  }

 private:
  void reserve(Eigen::Index count) {
    if (count <= capacity_) return;
    capacity_ = std::max(count, 2 * capacity_);
    values_ = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(capacity_));
  }

  std::unique_ptr<double[]> values_;
  Eigen::Index capacity_ = 0;
};

}  // namespace flinch::sim
