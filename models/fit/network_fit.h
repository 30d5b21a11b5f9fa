// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "models/fit/kernels.h"
#include "models/fit/training_set.h"
#include "models/network.h"

namespace flinch::models {

/// Parameters of fitting a network.
struct NetworkParameters {
  int hidden_count = 64;  ///< a multiple of kNetworkBlock
  int member_count = 4;
  int epoch_count = 100;  ///< number of passes over the observations
  double weight_decay = 0.1;
  std::uint64_t seed = 1;  ///< of the initial weights and of the order of observations
};

/// Fits the member networks to the set's costs in their units, each from its own initial weights,
/// by AdamW (Loshchilov and Hutter 2019) in batches of 32, with a cosine-annealed step that ends at
/// zero. Members are fitted in parallel by OpenMP; the bits depend neither on the number of threads
/// nor on the kernels. `variance_ns` is measured on the training set and therefore too small.
/// Throws Error for a set that check() rejects, for a set without costs, and for invalid
/// parameters.
NetworkModel fit_network(const TrainingSet& set, const NetworkParameters& parameters,
                         const Kernels& kernels = widest_kernels());

/// Mean of cost - (expected cost - variance_ns), in the observations' units, over the tried clips
/// and the observations: the value of variance_ns with which expected costs are right on average
/// for these observations.
double cost_variance_ns(const NetworkModel& model, const TrainingSet& set);

}  // namespace flinch::models
