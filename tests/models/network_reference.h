// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "models/network.h"

namespace flinch::models {

/// One fully connected layer, computed element by element in double; `weight(to, from)`.
template <typename Weight>
std::vector<double> reference_layer(std::span<const double> in, std::size_t out_count,
                                    const Weight& weight, std::span<const double> biases) {
  std::vector<double> out(biases.begin(), biases.end());
  for (std::size_t to = 0; to < out_count; ++to) {
    for (std::size_t from = 0; from < in.size(); ++from) {
      out[to] += weight(to, from) * in[from];
    }
  }
  return out;
}

/// Returns the outputs of one member network, computed from the definition.
inline std::vector<double> reference_outputs(const NetworkShape& shape,
                                             const std::vector<double>& weights,
                                             const std::vector<double>& x) {
  const std::span all(weights);
  const auto units = [&](std::vector<double> sums) {
    for (double& sum : sums) sum = std::max(sum, 0.0);
    return sums;
  };
  const std::size_t hidden = shape.hidden();
  const auto first = units(reference_layer(
      x, hidden, [&](std::size_t to, std::size_t from) { return weights[from * hidden + to]; },
      all.subspan(shape.first_biases(), hidden)));
  const auto second = units(reference_layer(
      first, hidden,
      [&](std::size_t to, std::size_t from) {
        return weights[shape.second_weights() + from * hidden + to];
      },
      all.subspan(shape.second_biases(), hidden)));
  return reference_layer(
      second, shape.outputs(),
      [&](std::size_t to, std::size_t from) {
        return weights[shape.output_weights() + to * hidden + from];
      },
      all.subspan(shape.output_biases(), shape.outputs()));
}

}  // namespace flinch::models
