// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "models/network.h"

namespace flinch::models {

/// Observations that a network is fitted to, one per column.
struct NetworkBatch {
  Eigen::MatrixXf inputs;   ///< feature_count rows
  Eigen::MatrixXf targets;  ///< output_count rows; 0 where the clip was not tried
  Eigen::MatrixXf
      /// 1 / number of clips tried on the observation; 0 where the clip was not tried
      loss_weights;
};

/// Returns the loss of one member network on the batch: the mean over observations of the mean over
/// the tried clips of (output - target)^2 / 2. Sets `gradient` to its derivative by each weight.
/// The order of summation depends only on the shape and the batch size.
float network_loss(const NetworkShape& shape, const NetworkBatch& batch,
                   const Eigen::VectorXf& weights, Eigen::VectorXf& gradient);

/// Returns the outputs of the member network, one column per observation.
Eigen::MatrixXf network_outputs(const NetworkShape& shape, const Eigen::MatrixXf& inputs,
                                const Eigen::VectorXf& weights);

}  // namespace flinch::models
