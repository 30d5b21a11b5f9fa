// SPDX-License-Identifier: MIT
#include "models/network.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>

namespace flinch::models {
namespace {

using Half = Eigen::Array<float, kNetworkBlock / 2, 1>;

/// `count` units of out = max(0, biases + weights in). Each unit's sum goes from the first input to
/// the last, whatever instructions the compiler finds. `stride` is from an input's weights to the
/// next one's.
template <int count>
void hidden_units(std::span<const float> in, const float* weights, std::size_t stride,
                  const float* biases, float* out) {
  using Block = Eigen::Array<float, count, 1>;
  Block sum = Eigen::Map<const Block>(biases);
  for (std::size_t i = 0; i < in.size(); ++i) {
    sum += in[i] * Eigen::Map<const Block>(weights + i * stride);
  }
  Eigen::Map<Block> answer(out);
  answer = sum.max(0.0F);
}

/// Two blocks at once, so that one's sums need not wait for the other's.
void hidden_layer(std::span<const float> in, const float* weights, const float* biases,
                  std::span<float> out) {
  std::size_t unit = 0;
  for (; unit + 2 * kNetworkBlock <= out.size(); unit += 2 * kNetworkBlock) {
    hidden_units<2 * kNetworkBlock>(in, weights + unit, out.size(), biases + unit, &out[unit]);
  }
  if (unit < out.size()) {
    hidden_units<kNetworkBlock>(in, weights + unit, out.size(), biases + unit, &out[unit]);
  }
}

/// Adds `count` outputs to their sums: each the weighted sum of the last hidden layer in eight
/// partial sums, added from the first to the last, the same order everywhere. `which` are theirs.
template <std::size_t count>
void add_outputs(std::span<const float> in, const float* weights, const float* biases,
                 const std::size_t* which, float* sums) {
  std::array<Half, count> partial;
  partial.fill(Half::Zero());
  for (std::size_t i = 0; i < in.size(); i += static_cast<std::size_t>(Half::SizeAtCompileTime)) {
    const Half part = Eigen::Map<const Half>(&in[i]);
    for (std::size_t k = 0; k < count; ++k) {
      partial[k] += part * Eigen::Map<const Half>(weights + which[k] * in.size() + i);
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    float sum = biases[which[k]];
    for (const float part : partial[k]) {
      sum += part;
    }
    sums[k] += sum;
  }
}

/// Four at once, as above.
void add_outputs(std::span<const float> in, const float* weights, const float* biases,
                 std::span<const std::size_t> which, std::span<float> sums) {
  std::size_t i = 0;
  for (; i + 4 <= which.size(); i += 4) add_outputs<4>(in, weights, biases, &which[i], &sums[i]);
  for (; i < which.size(); ++i) add_outputs<1>(in, weights, biases, &which[i], &sums[i]);
}

}  // namespace

std::pmr::vector<Candidate> expected_costs(const NetworkModel& model,
                                           std::span<const double> scaled,
                                           const ClipMask& allowed_clips, Memory memory,
                                           std::size_t most) {
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
    add_outputs(second, weights + shape.output_weights(), weights + shape.output_biases(), outputs,
                sums);
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
  const std::size_t count = std::min(most, roots.size());
  // By the root, which still tells apart what is expected to cost nothing or less.
  std::partial_sort(roots.begin(), roots.begin() + static_cast<std::ptrdiff_t>(count), roots.end(),
                    [](const Root& a, const Root& b) {
                      return a.root != b.root ? a.root < b.root : a.clip < b.clip;
                    });
  std::pmr::vector<Candidate> candidates(memory);
  candidates.reserve(count);
  for (const Root& each : std::span(roots).first(count)) {
    const float root = std::max(each.root, 0.0F);
    candidates.push_back({each.clip, 0, root * root + model.variance_ns});
  }
  return candidates;
}

}  // namespace flinch::models
