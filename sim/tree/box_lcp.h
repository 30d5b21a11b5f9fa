// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace flinch::sim {

/// Finds x with low <= x <= high and w = A x - b such that w = 0 where x is between its bounds,
/// w >= 0 where it is low and w <= 0 where it is high: for a symmetric positive definite A there is
/// exactly one. By block principal pivoting, one row at a time where blocks do not get on (Judice
/// and Pires 1994). Its buffers are kept from call to call.
class BoxLcp {
 public:
  /// Whether it was found; if not, `x` is within its bounds and as near as pivoting came.
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
