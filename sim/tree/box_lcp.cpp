// SPDX-License-Identifier: MIT
#include "sim/tree/box_lcp.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace flinch::sim {
namespace {

constexpr int kPatience = 8;  // block pivots that do not better the best before single ones
constexpr int kMostPivots = 200;
constexpr double kTolerance = 1e-12;  // of a row's own terms

}  // namespace

void BoxLcp::solve_between(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                           const Eigen::VectorXd& low, const Eigen::VectorXd& high,
                           Eigen::VectorXd& x) {
  between_.clear();
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Place place = places_[static_cast<std::size_t>(i)];
    if (place == Place::between) between_.push_back(i);
    x[i] = place == Place::low ? low[i] : place == Place::high ? high[i] : 0;
  }
  const auto count = static_cast<Eigen::Index>(between_.size());
  if (count == 0) return;
  sub_.resize(count, count);
  sub_x_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index row = between_[static_cast<std::size_t>(i)];
    sub_x_[i] = right[row] - matrix.row(row).dot(x);
    for (Eigen::Index j = 0; j < count; ++j) {
      sub_(i, j) = matrix(row, between_[static_cast<std::size_t>(j)]);
    }
  }
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(sub_).solveInPlace(sub_x_);
  for (Eigen::Index i = 0; i < count; ++i) x[between_[static_cast<std::size_t>(i)]] = sub_x_[i];
}

bool BoxLcp::solve(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                   const Eigen::VectorXd& low, const Eigen::VectorXd& high, Eigen::VectorXd& x) {
  const Eigen::Index count = right.size();
  x.resize(count);
  places_.clear();
  for (Eigen::Index i = 0; i < count; ++i) {
    // Without a range there is nothing to find: it costs a pivot to get to where it has to be.
    places_.push_back(low[i] < high[i] ? Place::between : Place::low);
  }
  std::ptrdiff_t fewest = count + 1;
  int patience = kPatience;
  for (int pivot = 0; pivot < kMostPivots; ++pivot) {
    solve_between(matrix, right, low, high, x);
    std::ptrdiff_t wrong = 0;
    Eigen::Index last = 0;
    Place last_place = Place::between;
    const bool single = patience == 0;
    for (Eigen::Index i = 0; i < count; ++i) {
      Place& place = places_[static_cast<std::size_t>(i)];
      Place wanted = place;
      if (place == Place::between) {
        if (x[i] < low[i]) wanted = Place::low;
        if (x[i] > high[i]) wanted = Place::high;
      } else if (low[i] < high[i]) {
        const double w = matrix.row(i).dot(x) - right[i];
        const double slack = kTolerance * (std::abs(right[i]) + matrix(i, i) * std::abs(x[i]));
        if (place == Place::low ? w < -slack : w > slack) wanted = Place::between;
      }
      if (wanted == place) continue;
      ++wrong;
      last = i;
      last_place = wanted;
      if (!single) place = wanted;
    }
    if (wrong == 0) return true;
    if (single) places_[static_cast<std::size_t>(last)] = last_place;
    if (wrong < fewest) {
      fewest = wrong;
      patience = kPatience;
    } else if (patience > 0) {
      --patience;
    }
  }
  x = x.cwiseMax(low).cwiseMin(high);
  return false;
}

}  // namespace flinch::sim
