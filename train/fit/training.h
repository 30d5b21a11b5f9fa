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
#include "train/objective/cost.h"
#include "train/store/store.h"

namespace flinch::train {

/// A way to learn a selector.
enum class Method : std::uint8_t {
  knn,            ///< the nearest observations vote
  svm,            ///< C-SVC with a polynomial kernel: the paper's
  svm_rbf,        ///< C-SVC with an RBF kernel
  knn_cost,       ///< the nearest observations tell what each clip costs
  network,        ///< small networks expect what each clip costs
  pairwise_cost,  ///< a linear machine for each pair of clips, weighted by what its mistakes cost
};

/// Of the two of least regret on held-out scenarios, one on an authored library and one on motion
/// capture, the one that chooses sooner: docs/selectors.md has the figures.
inline constexpr Method kDefaultMethod = Method::network;

/// As options and `compare`'s rows have it.
std::string_view name_of(Method method);
std::optional<Method> method_named(std::string_view name);
/// All of them, in the order in which they are shown.
std::span<const Method> methods();

/// A parameter that was chosen.
struct NamedValue {
  std::string name;
  std::variant<std::string, int, double> value;
};

/// A selector and how it came about.
struct Training {
  models::Selector selector;
  std::vector<NamedValue> parameter_values;
  std::string parameters;                ///< the same as text: "k 10, vote majority"
  double cross_validated_regret_ns = 0;  ///< mean, of the folds that were not fitted to
};

/// Labels the observations, chooses the method's parameters from its grid by cross-validation with
/// the mean regret as score (folds drawn from `seed`), and fits to all of them. Throws Error for
/// fewer than two observations. The same bits for any number of threads.
Training train_selector(const StoreHeader& header, std::span<const Observation> observations,
                        const CostModel& cost_model, Method method, std::uint64_t seed);

}  // namespace flinch::train
