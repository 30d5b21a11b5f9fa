// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "models/candidate.h"
#include "models/clip_mask.h"

namespace flinch::models {

/// Sizes of one member network of a NetworkModel, and the layout of its block of weights: for each
/// layer the weights, then the biases. A hidden layer's weights are ordered by input unit, those of
/// the output layer by clip.
struct NetworkShape {
  int feature_count = 0;
  int hidden_count = 0;  ///< units in each hidden layer; a multiple of kNetworkBlock
  int output_count = 0;

  std::size_t features() const { return static_cast<std::size_t>(feature_count); }
  std::size_t hidden() const { return static_cast<std::size_t>(hidden_count); }
  std::size_t outputs() const { return static_cast<std::size_t>(output_count); }
  std::size_t first_biases() const { return features() * hidden(); }
  std::size_t second_weights() const { return first_biases() + hidden(); }
  std::size_t second_biases() const { return second_weights() + hidden() * hidden(); }
  std::size_t output_weights() const { return second_biases() + hidden(); }
  std::size_t output_biases() const { return output_weights() + outputs() * hidden(); }
  std::size_t weight_count() const { return output_biases() + outputs(); }
};

/// Number of units that are computed at once.
inline constexpr int kNetworkBlock = 16;

/// Largest absolute weight. With this limit every sum is finite, for any file and any threat.
inline constexpr float kMaxNetworkWeight = 1e4F;

/// Predicts the cost of every clip with a few small networks (two hidden layers of rectified units)
/// whose outputs are averaged. They predict the standardised square root of the cost: costs differ
/// by orders of magnitude, and the choice is made among the small ones. Costs are in the unit of
/// the threat's kind, D* over that of the first kind: so errors weigh alike for every kind.
struct NetworkModel {
  int feature_count = 0;
  int hidden_count = 0;
  int member_count = 0;
  std::vector<int> clip;  ///< clip index of each output, ascending
  float mean_root = 0;    ///< mean square root of the costs; of the first kind, in N·s
  float scale_root = 1;   ///< standard deviation of the square roots
  float variance_ns = 0;  ///< by how much a mean cost exceeds the square of its mean square root
  std::vector<float> weights;  ///< the members' blocks, one after another

  NetworkShape shape() const {
    return {feature_count, hidden_count, static_cast<int>(clip.size())};
  }
};

/// Converts a scaled feature for the networks. They were fitted in [-1, 1] and are unreliable far
/// outside, so values are clamped to [-2, 2].
inline float network_input(double scaled) {
  // Not std::clamp, which lets NaN through.
  return scaled > -2 ? (scaled < 2 ? static_cast<float>(scaled) : 2.0F) : -2.0F;
}

/// Returns the allowed clips that the model knows, sorted by ascending expected cost, ties by the
/// lower index; at most the first `max_count`. Costs are in the unit of the threat's kind. `scaled`
/// has feature_count values.
std::pmr::vector<Candidate> expected_costs(const NetworkModel& model,
                                           std::span<const double> scaled,
                                           const ClipMask& allowed_clips,
                                           MemoryResource memory = std::pmr::get_default_resource(),
                                           std::size_t max_count = kNoLimit);

}  // namespace flinch::models
