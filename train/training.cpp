// SPDX-License-Identifier: MIT
#include "train/training.h"

#include <algorithm>
#include <array>

#include "models/cross_validation.h"
#include "motion/error.h"
#include "train/labels.h"

namespace flinch::train {

namespace {

constexpr std::array<std::string_view, 2> kModelNames{"svm", "knn"};
constexpr int kMostFolds = 5;

template <class Parameters>
void choose(const models::TrainingSet& set, const std::vector<Parameters>& grid,
            std::span<const int> folds, const models::Score& score, Training& training) {
  const auto chosen =
      models::choose_parameters(set, std::span<const Parameters>(grid), folds, score);
  training.parameters = chosen.parameters;
  training.cross_validated_regret_ns = chosen.mean_score;
}

}  // namespace

std::string_view name_of(ModelKind kind) {
  return kModelNames[static_cast<std::size_t>(kind)];
}

std::optional<ModelKind> model_kind_named(std::string_view name) {
  const auto found = std::ranges::find(kModelNames, name);
  if (found == kModelNames.end()) return std::nullopt;
  return static_cast<ModelKind>(found - kModelNames.begin());
}

Training train_selector(const StoreHeader& header, std::span<const Observation> observations,
                        const CostModel& cost_model, ModelKind kind, std::uint64_t seed) {
  if (observations.size() < 2)
    throw Error("", "training needs at least 2 scenarios and there are " +
                        std::to_string(observations.size()) + "; simulate more");
  const Labels labels = label(observations, cost_model);
  Training training;
  models::Selector& selector = training.selector;
  selector.library_hash = header.library_hash;
  selector.clips = header.clips;
  selector.idle = header.idle;
  selector.feature_names.assign(features::kFeatureNames.begin(), features::kFeatureNames.end());
  selector.scaling = scaling_of(observations);
  selector.brawn = cost_model.brawn;
  selector.target_centres = header.idle_target_centres;

  const models::TrainingSet set = make_training_set(header, observations, labels, selector.scaling);
  training.fold_count = std::min(kMostFolds, set.size());
  const std::vector<int> folds = models::make_folds(set.label, training.fold_count, seed);
  const models::Score regret = [&](int observation, int chosen) {
    const auto i = static_cast<std::size_t>(observation);
    return cost_of_choice(observations, labels, i, chosen) -
           cost_of_choice(observations, labels, i, labels.clip[i]);
  };
  if (kind == ModelKind::svm) {
    choose(set, models::svm_grid(set.feature_count), folds, regret, training);
    selector.model = models::fit_svm(set, std::get<models::SvmParameters>(training.parameters));
  } else {
    choose(set, models::knn_grid(), folds, regret, training);
    selector.model = models::fit_knn(set, std::get<models::KnnParameters>(training.parameters));
  }
  return training;
}

}  // namespace flinch::train
