// SPDX-License-Identifier: MIT
#include "models/network.h"

#include <Eigen/Core>
#include <algorithm>

namespace flinch::models {
namespace {

using Block = Eigen::Array<float, kNetworkBlock, 1>;
using Half = Eigen::Array<float, kNetworkBlock / 2, 1>;

/// out = max(0, biases + weights in), a block of units at a time. Each unit's sum goes from the
/// first input to the last, whatever instructions the compiler finds.
void hidden_layer(std::span<const float> in, const float* weights, const float* biases,
                  std::span<float> out) {
  for (std::size_t unit = 0; unit < out.size(); unit += kNetworkBlock) {
    Block sum = Eigen::Map<const Block>(biases + unit);
    for (std::size_t i = 0; i < in.size(); ++i) {
      sum += in[i] * Eigen::Map<const Block>(weights + i * out.size() + unit);
    }
    Eigen::Map<Block> answer(&out[unit]);
    answer = sum.max(0.0F);
  }
}

/// The weighted sum of the last hidden layer in eight partial sums, added from the first to the
/// last: the same order everywhere.
float output(std::span<const float> in, const float* weights, float bias) {
  Half partial = Half::Zero();
  for (std::size_t i = 0; i < in.size(); i += static_cast<std::size_t>(partial.size())) {
    partial += Eigen::Map<const Half>(&in[i]) * Eigen::Map<const Half>(weights + i);
  }
  float sum = bias;
  for (const float part : partial) {
    sum += part;
  }
  return sum;
}

}  // namespace

std::pmr::vector<Candidate> expected_costs(const NetworkModel& model,
                                           std::span<const double> scaled,
                                           const ClipMask& allowed_clips, MemoryResource memory) {
  const NetworkShape shape = model.shape();
  std::pmr::vector<std::size_t> outputs(memory);
  outputs.reserve(model.clip.size());
  for (std::size_t i = 0; i < model.clip.size(); ++i) {
    if (allowed_clips[static_cast<std::size_t>(model.clip[i])]) {
      outputs.push_back(i);
    }
  }
  std::pmr::vector<float> inputs(shape.features(), memory);
  std::transform(scaled.begin(), scaled.end(), inputs.begin(), network_input);
  std::pmr::vector<float> first(shape.hidden(), memory);
  std::pmr::vector<float> second(shape.hidden(), memory);
  std::pmr::vector<float> sums(outputs.size(), memory);
  for (int member = 0; member < model.member_count; ++member) {
    const float* weights =
        model.weights.data() + static_cast<std::size_t>(member) * shape.weight_count();
    hidden_layer(inputs, weights, weights + shape.first_biases(), first);
    hidden_layer(first, weights + shape.second_weights(), weights + shape.second_biases(), second);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      sums[i] += output(second, weights + shape.output_weights() + outputs[i] * shape.hidden(),
                        weights[shape.output_biases() + outputs[i]]);
    }
  }
  struct Root {
    float root;
    int clip;
  };
  std::pmr::vector<Root> roots(memory);
  roots.reserve(outputs.size());
  const float scale = model.scale_root / static_cast<float>(model.member_count);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    roots.push_back({model.mean_root + scale * sums[i], model.clip[outputs[i]]});
  }
  // By the root, which still tells apart what is expected to cost nothing or less.
  std::sort(roots.begin(), roots.end(), [](const Root& a, const Root& b) {
    return a.root != b.root ? a.root < b.root : a.clip < b.clip;
  });
  std::pmr::vector<Candidate> candidates(memory);
  candidates.reserve(roots.size());
  for (const Root& each : roots) {
    const float root = std::max(each.root, 0.0F);
    candidates.push_back({each.clip, 0, root * root + model.variance_ns});
  }
  return candidates;
}

}  // namespace flinch::models
