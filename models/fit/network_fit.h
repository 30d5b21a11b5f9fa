// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "models/fit/training_set.h"
#include "models/network.h"

namespace flinch::models {

/// What a network is fitted with.
struct NetworkParameters {
  int hidden_count = 64;  ///< a multiple of kNetworkBlock
  int member_count = 4;
  int epoch_count = 100;  ///< how often every observation is seen
  double weight_decay = 0.1;
  std::uint64_t seed = 1;  ///< of the first weights and of the order of observations
};

/// Fits the members to the costs that the set has, each from its own first weights, by AdamW
/// (Loshchilov and Hutter 2019) in batches of 32 with a step that falls to nothing along a cosine.
/// Members are fitted in parallel by OpenMP; the bits do not depend on the number of threads. What
/// `variance_ns` becomes is measured on the set itself and so too small. Throws Error for what
/// check() refuses, for a set without costs, and for parameters that do not work.
NetworkModel fit_network(const TrainingSet& set, const NetworkParameters& parameters);

/// Mean over the tried clips and the observations of cost - (expected cost - variance_ns): what
/// variance_ns ought to be for the expected costs of these observations to be right on the whole.
double cost_variance_ns(const NetworkModel& model, const TrainingSet& set);

}  // namespace flinch::models
