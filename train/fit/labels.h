// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "features/feature_vector.h"
#include "models/fit/training_set.h"
#include "train/objective/cost.h"
#include "train/store/store.h"

namespace flinch::train {

/// Returns the cost model for a store's impulses and work.
CostModel make_cost_model(const StoreHeader& header, const VulnerabilityProfile& profile,
                          double brawn);

/// The cost of every trial of a store, and the best clip. Other cost models need no new simulation.
struct Labels {
  std::vector<std::vector<double>> cost;  ///< N·s, one row per observation, one value per trial
  std::vector<int> clip;                  ///< the label: index of the clip with the lowest cost
  /// What costs count by: D* of the threat's kind over that of the first. Empty for one kind.
  std::vector<float> unit;
};
Labels label(std::span<const Observation> observations, const CostModel& model);

/// Returns the cost of responding to observation number `observation` with a clip that was tried on
/// it.
double cost_of_choice(std::span<const Observation> observations, const Labels& labels,
                      std::size_t observation, int clip);

/// Returns the scaling of these observations' features.
features::Scaling scaling_of(const StoreHeader& header, std::span<const Observation> observations);

/// Returns the observations in the form that models are fitted to, with the costs of their trials.
models::TrainingSet make_training_set(const StoreHeader& header,
                                      std::span<const Observation> observations,
                                      const Labels& labels, const features::Scaling& scaling);

}  // namespace flinch::train
