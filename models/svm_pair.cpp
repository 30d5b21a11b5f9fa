// SPDX-License-Identifier: MIT
#include "models/svm_pair.h"

#include <libsvm/svm.h>

#include <cmath>
#include <cstddef>
#include <memory>

#include "models/power.h"

namespace flinch::models {
namespace {

struct ModelDeleter {
  void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
};
using LibsvmModel = std::unique_ptr<svm_model, ModelDeleter>;

/// libsvm tells its progress on stdout, and where to is a setting of the whole process.
void silence_libsvm() {
  static const bool kSilenced = [] {
    svm_set_print_string_function([](const char*) {});
    return true;
  }();
  static_cast<void>(kSilenced);
}

svm_parameter to_libsvm(const SvmParameters& parameters) {
  svm_parameter converted{};
  converted.svm_type = C_SVC;
  converted.kernel_type = parameters.kernel == SvmKernel::polynomial ? POLY : RBF;
  converted.degree = parameters.degree;
  converted.gamma = parameters.gamma;
  converted.coef0 = parameters.coef0;
  converted.C = parameters.cost;
  converted.cache_size = 100;  // MB, taken only as the kernel's columns are
  converted.eps = 1e-3;
  converted.shrinking = 1;
  return converted;
}

/// Rows of libsvm's nodes. Node k of row i is {k, value}; what closes a row is the caller's.
struct Nodes {
  Nodes(std::size_t rows, std::size_t columns) : values(rows * columns), pointers(rows) {
    for (std::size_t row = 0; row < rows; ++row) pointers[row] = &values[row * columns];
  }
  std::vector<svm_node> values;
  std::vector<svm_node*> pointers;
};

std::vector<const double*> rows_of(const PairProblem& problem) {
  std::vector<const double*> rows;
  for (const std::span<const double> points : {problem.first, problem.second}) {
    for (std::size_t at = 0; at < points.size(); at += static_cast<std::size_t>(problem.feature_count))
      rows.push_back(&points[at]);
  }
  return rows;
}

/// The points themselves, closed by index -1.
Nodes nodes_of_points(const PairProblem& problem) {
  const std::vector<const double*> rows = rows_of(problem);
  const auto features = static_cast<std::size_t>(problem.feature_count);
  Nodes nodes(rows.size(), features + 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t f = 0; f < features; ++f)
      nodes.pointers[i][f] = {static_cast<int>(f) + 1, rows[i][f]};
    nodes.pointers[i][features] = {-1, 0};
  }
  return nodes;
}

// K(u, v) as libsvm computes it while it trains: the RBF's squared distance from dot products.
double kernel_of_dot(const SvmParameters& parameters, double dot, double square_u,
                     double square_v) {
  if (parameters.kernel == SvmKernel::polynomial) {
    return power(parameters.gamma * dot + parameters.coef0, parameters.degree);
  }
  return std::exp(-parameters.gamma * (square_u + square_v - 2 * dot));
}

/// Kernel values of all pairs of points as libsvm's precomputed kernels are given: row i is its
/// number, from 1, and then K(i, 1), K(i, 2), …. Each dot product is summed from the first feature
/// to the last, as libsvm sums it; the loop inside runs over points.
Nodes nodes_of_kernel(const PairProblem& problem, const SvmParameters& parameters) {
  const std::vector<const double*> rows = rows_of(problem);
  const std::size_t count = rows.size();
  const auto features = static_cast<std::size_t>(problem.feature_count);
  std::vector<double> columns(features * count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t f = 0; f < features; ++f) columns[f * count + i] = rows[i][f];
  }
  std::vector<double> square(count);
  for (std::size_t f = 0; f < features; ++f) {
    for (std::size_t i = 0; i < count; ++i)
      square[i] += columns[f * count + i] * columns[f * count + i];
  }
  Nodes nodes(count, count + 1);
  std::vector<double> dot(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::fill(dot.begin(), dot.end(), 0.0);
    for (std::size_t f = 0; f < features; ++f) {
      const double x = rows[i][f];
      const double* column = &columns[f * count];
      for (std::size_t j = i; j < count; ++j) dot[j] += x * column[j];
    }
    nodes.pointers[i][0] = {0, static_cast<double>(i + 1)};
    for (std::size_t j = i; j < count; ++j) {
      const double value = kernel_of_dot(parameters, dot[j], square[i], square[j]);
      nodes.pointers[i][j + 1] = {static_cast<int>(j) + 1, value};
      nodes.pointers[j][i + 1] = {static_cast<int>(i) + 1, value};
    }
  }
  return nodes;
}

/// Beyond it libsvm evaluates kernels itself, in less memory: a matrix of this many rows takes
/// 16 MiB.
constexpr std::size_t kMostPrecomputed = 1024;

}  // namespace

PairSolution fit_pair(const PairProblem& problem, const SvmParameters& parameters) {
  silence_libsvm();
  const auto features = static_cast<std::size_t>(problem.feature_count);
  const std::size_t first_count = problem.first.size() / features;
  const std::size_t count = first_count + problem.second.size() / features;
  svm_parameter converted = to_libsvm(parameters);
  const bool is_precomputed = count <= kMostPrecomputed;
  Nodes nodes = is_precomputed ? nodes_of_kernel(problem, parameters) : nodes_of_points(problem);
  if (is_precomputed) converted.kernel_type = PRECOMPUTED;
  std::vector<int> weighted{1, -1};
  std::vector<double> weights{problem.first_weight, problem.second_weight};
  converted.nr_weight = 2;
  converted.weight_label = weighted.data();
  converted.weight = weights.data();
  std::vector<double> labels(count, -1);
  std::fill_n(labels.begin(), first_count, 1.0);
  const svm_problem given{static_cast<int>(count), labels.data(), nodes.pointers.data()};
  const LibsvmModel trained(svm_train(&given, &converted));
  PairSolution solution{std::vector<double>(count), trained->rho[0]};
  for (int vector = 0; vector < trained->l; ++vector) {
    const auto observation = static_cast<std::size_t>(trained->sv_indices[vector] - 1);
    solution.coefficients[observation] = std::abs(trained->sv_coef[0][vector]);
  }
  return solution;
}

}  // namespace flinch::models
