// SPDX-License-Identifier: MIT
#include "sim/tree/box_lcp.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <optional>
#include <random>

namespace flinch::sim {
namespace {

/// Solves by trying every choice of rows that are low, high or between.
std::optional<Eigen::VectorXd> by_exhaustion(const Eigen::MatrixXd& matrix,
                                             const Eigen::VectorXd& right_hand_side,
                                             const Eigen::VectorXd& lower,
                                             const Eigen::VectorXd& upper) {
  const Eigen::Index count = right_hand_side.size();
  const auto choices = static_cast<int>(std::lround(std::pow(3, count)));
  for (int choice = 0; choice < choices; ++choice) {
    Eigen::MatrixXd equations = Eigen::MatrixXd::Identity(count, count);
    Eigen::VectorXd values(count);
    std::vector<int> place;
    int rest = choice;
    bool finite = true;
    for (Eigen::Index i = 0; i < count; ++i, rest /= 3) {
      place.push_back(rest % 3);
      if (place.back() == 2) equations.row(i) = matrix.row(i);
      values[i] = place.back() == 0 ? lower[i] : place.back() == 1 ? upper[i] : right_hand_side[i];
      finite &= std::isfinite(values[i]);
    }
    if (!finite) continue;
    const Eigen::VectorXd x = equations.fullPivLu().solve(values);
    const Eigen::VectorXd w = matrix * x - right_hand_side;
    bool holds = true;
    for (Eigen::Index i = 0; i < count; ++i) {
      constexpr double kTiny = 1e-9;
      holds &= x[i] >= lower[i] - kTiny && x[i] <= upper[i] + kTiny;
      if (lower[i] == upper[i]) continue;
      if (place[static_cast<std::size_t>(i)] == 0) holds &= w[i] >= -kTiny;
      if (place[static_cast<std::size_t>(i)] == 1) holds &= w[i] <= kTiny;
    }
    if (holds) return x;
  }
  return std::nullopt;
}

TEST(BoxLcp, MatchesBruteForce) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  BoxLcp lcp;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Index count = 1 + i % 6;
    const Eigen::MatrixXd factor =
        Eigen::MatrixXd::NullaryExpr(count, count, [&] { return uniform(generator); });
    const Eigen::MatrixXd matrix =
        factor * factor.transpose() + 1e-3 * Eigen::MatrixXd::Identity(count, count);
    Eigen::VectorXd right_hand_side(count);
    Eigen::VectorXd lower(count);
    Eigen::VectorXd upper(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      right_hand_side[k] = uniform(generator);
      const bool normal = k % 3 == 0;
      upper[k] = normal ? std::numeric_limits<double>::infinity()
                        : std::max(0.0, uniform(generator));  // some bounds are equal
      lower[k] = normal ? 0 : -upper[k];
    }
    Eigen::VectorXd found(count);
    ASSERT_TRUE(lcp.solve(matrix, right_hand_side, lower, upper, found));
    const auto expected = by_exhaustion(matrix, right_hand_side, lower, upper);
    ASSERT_TRUE(expected);
    EXPECT_LT((found - *expected).norm(), 1e-7 * (1 + expected->norm()));
  }
}

}  // namespace
}  // namespace flinch::sim
