// SPDX-License-Identifier: MIT
#include "sim/tree/box_lcp.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <optional>
#include <random>

namespace flinch::sim {
namespace {

/// By trying every choice of rows that are low, high or between.
std::optional<Eigen::VectorXd> by_exhaustion(const Eigen::MatrixXd& matrix,
                                             const Eigen::VectorXd& right,
                                             const Eigen::VectorXd& low,
                                             const Eigen::VectorXd& high) {
  const Eigen::Index count = right.size();
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
      values[i] = place.back() == 0 ? low[i] : place.back() == 1 ? high[i] : right[i];
      finite &= std::isfinite(values[i]);
    }
    if (!finite) continue;
    const Eigen::VectorXd x = equations.fullPivLu().solve(values);
    const Eigen::VectorXd w = matrix * x - right;
    bool holds = true;
    for (Eigen::Index i = 0; i < count; ++i) {
      constexpr double kTiny = 1e-9;
      holds &= x[i] >= low[i] - kTiny && x[i] <= high[i] + kTiny;
      if (low[i] == high[i]) continue;
      if (place[static_cast<std::size_t>(i)] == 0) holds &= w[i] >= -kTiny;
      if (place[static_cast<std::size_t>(i)] == 1) holds &= w[i] <= kTiny;
    }
    if (holds) return x;
  }
  return std::nullopt;
}

TEST(BoxLcp, FindsWhatTryingEveryChoiceFinds) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  BoxLcp lcp;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Index count = 1 + i % 6;
    const Eigen::MatrixXd factor =
        Eigen::MatrixXd::NullaryExpr(count, count, [&] { return uniform(generator); });
    const Eigen::MatrixXd matrix =
        factor * factor.transpose() + 1e-3 * Eigen::MatrixXd::Identity(count, count);
    Eigen::VectorXd right(count);
    Eigen::VectorXd low(count);
    Eigen::VectorXd high(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      right[k] = uniform(generator);
      const bool normal = k % 3 == 0;
      high[k] = normal ? std::numeric_limits<double>::infinity()
                       : std::max(0.0, uniform(generator));  // some bounds have no room
      low[k] = normal ? 0 : -high[k];
    }
    Eigen::VectorXd found;
    ASSERT_TRUE(lcp.solve(matrix, right, low, high, found));
    const auto expected = by_exhaustion(matrix, right, low, high);
    ASSERT_TRUE(expected);
    EXPECT_LT((found - *expected).norm(), 1e-7 * (1 + expected->norm()));
  }
}

}  // namespace
}  // namespace flinch::sim
