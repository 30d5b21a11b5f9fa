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

BoxLcp::BoxLcp(Eigen::Index reserved_rows)
    : free_matrix_(reserved_rows * reserved_rows), free_solution_(reserved_rows) {
  states_.reserve(static_cast<std::size_t>(reserved_rows));
  free_rows_.reserve(static_cast<std::size_t>(reserved_rows));
}

void BoxLcp::solve_free(const ConstMatrix& matrix, const ConstVector& right_hand_side,
                        const ConstVector& lower, const ConstVector& upper,
                        Eigen::Ref<Eigen::VectorXd> x) {
  free_rows_.clear();
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const BoundState state = states_[static_cast<std::size_t>(i)];
    if (state == BoundState::free) free_rows_.push_back(i);
    x[i] = state == BoundState::lower ? lower[i] : state == BoundState::upper ? upper[i] : 0;
  }
  const auto count = static_cast<Eigen::Index>(free_rows_.size());
  if (count == 0) return;
  Scratch::Matrix free_matrix = free_matrix_.matrix(count, count);
  Scratch::Vector free_solution = free_solution_.vector(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index row = free_rows_[static_cast<std::size_t>(i)];
    free_solution[i] = right_hand_side[row] - matrix.row(row).dot(x);
    for (Eigen::Index j = 0; j < count; ++j) {
      free_matrix(i, j) = matrix(row, free_rows_[static_cast<std::size_t>(j)]);
    }
  }
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(free_matrix).solveInPlace(free_solution);
  for (Eigen::Index i = 0; i < count; ++i)
    x[free_rows_[static_cast<std::size_t>(i)]] = free_solution[i];
}

bool BoxLcp::solve(const ConstMatrix& matrix, const ConstVector& right_hand_side,
                   const ConstVector& lower, const ConstVector& upper,
                   Eigen::Ref<Eigen::VectorXd> x) {
  const Eigen::Index count = x.size();
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
