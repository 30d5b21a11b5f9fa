// SPDX-License-Identifier: MIT
#include "sim/tree/box_lcp.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace flinch::sim {
namespace {

constexpr int kMaxStalledPivots = 8;  // block pivots without improvement before single pivots
constexpr int kMaxPivots = 200;
constexpr double kRelativeTolerance = 1e-12;  // relative to a row's own terms

}  // namespace

void BoxLcp::solve_free(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_hand_side,
                        const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                        Eigen::VectorXd& x) {
  free_rows_.clear();
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const BoundState state = states_[static_cast<std::size_t>(i)];
    if (state == BoundState::free) free_rows_.push_back(i);
    x[i] = state == BoundState::lower ? lower[i] : state == BoundState::upper ? upper[i] : 0;
  }
  const auto count = static_cast<Eigen::Index>(free_rows_.size());
  if (count == 0) return;
  free_matrix_.resize(count, count);
  free_solution_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index row = free_rows_[static_cast<std::size_t>(i)];
    free_solution_[i] = right_hand_side[row] - matrix.row(row).dot(x);
    for (Eigen::Index j = 0; j < count; ++j) {
      free_matrix_(i, j) = matrix(row, free_rows_[static_cast<std::size_t>(j)]);
    }
  }
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(free_matrix_).solveInPlace(free_solution_);
  for (Eigen::Index i = 0; i < count; ++i)
    x[free_rows_[static_cast<std::size_t>(i)]] = free_solution_[i];
}

bool BoxLcp::solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_hand_side,
                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, Eigen::VectorXd& x) {
  const Eigen::Index count = right_hand_side.size();
  x.resize(count);
  states_.clear();
  for (Eigen::Index i = 0; i < count; ++i) {
    // A variable with an empty range has a known value; leaving it free would cost a pivot.
    states_.push_back(lower[i] < upper[i] ? BoundState::free : BoundState::lower);
  }
  std::ptrdiff_t min_infeasible = count + 1;
  int stalled_pivots_left = kMaxStalledPivots;
  for (int pivot = 0; pivot < kMaxPivots; ++pivot) {
    solve_free(matrix, right_hand_side, lower, upper, x);
    std::ptrdiff_t infeasible = 0;
    Eigen::Index last = 0;
    BoundState last_state = BoundState::free;
    const bool single = stalled_pivots_left == 0;
    for (Eigen::Index i = 0; i < count; ++i) {
      BoundState& state = states_[static_cast<std::size_t>(i)];
      BoundState wanted = state;
      if (state == BoundState::free) {
        if (x[i] < lower[i]) wanted = BoundState::lower;
        if (x[i] > upper[i]) wanted = BoundState::upper;
      } else if (lower[i] < upper[i]) {
        const double w = matrix.row(i).dot(x) - right_hand_side[i];
        const double slack =
            kRelativeTolerance * (std::abs(right_hand_side[i]) + matrix(i, i) * std::abs(x[i]));
        if (state == BoundState::lower ? w < -slack : w > slack) wanted = BoundState::free;
      }
      if (wanted == state) continue;
      ++infeasible;
      last = i;
      last_state = wanted;
      if (!single) state = wanted;
    }
    if (infeasible == 0) return true;
    if (single) states_[static_cast<std::size_t>(last)] = last_state;
    if (infeasible < min_infeasible) {
      min_infeasible = infeasible;
      stalled_pivots_left = kMaxStalledPivots;
    } else if (stalled_pivots_left > 0) {
      --stalled_pivots_left;
    }
  }
  x = x.cwiseMax(lower).cwiseMin(upper);
  return false;
}

}  // namespace flinch::sim
