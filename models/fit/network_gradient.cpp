// SPDX-License-Identifier: MIT
#include "models/fit/network_gradient.h"

namespace flinch::models {
namespace {

using Eigen::MatrixXf;
using Eigen::VectorXf;

/// Views of the weights of each layer, in place; `Matrix` and `Vector` may be const.
template <typename Matrix, typename Vector, typename Number>
struct Layers {
  Eigen::Map<Matrix> first, second, output;  // output's is transposed, by clip
  Eigen::Map<Vector> first_biases, second_biases, output_biases;

  Layers(const NetworkShape& shape, Number* weights)
      : first(weights, shape.hidden_count, shape.feature_count),
        second(weights + shape.second_weights(), shape.hidden_count, shape.hidden_count),
        output(weights + shape.output_weights(), shape.hidden_count, shape.output_count),
        first_biases(weights + shape.first_biases(), shape.hidden_count),
        second_biases(weights + shape.second_biases(), shape.hidden_count),
        output_biases(weights + shape.output_biases(), shape.output_count) {}
};
using Weights = Layers<const MatrixXf, const VectorXf, const float>;
using Gradient = Layers<MatrixXf, VectorXf, float>;

struct Activations {
  MatrixXf first, second, output;
};

Activations forward_pass(const Weights& layers, const MatrixXf& inputs) {
  Activations a;
  a.first = ((layers.first * inputs).colwise() + layers.first_biases).cwiseMax(0.0F);
  a.second = ((layers.second * a.first).colwise() + layers.second_biases).cwiseMax(0.0F);
  a.output = (layers.output.transpose() * a.second).colwise() + layers.output_biases;
  return a;
}

/// Passes errors back through the units whose output was above 0.
MatrixXf relu_gradient(const MatrixXf& errors, const MatrixXf& unit_outputs) {
  return (unit_outputs.array() > 0).select(errors, 0.0F);
}

}  // namespace

// Back-propagation (Rumelhart, Hinton and Williams 1986): computes the derivative of the loss by
// each layer's sums, from the last layer to the first. The derivative by a weight is that of its
// unit's sum times the weight's input.
float network_loss(const NetworkShape& shape, const NetworkBatch& batch, const VectorXf& weights,
                   VectorXf& gradient) {
  const Weights layers(shape, weights.data());
  gradient.resize(weights.size());
  Gradient by(shape, gradient.data());
  const Activations a = forward_pass(layers, batch.inputs);
  const MatrixXf difference = a.output - batch.targets;
  const auto count = static_cast<float>(batch.inputs.cols());
  const MatrixXf output_errors = difference.cwiseProduct(batch.loss_weights) / count;
  by.output.noalias() = a.second * output_errors.transpose();
  by.output_biases = output_errors.rowwise().sum();
  const MatrixXf second_errors = relu_gradient(layers.output * output_errors, a.second);
  by.second.noalias() = second_errors * a.first.transpose();
  by.second_biases = second_errors.rowwise().sum();
  const MatrixXf first_errors = relu_gradient(layers.second.transpose() * second_errors, a.first);
  by.first.noalias() = first_errors * batch.inputs.transpose();
  by.first_biases = first_errors.rowwise().sum();
  return difference.cwiseProduct(output_errors).sum() / 2;
}

MatrixXf network_outputs(const NetworkShape& shape, const MatrixXf& inputs,
                         const VectorXf& weights) {
  return forward_pass(Weights(shape, weights.data()), inputs).output;
}

}  // namespace flinch::models
