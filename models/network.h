// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "models/candidate.h"
#include "models/clip_mask.h"

namespace flinch::models {

/// The sizes of one member of a NetworkModel, and where its weights stand in its block: of each
/// layer the weights and then the biases. A hidden layer's weights go by the unit that they come
/// from, the output's by the clip that they go to.
struct NetworkShape {
  int feature_count = 0;
  int hidden_count = 0;  ///< of units in either hidden layer; a multiple of kNetworkBlock
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

/// How many units are computed at once.
inline constexpr int kNetworkBlock = 16;

/// No weight is larger: whatever the file, whatever the threat, every sum stays finite.
inline constexpr float kMostNetworkWeight = 1e4F;

/// What every clip is expected to cost, by a few small networks (two hidden layers of rectified
/// units) whose answers are averaged. They answer with the square root of the cost, standardised:
/// costs differ by orders of magnitude, and it is among the small ones that the choice is made.
struct NetworkModel {
  int feature_count = 0;
  int hidden_count = 0;
  int member_count = 0;
  std::vector<int> clip;  ///< clip index of each output, rising
  float mean_root = 0;    ///< of the square roots of the costs, N·s
  float scale_root = 1;   ///< their standard deviation
  float variance_ns = 0;  ///< by which the mean of a cost is above the square of its root's mean
  std::vector<float> weights;  ///< the members' blocks, one after another

  NetworkShape shape() const {
    return {feature_count, hidden_count, static_cast<int>(clip.size())};
  }
};

/// Scaled features as the networks take them: far beyond what they were fitted to, [-1, 1], nothing
/// is known, so nothing goes beyond [-2, 2].
inline float network_input(double scaled) {
  // Not std::clamp, which lets through what is not a number.
  return scaled > -2 ? (scaled < 2 ? static_cast<float>(scaled) : 2.0F) : -2.0F;
}

/// The first `most` of the allowed clips that the model knows, by rising expected cost; ties by the
/// lower index.
/// `scaled` has feature_count values.
std::pmr::vector<Candidate> expected_costs(const NetworkModel& model,
                                           std::span<const double> scaled,
                                           const ClipMask& allowed_clips,
                                           Memory memory = std::pmr::get_default_resource(),
                                           std::size_t most = kAll);

}  // namespace flinch::models
