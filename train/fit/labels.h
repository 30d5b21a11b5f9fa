// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "features/feature_vector.h"
#include "models/fit/training_set.h"
#include "train/objective/cost.h"
#include "train/store/store.h"

namespace flinch::train {

/// How a store's impulses and work are weighed.
CostModel make_cost_model(const StoreHeader& header, const Vulnerability& vulnerability,
                          double brawn);

/// What every trial of a store costs, and which clip is best: new ones need no new simulation.
struct Labels {
  std::vector<std::vector<double>> cost;  ///< N·s, one row an observation, one value a trial
  std::vector<int> clip;                  ///< the label: the clip of least cost
};
Labels label(std::span<const Observation> observations, const CostModel& model);

/// Cost of answering observation number `observation` with a clip that was tried on it.
double cost_of_choice(std::span<const Observation> observations, const Labels& labels,
                      std::size_t observation, int clip);

/// The scaling of these observations' features.
features::Scaling scaling_of(const StoreHeader& header, std::span<const Observation> observations);

/// The observations as the models are fitted to them, with the costs of their trials.
models::TrainingSet make_training_set(const StoreHeader& header,
                                      std::span<const Observation> observations,
                                      const Labels& labels, const features::Scaling& scaling);

}  // namespace flinch::train
