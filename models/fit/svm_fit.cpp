// SPDX-License-Identifier: MIT
#include "models/fit/svm_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "models/fit/parallel_for.h"
#include "models/fit/svm_pair.h"
#include "models/pair_index.h"
#include "motion/error.h"

namespace flinch::models {
namespace {

/// The observations of one class, in the set's order.
struct Class {
  int label = 0;
  std::vector<double> points;  ///< rows, rounded to floats
  double weight = 1;           ///< factor of C
  std::size_t count = 0;
};

/// Groups observations by class, in ascending order of their clips. libsvm has the class first that
/// appears first, and a tie of votes would then depend on which scenario happens to be the first.
std::vector<Class> classes_of(const TrainingSet& set, double balance) {
  std::map<int, Class> class_of_clip;
  for (int i = 0; i < set.size(); ++i) {
    const int label = set.label[static_cast<std::size_t>(i)];
    Class& one = class_of_clip[label];
    one.label = label;
    for (const double value : set.point(i)) {
      one.points.push_back(static_cast<double>(static_cast<float>(value)));
    }
    ++one.count;
  }
  std::vector<Class> classes;
  for (auto& [label, one] : class_of_clip) classes.push_back(std::move(one));
  for (Class& one : classes) {
    const auto even = static_cast<double>(set.size()) / static_cast<double>(classes.size());
    one.weight = std::pow(even / static_cast<double>(one.count), balance);
  }
  return classes;
}

/// Returns every pair's solution: (0,1), (0,2), …, (1,2), ….
std::vector<PairSolution> solve(const std::vector<Class>& classes, int feature_count,
                                const SvmParameters& parameters) {
  const auto pairs = class_pairs(classes.size());
  std::vector<PairSolution> solutions(pairs.size());
  parallel_for(pairs.size(), [&](std::size_t p) {
    const Class& first = classes[pairs[p].first];
    const Class& second = classes[pairs[p].second];
    solutions[p] = fit_pair(
        {first.points, second.points, feature_count, first.weight, second.weight}, parameters);
  });
  return solutions;
}

/// Returns libsvm's sv_coef for one class's observations, transposed: one row per observation with
/// one value per machine. Rows of zeros are left out; `kept` lists the others.
std::vector<double> coefficients_of(const std::vector<Class>& classes, std::size_t one,
                                    const std::vector<PairSolution>& solutions,
                                    std::vector<std::size_t>& kept) {
  const std::size_t machines = classes.size() - 1;
  std::vector<double> rows(classes[one].count * machines);
  std::size_t pair = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    for (std::size_t j = i + 1; j < classes.size(); ++j, ++pair) {
      if (one != i && one != j) continue;
      const std::size_t begin = one == i ? 0 : classes[i].count;
      const std::size_t machine = one == i ? j - 1 : i;
      for (std::size_t k = 0; k < classes[one].count; ++k) {
        const double a = solutions[pair].coefficients[begin + k];
        rows[k * machines + machine] = one == i ? a : -a;
      }
    }
  }
  std::vector<double> coefficients;
  for (std::size_t k = 0; k < classes[one].count; ++k) {
    const auto row = std::span(rows).subspan(k * machines, machines);
    if (std::ranges::all_of(row, [](double a) { return a == 0; })) continue;
    kept.push_back(k);
    coefficients.insert(coefficients.end(), row.begin(), row.end());
  }
  return coefficients;
}

/// Adds one class's side of a machine: its free vectors, then its bounded ones.
void add_side(SvmModel& model, SvmMachine& machine, std::size_t one, std::size_t column, int side,
              std::span<const double> coefficients) {
  const std::size_t machines = model.label.size() - 1;
  const auto first = static_cast<std::size_t>(model.first_of_class[one]);
  const auto coefficient = [&](std::size_t k) {
    return std::abs(coefficients[(first + k) * machines + column]);
  };
  for (const bool at_bound : {false, true}) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(model.vectors_of_class[one]); ++k) {
      const double a = coefficient(k);
      if (a == 0 || (a == model.bound[one]) != at_bound) continue;
      model.vectors.push_back(static_cast<std::uint16_t>(k));
      if (!at_bound) model.coefficients.push_back(a);
      ++machine.count[static_cast<std::size_t>(2 * side + (at_bound ? 1 : 0))];
    }
  }
}

}  // namespace

SvmParameters default_svm_parameters(int feature_count) {
  return {.degree = 3, .gamma = 1.0 / feature_count, .coef0 = 0, .cost = 1};
}

// In (gamma u.v)^degree, without an offset, changing gamma is the same as changing C: one gamma is
// enough.
std::vector<SvmParameters> svm_grid(int feature_count, SvmKernel kernel) {
  const SvmParameters defaults = default_svm_parameters(feature_count);
  std::vector<SvmParameters> grid;
  const auto add = [&grid](SvmParameters parameters) {
    for (const double cost : {10.0, 100.0, 1000.0}) {
      parameters.cost = cost;
      grid.push_back(parameters);
    }
  };
  if (kernel == SvmKernel::rbf) {
    for (const double factor : {0.25, 1.0, 4.0}) {
      add({.gamma = factor * defaults.gamma, .kernel = kernel});
    }
    return grid;
  }
  grid.push_back(defaults);
  for (const int degree : {2, 3}) {
    add({.degree = degree, .gamma = 4 * defaults.gamma});
    add({.degree = degree, .gamma = defaults.gamma, .coef0 = 1});
    add({.degree = degree, .gamma = 4 * defaults.gamma, .coef0 = 1});
  }
  return grid;
}

SvmModel make_svm_model(const SvmParameters& parameters, std::vector<int> label,
                        std::vector<int> vectors_of_class, std::vector<double> bound,
                        std::span<const double> values, int feature_count,
                        std::span<const double> coefficients, std::span<const double> rho) {
  for (const int count : vectors_of_class) {
    if (count > std::numeric_limits<std::uint16_t>::max()) {
      throw Error("", "one clip has " + std::to_string(count) +
                          " support vectors, more than the 65535 that a kernel SVM can store; "
                          "train on fewer scenarios or with another model");
    }
  }
  SvmModel model;
  model.kernel = parameters.kernel;
  model.degree = parameters.degree;
  model.gamma = parameters.gamma;
  model.coef0 = parameters.coef0;
  model.cost = parameters.cost;
  model.feature_count = feature_count;
  model.label = std::move(label);
  model.vectors_of_class = std::move(vectors_of_class);
  model.bound = std::move(bound);
  const auto features = static_cast<std::size_t>(feature_count);
  const std::size_t vectors = values.size() / features;
  model.support_vectors.resize(vectors * model.row_size());
  for (std::size_t vector = 0; vector < vectors; ++vector) {
    std::ranges::transform(values.subspan(vector * features, features),
                           &model.support_vectors[vector * model.row_size()],
                           [](double value) { return static_cast<float>(value); });
  }
  model.first_of_class.assign(model.label.size(), 0);
  for (std::size_t c = 1; c < model.label.size(); ++c)
    model.first_of_class[c] = model.first_of_class[c - 1] + model.vectors_of_class[c - 1];
  for (std::size_t i = 0; i < model.label.size(); ++i) {
    for (std::size_t j = i + 1; j < model.label.size(); ++j) {
      SvmMachine machine{.rho = rho[model.machines.size()]};
      add_side(model, machine, i, j - 1, 0, coefficients);
      add_side(model, machine, j, i, 1, coefficients);
      model.machines.push_back(machine);
    }
  }
  update_derived(model);
  return model;
}

SvmModel fit_svm(const TrainingSet& set, const SvmParameters& parameters) {
  check(set);
  check(parameters);
  const std::vector<Class> classes = classes_of(set, parameters.balance);
  const std::vector<PairSolution> solutions = solve(classes, set.feature_count, parameters);
  std::vector<int> label;
  std::vector<int> vectors_of_class;
  std::vector<double> bound;
  std::vector<double> values;
  std::vector<double> coefficients;
  const auto features = static_cast<std::size_t>(set.feature_count);
  for (std::size_t c = 0; c < classes.size(); ++c) {
    std::vector<std::size_t> kept;
    const std::vector<double> rows = coefficients_of(classes, c, solutions, kept);
    coefficients.insert(coefficients.end(), rows.begin(), rows.end());
    for (const std::size_t k : kept) {
      const auto point = std::span(classes[c].points).subspan(k * features, features);
      values.insert(values.end(), point.begin(), point.end());
    }
    label.push_back(classes[c].label);
    vectors_of_class.push_back(static_cast<int>(kept.size()));
    bound.push_back(parameters.cost * classes[c].weight);
  }
  std::vector<double> rho;
  for (const PairSolution& solution : solutions) rho.push_back(solution.rho);
  return make_svm_model(parameters, std::move(label), std::move(vectors_of_class), std::move(bound),
                        values, set.feature_count, coefficients, rho);
}

}  // namespace flinch::models
