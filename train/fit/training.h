// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "models/selector.h"
#include "train/fit/fixed_parameters.h"
#include "train/objective/cost.h"
#include "train/store/store.h"

namespace flinch::train {

/// A method of learning a selector.
enum class Method : std::uint8_t {
  knn,            ///< vote of the nearest observations
  svm,            ///< C-SVC with a polynomial kernel, as in the paper
  svm_rbf,        ///< C-SVC with an RBF kernel
  knn_cost,       ///< mean cost of each clip over the nearest observations
  network,        ///< small networks that predict the cost of each clip
  pairwise_cost,  ///< one linear machine per pair of clips, weighted by the cost of its errors
};

/// Two methods had the lowest regret on held-out scenarios, one on an authored library and one on
/// motion capture. This is the one that chooses faster; docs/selectors.md has the figures.
inline constexpr Method kDefaultMethod = Method::network;

/// Returns the method's name in options and in `compare`'s rows.
std::string_view name_of(Method method);
std::optional<Method> method_named(std::string_view name);
/// Returns all methods, in the order in which they are shown.
std::span<const Method> methods();

/// A parameter and its chosen value.
struct NamedValue {
  std::string name;
  std::variant<std::string, int, double> value;
};

/// A selector and how it was trained.
struct Training {
  models::Selector selector;
  std::vector<NamedValue> parameter_values;
  std::string parameters;                ///< the same as text: "k 10, vote majority"
  double cross_validated_regret_ns = 0;  ///< mean over the folds, each held out once
  double idle_regret_ns = 0;             ///< mean of standing still, over all scenarios
};

/// Labels the observations, chooses the parameters that are not fixed from the method's grid by
/// cross-validation with the mean regret as score (folds drawn from `seed`), and fits to all
/// observations. Throws Error for fewer than two observations, and for a fixed parameter that the
/// method does not have or that is out of range. The result is the same to the bit for any number
/// of threads and any order of observations: they are taken in the order of their numbers.
Training train_selector(const StoreHeader& header, std::span<const Observation> observations,
                        const CostModel& cost_model, Method method, std::uint64_t seed,
                        const FixedParameters& fixed = {});

}  // namespace flinch::train
