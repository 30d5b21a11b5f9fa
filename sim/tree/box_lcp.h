// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace flinch::sim {

/// Finds x with low <= x <= high and w = A x - b such that w = 0 where x is between its bounds, w
/// >= 0 where it is low and w <= 0 where it is high. For a symmetric positive definite A there is
/// exactly one solution. Uses block principal pivoting, and single pivots where blocks make no
/// progress (Judice and Pires 1994). Reuses its buffers between calls.
class BoxLcp {
 public:
  /// Returns whether it found the solution. If not, `x` is within its bounds and the best that
  /// pivoting reached.
  bool solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_hand_side,
             const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, Eigen::VectorXd& x);

 private:
  enum class BoundState : signed char { lower = -1, free = 0, upper = 1 };
  void solve_free(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_hand_side,
                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, Eigen::VectorXd& x);

  std::vector<BoundState> states_;
  std::vector<Eigen::Index> free_rows_;
  Eigen::MatrixXd free_matrix_;
  Eigen::VectorXd free_solution_;
};

}  // namespace flinch::sim
