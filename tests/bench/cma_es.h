// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <Eigen/Eigenvalues>

#include "features/random.h"

namespace flinch::bench {

/// The covariance matrix adaptation evolution strategy in the unit cube, with the default
/// parameters of Hansen (2016), "The CMA evolution strategy: a tutorial", equations 5 to 58, and a
/// first step of 0.3. Beyond its faces the cube is mirrored. What evolve's genetic algorithm is
/// compared with.
class CmaEs {
 public:
  CmaEs(int dimensions, int population, std::uint64_t seed)
      : n_(dimensions),
        lambda_(population),
        mu_(population / 2),
        random_(seed, features::RandomStream::fitting, 0),
        mean_(Eigen::VectorXd::Constant(dimensions, 0.5)),
        path_c_(Eigen::VectorXd::Zero(dimensions)),
        path_s_(Eigen::VectorXd::Zero(dimensions)),
        covariance_(Eigen::MatrixXd::Identity(dimensions, dimensions)) {
    weights_.resize(mu_);
    for (int i = 0; i < mu_; ++i) weights_[i] = std::log((lambda_ + 1) / 2.0) - std::log(i + 1.0);
    weights_ /= weights_.sum();
    mu_effective_ = 1 / weights_.squaredNorm();
    const double n = n_;
    c_s_ = (mu_effective_ + 2) / (n + mu_effective_ + 5);
    d_s_ = 1 + 2 * std::max(0.0, std::sqrt((mu_effective_ - 1) / (n + 1)) - 1) + c_s_;
    c_c_ = (4 + mu_effective_ / n) / (n + 4 + 2 * mu_effective_ / n);
    c_1_ = 2 / ((n + 1.3) * (n + 1.3) + mu_effective_);
    c_mu_ = std::min(1 - c_1_, 2 * (mu_effective_ - 2 + 1 / mu_effective_) /
                                   ((n + 2) * (n + 2) + mu_effective_));
    expected_norm_ = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
  }

  /// Draws the points of the next generation, in the cube.
  std::vector<Eigen::VectorXd> ask() {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance_);
    axes_ = solver.eigenvectors();
    lengths_ = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
    steps_.clear();
    std::vector<Eigen::VectorXd> points;
    for (int k = 0; k < lambda_; ++k) {
      Eigen::VectorXd z(n_);
      for (int i = 0; i < n_; ++i) z[i] = random_.normal();
      steps_.push_back(axes_ * lengths_.cwiseProduct(z));
      points.push_back((mean_ + sigma_ * steps_.back()).unaryExpr(&CmaEs::mirrored_into_unit));
    }
    return points;
  }

  /// Takes the fitness of these points; less is better.
  void tell(const std::vector<double>& fitness) {
    std::vector<std::size_t> order(fitness.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return fitness[i]; });
    Eigen::VectorXd step = Eigen::VectorXd::Zero(n_);
    for (int i = 0; i < mu_; ++i) step += weights_[i] * best(order, i);
    mean_ += sigma_ * step;
    path_s_ = (1 - c_s_) * path_s_ + std::sqrt(c_s_ * (2 - c_s_) * mu_effective_) * whitened(step);
    ++generation_;
    const double bias = 1 - std::pow(1 - c_s_, 2 * generation_);
    const bool is_short =
        path_s_.norm() / std::sqrt(bias) < (1.4 + 2.0 / (n_ + 1)) * expected_norm_;
    path_c_ *= 1 - c_c_;
    if (is_short) path_c_ += std::sqrt(c_c_ * (2 - c_c_) * mu_effective_) * step;
    const double lost = is_short ? 0 : c_1_ * c_c_ * (2 - c_c_);
    covariance_ *= 1 - c_1_ - c_mu_ + lost;
    covariance_ += c_1_ * path_c_ * path_c_.transpose();
    for (int i = 0; i < mu_; ++i)
      covariance_ += c_mu_ * weights_[i] * best(order, i) * best(order, i).transpose();
    sigma_ *= std::exp(c_s_ / d_s_ * (path_s_.norm() / expected_norm_ - 1));
  }

 private:
  static double mirrored_into_unit(double x) {
    const double in_two = x - 2 * std::floor(x / 2);
    return in_two > 1 ? 2 - in_two : in_two;
  }
  const Eigen::VectorXd& best(const std::vector<std::size_t>& order, int rank) const {
    return steps_[order[static_cast<std::size_t>(rank)]];
  }
  /// C^(-1/2) times a step.
  Eigen::VectorXd whitened(const Eigen::VectorXd& step) const {
    return axes_ * lengths_.cwiseMax(1e-12).cwiseInverse().cwiseProduct(axes_.transpose() * step);
  }

  int n_, lambda_, mu_;
  features::Random random_;
  Eigen::VectorXd weights_, mean_, path_c_, path_s_, lengths_;
  Eigen::MatrixXd covariance_, axes_;
  std::vector<Eigen::VectorXd> steps_;
  double mu_effective_ = 1, c_s_ = 0, d_s_ = 1, c_c_ = 0, c_1_ = 0, c_mu_ = 0, expected_norm_ = 1;
  double sigma_ = 0.3;
  int generation_ = 0;
};

}  // namespace flinch::bench
