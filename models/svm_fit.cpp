// SPDX-License-Identifier: MIT
#include "models/svm_fit.h"

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

/// libsvm tells its progress on stdout, and where to is a setting of the whole process.
void silence_libsvm() {
  static const bool kSilenced = [] {
    svm_set_print_string_function([](const char*) {});
    return true;
  }();
  static_cast<void>(kSilenced);
}

/// Every row of the set as libsvm's nodes, closed by index -1.
std::vector<svm_node> to_nodes(const TrainingSet& set) {
  std::vector<svm_node> nodes;
  nodes.reserve(set.points.size() + set.label.size());
  for (int i = 0; i < set.size(); ++i) {
    int index = 0;
    for (const double value : set.point(i)) {
      nodes.push_back({++index, value});
    }
    nodes.push_back({-1, 0});
  }
  return nodes;
}

svm_parameter to_libsvm(const SvmParameters& parameters) {
  svm_parameter converted{};
  converted.svm_type = C_SVC;
  converted.kernel_type = POLY;
  converted.degree = parameters.degree;
  converted.gamma = parameters.gamma;
  converted.coef0 = parameters.coef0;
  converted.C = parameters.cost;
  converted.cache_size = 100;  // MB, taken only as the kernel's columns are
  converted.eps = 1e-3;
  converted.shrinking = 1;
  return converted;
}

/// A copy without libsvm's memory: its vectors point into the training data.
SvmModel to_model(const svm_model& trained, const SvmParameters& parameters, int feature_count) {
  SvmModel model;
  model.degree = parameters.degree;
  model.gamma = parameters.gamma;
  model.coef0 = parameters.coef0;
  model.cost = parameters.cost;
  model.feature_count = feature_count;
  const int classes = trained.nr_class;
  model.label.assign(trained.label, trained.label + classes);
  model.vectors_of_class.assign(trained.nSV, trained.nSV + classes);
  for (int feature = 0; feature < feature_count; ++feature) {
    for (int vector = 0; vector < trained.l; ++vector) {
      model.support_vectors.push_back(trained.SV[vector][feature].value);
    }
  }
  for (int vector = 0; vector < trained.l; ++vector) {
    for (int machine = 0; machine < classes - 1; ++machine) {
      model.coefficients.push_back(trained.sv_coef[machine][vector]);
    }
  }
  model.rho.assign(trained.rho, trained.rho + classes * (classes - 1) / 2);
  return model;
}

}  // namespace

SvmParameters default_svm_parameters(int feature_count) {
  return {.degree = 3, .gamma = 1.0 / feature_count, .coef0 = 0, .cost = 1};
}

std::vector<SvmParameters> svm_grid(int feature_count) {
  const SvmParameters defaults = default_svm_parameters(feature_count);
  std::vector<SvmParameters> grid{defaults};
  for (const int degree : {2, 3}) {
    for (const double gamma : {defaults.gamma, 4 * defaults.gamma}) {
      for (const double coef0 : {0.0, 1.0}) {
        for (const double cost : {1.0, 10.0, 100.0}) {
          const SvmParameters parameters{degree, gamma, coef0, cost};
          if (parameters != defaults) {
            grid.push_back(parameters);
          }
        }
      }
    }
  }
  return grid;
}

SvmModel fit_svm(const TrainingSet& set, const SvmParameters& parameters) {
  check(set);
  silence_libsvm();
  std::vector<svm_node> nodes = to_nodes(set);
  std::vector<svm_node*> rows;
  for (std::size_t row = 0; row < set.label.size(); ++row) {
    rows.push_back(&nodes[row * static_cast<std::size_t>(set.feature_count + 1)]);
  }
  std::vector<double> labels(set.label.begin(), set.label.end());
  const svm_problem problem{set.size(), labels.data(), rows.data()};
  const svm_parameter converted = to_libsvm(parameters);
  if (!std::isfinite(parameters.gamma + parameters.coef0 + parameters.cost)) {
    throw Error("", "the SVM's gamma, coef0 and C must be finite numbers");
  }
  if (const char* refusal = svm_check_parameter(&problem, &converted)) {
    throw Error("", std::string("the SVM's parameters do not work: ") + refusal);
  }
  const LibsvmModel trained(svm_train(&problem, &converted));
  return to_model(*trained, parameters, set.feature_count);
}

}  // namespace flinch::models
