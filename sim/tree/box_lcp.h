// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/tree/scratch.h"

namespace flinch::sim {

/// Finds x with low <= x <= high and w = A x - b such that w = 0 where x is between its bounds, w
/// >= 0 where it is low and w <= 0 where it is high. For a symmetric positive definite A there is
/// exactly one solution. Uses block principal pivoting, and single pivots where blocks make no
/// progress (Judice and Pires 1994). Reuses its buffers between calls.
class BoxLcp {
 public:
  using ConstMatrix = Eigen::Ref<const Eigen::MatrixXd>;
  using ConstVector = Eigen::Ref<const Eigen::VectorXd>;

  /// Allocates nothing later for problems of up to `reserved_rows`.
  explicit BoxLcp(Eigen::Index reserved_rows = 0);

  /// Returns whether it found the solution. If not, `x` is within its bounds and the best that
  /// pivoting reached. All have the size of `x`.
  bool solve(const ConstMatrix& matrix, const ConstVector& right_hand_side,
             const ConstVector& lower, const ConstVector& upper, Eigen::Ref<Eigen::VectorXd> x);

 private:
  enum class BoundState : signed char { lower = -1, free = 0, upper = 1 };
  void solve_free(const ConstMatrix& matrix, const ConstVector& right_hand_side,
                  const ConstVector& lower, const ConstVector& upper,
                  Eigen::Ref<Eigen::VectorXd> x);

  std::vector<BoundState> states_;
  std::vector<Eigen::Index> free_rows_;
  Scratch free_matrix_;
  Scratch free_solution_;
};

}  // namespace flinch::sim
