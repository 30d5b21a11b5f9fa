// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "models/network.h"

namespace flinch::models {

/// Observations that a network is fitted to, one a column.
struct NetworkBatch {
  Eigen::MatrixXf inputs;   ///< feature_count rows
  Eigen::MatrixXf targets;  ///< output_count rows; 0 where the clip was not tried
  Eigen::MatrixXf
      loss_weights;  ///< 1 / number of clips tried on the observation, or 0 where it was not
};

/// The loss of one member on the batch, the mean over observations of the mean over the clips tried
/// of (answer - target)^2 / 2, and in `gradient` its derivative by each of the member's weights.
/// Sums go in an order that depends on the shape and the batch's size alone.
float network_loss(const NetworkShape& shape, const NetworkBatch& batch,
                   const Eigen::VectorXf& weights, Eigen::VectorXf& gradient);

/// What the member answers, one column an observation.
Eigen::MatrixXf network_outputs(const NetworkShape& shape, const Eigen::MatrixXf& inputs,
                                const Eigen::VectorXf& weights);

}  // namespace flinch::models
