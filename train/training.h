// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "models/knn_fit.h"
#include "models/selector.h"
#include "models/svm_fit.h"
#include "train/cost.h"
#include "train/store.h"

namespace flinch::train {

enum class ModelKind : std::uint8_t { svm, knn };
std::string_view name_of(ModelKind kind);
std::optional<ModelKind> model_kind_named(std::string_view name);

/// A selector and how it came about.
struct Training {
  models::Selector selector;
  std::variant<models::SvmParameters, models::KnnParameters> parameters;
  double cross_validated_regret_ns = 0;  ///< mean, of the folds that were not fitted to
  int fold_count = 0;
};

/// Labels the observations, chooses the model's parameters from its grid by cross-validation with
/// the mean regret as score (folds drawn from `seed`), and fits to all of them. Throws Error for
/// fewer than two observations. The same bits for any number of threads.
Training train_selector(const StoreHeader& header, std::span<const Observation> observations,
                        const CostModel& cost_model, ModelKind kind, std::uint64_t seed);

}  // namespace flinch::train
