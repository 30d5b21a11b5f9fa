// SPDX-License-Identifier: MIT
#include "models/fit/svm_pair.h"

#include <libsvm/svm.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>

#include "motion/error.h"

namespace flinch::models {
namespace {

struct ModelDeleter {
  void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
};
using LibsvmModel = std::unique_ptr<svm_model, ModelDeleter>;

/// libsvm prints its progress to stdout; its print function is a setting of the whole process.
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
  converted.cache_size = 100;  // MB, allocated only as the kernel's columns need it
  converted.eps = 1e-3;
  converted.shrinking = 1;
  return converted;
}

/// Rows of libsvm's nodes. Node k of row i is {k, value}; the caller adds the terminator of each
/// row.
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
    for (std::size_t at = 0; at < points.size();
         at += static_cast<std::size_t>(problem.feature_count))
      rows.push_back(&points[at]);
  }
  return rows;
}

/// The points themselves, each terminated by index -1.
Nodes nodes_of(const PairProblem& problem) {
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

}  // namespace

void check(const SvmParameters& parameters) {
  if (!std::isfinite(parameters.gamma + parameters.coef0 + parameters.cost + parameters.balance)) {
    throw Error("", "the SVM's gamma, coef0, C and balance must be finite numbers");
  }
  const svm_parameter converted = to_libsvm(parameters);
  const svm_problem none{};
  if (const char* refusal = svm_check_parameter(&none, &converted)) {
    throw Error("", std::string("the SVM's parameters are invalid: ") + refusal);
  }
}

PairSolution fit_pair(const PairProblem& problem, const SvmParameters& parameters) {
  silence_libsvm();
  const auto features = static_cast<std::size_t>(problem.feature_count);
  const std::size_t first_count = problem.first.size() / features;
  const std::size_t count = first_count + problem.second.size() / features;
  svm_parameter converted = to_libsvm(parameters);
  Nodes nodes = nodes_of(problem);
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
