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
  bool solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
             const Eigen::VectorXd& low, const Eigen::VectorXd& high, Eigen::VectorXd& x);

 private:
  enum class Place : signed char { low = -1, between = 0, high = 1 };
  void solve_between(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                     const Eigen::VectorXd& low, const Eigen::VectorXd& high, Eigen::VectorXd& x);

  std::vector<Place> places_;
  std::vector<Eigen::Index> between_;
  Eigen::MatrixXd sub_;
  Eigen::VectorXd sub_x_;
};

}  // namespace flinch::sim
