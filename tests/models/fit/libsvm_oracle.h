// SPDX-License-Identifier: MIT
#pragma once

#include <libsvm/svm.h>

#include <cmath>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "models/fit/svm_fit.h"
#include "models/fit/training_set.h"
#include "tests/models/training_sets.h"

namespace flinch::models {

/// libsvm itself, trained and queried without any of our code. Its classes are in ascending order.
class LibsvmOracle {
 public:
  LibsvmOracle(const TrainingSet& unsorted, const SvmParameters& parameters) {
    const TrainingSet set = sorted_by_label(unsorted);
    svm_set_print_string_function([](const char*) {});
    for (int i = 0; i < set.size(); ++i) {
      rows_.push_back(sparse(set.point(i)));
    }
    std::vector<svm_node*> pointers;
    for (std::vector<svm_node>& row : rows_) {
      pointers.push_back(row.data());
    }
    std::vector<double> labels(set.label.begin(), set.label.end());
    const svm_problem problem{set.size(), labels.data(), pointers.data()};
    svm_parameter converted{};
    converted.svm_type = C_SVC;
    converted.kernel_type = parameters.kernel == SvmKernel::polynomial ? POLY : RBF;
    converted.degree = parameters.degree;
    converted.gamma = parameters.gamma;
    converted.coef0 = parameters.coef0;
    converted.C = parameters.cost;
    converted.cache_size = 100;
    converted.eps = 0.001;
    converted.shrinking = 1;
    weigh(set, parameters.balance);
    converted.nr_weight = static_cast<int>(weights_.size());
    converted.weight_label = weighted_.data();
    converted.weight = weights_.data();
    model_.reset(svm_train(&problem, &converted));
  }

  const svm_model& model() const { return *model_; }

  int predict(std::span<const double> point) const {
    return static_cast<int>(svm_predict(model_.get(), sparse(point).data()));
  }

  /// Returns the decision values of the pairs of classes (0,1), (0,2), …, (1,2), ….
  std::vector<double> decisions(std::span<const double> point) const {
    const auto classes = static_cast<std::size_t>(model_->nr_class);
    std::vector<double> decision(classes * (classes - 1) / 2 + 1);
    svm_predict_values(model_.get(), sparse(point).data(), decision.data());
    return decision;
  }

  /// Counts votes of the pairwise machines whose two classes are both allowed, by libsvm's decision
  /// values.
  std::vector<int> votes(std::span<const double> point, std::span<const char> allowed) const {
    const auto classes = static_cast<std::size_t>(model_->nr_class);
    const std::vector<double> decision = decisions(point);
    std::vector<int> votes(classes);
    std::size_t pair = 0;
    for (std::size_t i = 0; i < classes; ++i) {
      for (std::size_t j = i + 1; j < classes; ++j) {
        const bool first = decision[pair++] > 0;
        if (allowed[i] && allowed[j]) {
          votes[first ? i : j] += 1;
        }
      }
    }
    return votes;
  }

 private:
  /// Sets the factor of C for each label.
  void weigh(const TrainingSet& set, double balance) {
    std::map<int, int> count_of;
    for (const int label : set.label) ++count_of[label];
    for (const auto& [label, count] : count_of) {
      const double even = set.size() / static_cast<double>(count_of.size());
      weighted_.push_back(label);
      weights_.push_back(std::pow(even / count, balance));
    }
  }

  struct Deleter {
    void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
  };

  /// Leaves out zeros, like libsvm's text format.
  static std::vector<svm_node> sparse(std::span<const double> point) {
    std::vector<svm_node> nodes;
    for (std::size_t i = 0; i < point.size(); ++i) {
      if (point[i] != 0) {
        nodes.push_back({static_cast<int>(i) + 1, point[i]});
      }
    }
    nodes.push_back({-1, 0});
    return nodes;
  }

  std::vector<std::vector<svm_node>> rows_;
  std::vector<int> weighted_;
  std::vector<double> weights_;
  std::unique_ptr<svm_model, Deleter> model_;
};

}  // namespace flinch::models
