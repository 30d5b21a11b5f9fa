// SPDX-License-Identifier: MIT
#include "models/fit/network_gradient.h"

#include <algorithm>

namespace flinch::models {
namespace {

using Eigen::MatrixXf;
using Eigen::VectorXf;

std::size_t size_of(Eigen::Index count) {
  return static_cast<std::size_t>(count);
}

/// A layer's weights within a network's. Element (from, to) is at from * from_step + to * to_step.
struct Layer {
  std::size_t in = 0;   ///< number of units, or of features, that it reads
  std::size_t out = 0;  ///< number of units, or of clips, that it computes
  std::size_t weights = 0;
  std::size_t biases = 0;
  std::size_t from_step = 0;
  std::size_t to_step = 0;
};

Layer first_layer(const NetworkShape& shape) {
  return {shape.features(), shape.hidden(), 0, shape.first_biases(), shape.hidden(), 1};
}
Layer second_layer(const NetworkShape& shape) {
  return {shape.hidden(),        shape.hidden(), shape.second_weights(),
          shape.second_biases(), shape.hidden(), 1};
}
Layer output_layer(const NetworkShape& shape) {
  return {shape.hidden(), shape.outputs(), shape.output_weights(), shape.output_biases(), 1,
          shape.hidden()};
}

/// Weighted sums of the inputs: biases + inputs * weights.
MatrixXf sums_of(const Layer& layer, const MatrixXf& inputs, const VectorXf& weights,
                 const Kernels& kernels) {
  MatrixXf sums(inputs.rows(), static_cast<Eigen::Index>(layer.out));
  for (Eigen::Index to = 0; to < sums.cols(); ++to)
    sums.col(to).setConstant(weights[static_cast<Eigen::Index>(layer.biases) + to]);
  kernels.add_product({.rows = size_of(inputs.rows()),
                       .columns = layer.out,
                       .depth = layer.in,
                       .b_row = layer.from_step,
                       .b_column = layer.to_step},
                      inputs.data(), weights.data() + layer.weights, sums.data());
  return sums;
}

/// Derivatives by the inputs of a layer: errors * weights^T, where errors are those by its sums.
MatrixXf errors_before(const Layer& layer, const MatrixXf& errors, const VectorXf& weights,
                       const Kernels& kernels) {
  MatrixXf before = MatrixXf::Zero(errors.rows(), static_cast<Eigen::Index>(layer.in));
  kernels.add_product({.rows = size_of(errors.rows()),
                       .columns = layer.in,
                       .depth = layer.out,
                       .b_row = layer.to_step,
                       .b_column = layer.from_step},
                      errors.data(), weights.data() + layer.weights, before.data());
  return before;
}

/// product += rows^T * columns, where both have one row per observation.
void add_sums_over_observations(const MatrixXf& rows, const MatrixXf& columns, float* product,
                                const Kernels& kernels) {
  const MatrixXf transposed = rows.transpose();
  kernels.add_product({.rows = size_of(transposed.rows()),
                       .columns = size_of(columns.cols()),
                       .depth = size_of(columns.rows()),
                       .b_row = 1,
                       .b_column = size_of(columns.rows())},
                      transposed.data(), columns.data(), product);
}

void add_bias_gradient(const Layer& layer, const MatrixXf& errors, VectorXf& gradient,
                       const Kernels& kernels) {
  const VectorXf ones = VectorXf::Ones(errors.rows());
  for (Eigen::Index to = 0; to < errors.cols(); ++to)
    gradient[static_cast<Eigen::Index>(layer.biases) + to] +=
        kernels.dot(size_of(errors.rows()), errors.col(to).data(), ones.data());
}

/// The outputs of hidden units.
MatrixXf relu(MatrixXf sums) {
  for (float& sum : sums.reshaped()) sum = sum > 0 ? sum : 0;
  return sums;
}

/// Passes errors back through the units whose output was above 0.
MatrixXf relu_gradient(MatrixXf errors, const MatrixXf& unit_outputs) {
  for (Eigen::Index i = 0; i < errors.size(); ++i)
    errors.data()[i] = unit_outputs.data()[i] > 0 ? errors.data()[i] : 0;
  return errors;
}

}  // namespace

// Back-propagation (Rumelhart, Hinton and Williams 1986): computes the derivative of the loss by
// each layer's sums, from the last layer to the first. The derivative by a weight is that of its
// unit's sum times the weight's input.
VectorXf network_gradient(const NetworkShape& shape, const NetworkBatch& batch,
                          const VectorXf& weights, const Kernels& kernels) {
  const Layer to_first = first_layer(shape);
  const Layer to_second = second_layer(shape);
  const Layer to_output = output_layer(shape);
  const MatrixXf first = relu(sums_of(to_first, batch.inputs, weights, kernels));
  const MatrixXf second = relu(sums_of(to_second, first, weights, kernels));
  const MatrixXf output = sums_of(to_output, second, weights, kernels);

  const MatrixXf output_errors = (output - batch.targets).cwiseProduct(batch.loss_weights);
  const MatrixXf second_errors =
      relu_gradient(errors_before(to_output, output_errors, weights, kernels), second);
  const MatrixXf first_errors =
      relu_gradient(errors_before(to_second, second_errors, weights, kernels), first);

  VectorXf gradient = VectorXf::Zero(weights.size());
  add_sums_over_observations(second, output_errors, gradient.data() + to_output.weights, kernels);
  add_sums_over_observations(second_errors, first, gradient.data() + to_second.weights, kernels);
  add_sums_over_observations(first_errors, batch.inputs, gradient.data() + to_first.weights,
                             kernels);
  add_bias_gradient(to_output, output_errors, gradient, kernels);
  add_bias_gradient(to_second, second_errors, gradient, kernels);
  add_bias_gradient(to_first, first_errors, gradient, kernels);
  return gradient;
}

}  // namespace flinch::models
