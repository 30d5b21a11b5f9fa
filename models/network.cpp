// SPDX-License-Identifier: MIT
#include "models/network.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>

namespace flinch::models {
namespace {

using Block = Eigen::Array<float, kNetworkBlock, 1>;
using Half = Eigen::Array<float, kNetworkBlock / 2, 1>;

/// out = max(0, biases + weights in), one block of units at a time. Each unit's sum runs from the
/// first input to the last, whatever instructions the compiler selects.
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

/// Outputs that are computed side by side: the additions of one sum depend on each other, those of
/// four sums do not.
constexpr std::size_t kOutputsAtOnce = 4;

/// sums[k] += bias[k] + weights[k] . in. Each product has eight partial sums, added from the first
/// to the last: the order is the same on every machine and for any grouping of outputs.
void add_outputs(std::span<const float> in, const std::array<const float*, kOutputsAtOnce>& weights,
                 const std::array<float, kOutputsAtOnce>& bias,
                 std::array<float, kOutputsAtOnce>& sums) {
  std::array<Half, kOutputsAtOnce> partial;
  partial.fill(Half::Zero());
  for (std::size_t i = 0; i < in.size(); i += kNetworkBlock / 2) {
    const Eigen::Map<const Half> inputs(&in[i]);
    for (std::size_t k = 0; k < kOutputsAtOnce; ++k) {
      partial[k] += inputs * Eigen::Map<const Half>(weights[k] + i);
    }
  }
  Eigen::Array<float, kOutputsAtOnce, 1> total = Eigen::Map<const decltype(total)>(bias.data());
  for (int part = 0; part < kNetworkBlock / 2; ++part) {
    total += Eigen::Array<float, kOutputsAtOnce, 1>(partial[0][part], partial[1][part],
                                                    partial[2][part], partial[3][part]);
  }
  Eigen::Map<decltype(total)>(sums.data()) += total;
}

}  // namespace

std::pmr::vector<Candidate> expected_costs(const NetworkModel& model,
                                           std::span<const double> scaled,
                                           const ClipMask& allowed_clips, MemoryResource memory,
                                           std::size_t max_count) {
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
  // Groups of kOutputsAtOnce; the last group repeats an output where too few are left.
  using Group = std::array<float, kOutputsAtOnce>;
  std::pmr::vector<Group> sums((outputs.size() + kOutputsAtOnce - 1) / kOutputsAtOnce, Group{},
                               memory);
  for (int member = 0; member < model.member_count; ++member) {
    const float* weights =
        model.weights.data() + static_cast<std::size_t>(member) * shape.weight_count();
    hidden_layer(inputs, weights, weights + shape.first_biases(), first);
    hidden_layer(first, weights + shape.second_weights(), weights + shape.second_biases(), second);
    for (std::size_t group = 0; group < sums.size(); ++group) {
      std::array<const float*, kOutputsAtOnce> output_weights{};
      Group biases{};
      for (std::size_t k = 0; k < kOutputsAtOnce; ++k) {
        const std::size_t output =
            outputs[std::min(group * kOutputsAtOnce + k, outputs.size() - 1)];
        output_weights[k] = weights + shape.output_weights() + output * shape.hidden();
        biases[k] = weights[shape.output_biases() + output];
      }
      add_outputs(second, output_weights, biases, sums[group]);
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
    roots.push_back({model.mean_root + scale * sums[i / kOutputsAtOnce][i % kOutputsAtOnce],
                     model.clip[outputs[i]]});
  }
  // Sorted by the square root, which still distinguishes clips whose expected cost is zero or
  // below.
  const std::size_t count = std::min(max_count, roots.size());
  const auto end = roots.begin() + static_cast<std::ptrdiff_t>(count);
  std::partial_sort(roots.begin(), end, roots.end(), [](const Root& a, const Root& b) {
    return a.root != b.root ? a.root < b.root : a.clip < b.clip;
  });
  roots.resize(count, {});
  std::pmr::vector<Candidate> candidates(memory);
  candidates.reserve(roots.size());
  for (const Root& each : roots) {
    const float root = std::max(each.root, 0.0F);
    candidates.push_back({each.clip, 0, root * root + model.variance_ns});
  }
  return candidates;
}

}  // namespace flinch::models
