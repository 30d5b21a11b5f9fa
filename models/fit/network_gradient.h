// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "models/fit/kernels.h"
#include "models/network.h"

namespace flinch::models {

/// Observations that a network is fitted to, one per row. The number of rows is a multiple of
/// kKernelBlock; rows of zeros fill the last block.
struct NetworkBatch {
  Eigen::MatrixXf inputs;        ///< feature_count columns
  Eigen::MatrixXf targets;       ///< output_count columns; 0 where the clip was not tried
  Eigen::MatrixXf loss_weights;  ///< output_count columns; 0 where the clip was not tried
};

/// Returns the derivative by each weight of the batch's loss: the sum over observations and clips
/// of loss weight times (output - target)^2 / 2. Its bits depend neither on the kernels nor on the
/// processor.
Eigen::VectorXf network_gradient(const NetworkShape& shape, const NetworkBatch& batch,
                                 const Eigen::VectorXf& weights, const Kernels& kernels);

}  // namespace flinch::models
