// SPDX-License-Identifier: MIT
#include "models/fit/network_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "features/portable_math.h"
#include "features/random.h"
#include "models/fit/network_gradient.h"
#include "models/fit/parallel_for.h"
#include "models/selector.h"
#include "motion/error.h"

namespace flinch::models {
namespace {

using Eigen::MatrixXf;
using Eigen::VectorXf;

constexpr int kBatchSize = 32;

void check_parameters(const NetworkParameters& parameters) {
  if (parameters.hidden_count < kNetworkBlock || parameters.hidden_count % kNetworkBlock != 0 ||
      parameters.member_count < 1 || parameters.epoch_count < 1 ||
      !(parameters.weight_decay >= 0 && parameters.weight_decay <= 1)) {
    throw Error("", "a network needs hidden units in a multiple of " +
                        std::to_string(kNetworkBlock) +
                        ", at least one member and one epoch, and a weight decay from 0 to 1");
  }
}

/// Calls act(output, observation, cost) for every tried clip, one observation after another; costs
/// in the observation's unit.
template <typename Act>
void for_each_trial(const TrainingSet& set, std::span<const int> clips, const Act& act) {
  for (int i = 0; i < set.size(); ++i) {
    for (std::size_t output = 0; output < clips.size(); ++output) {
      const float cost = set.costs(i)[static_cast<std::size_t>(clips[output])];
      if (std::isfinite(cost)) {
        act(static_cast<Eigen::Index>(output), static_cast<Eigen::Index>(i),
            double{cost / set.unit_of(i)});
      }
    }
  }
}

/// Sets mean and standard deviation of the square roots of the costs; costs are never negative.
void standardise(const TrainingSet& set, NetworkModel& model) {
  double count = 0;
  double sum = 0;
  double sum_of_squares = 0;
  for_each_trial(set, model.clip, [&](Eigen::Index, Eigen::Index, double cost) {
    count += 1;
    sum += std::sqrt(std::max(cost, 0.0));
    sum_of_squares += std::max(cost, 0.0);
  });
  const double mean = sum / count;
  const double variance = sum_of_squares / count - mean * mean;
  model.mean_root = static_cast<float>(mean);
  model.scale_root = variance > 1e-12 ? static_cast<float>(std::sqrt(variance)) : 1.0F;
}

/// What the network is fitted to, one column per observation: contiguous, as they are read in
/// random order.
struct Observations {
  MatrixXf inputs;
  MatrixXf targets;       ///< standardised square roots of costs; 0 where the clip was not tried
  MatrixXf loss_weights;  ///< 1 / number of clips tried; 0 where the clip was not tried
};

Observations observations_of(const TrainingSet& set, const NetworkModel& model) {
  Observations all;
  all.inputs.resize(set.feature_count, set.size());
  for (int i = 0; i < set.size(); ++i) {
    std::transform(set.point(i).begin(), set.point(i).end(), all.inputs.col(i).begin(),
                   network_input);
  }
  all.targets = MatrixXf::Zero(static_cast<Eigen::Index>(model.clip.size()), set.size());
  all.loss_weights = all.targets;
  for_each_trial(set, model.clip, [&](Eigen::Index output, Eigen::Index i, double cost) {
    const auto root = static_cast<float>(std::sqrt(std::max(cost, 0.0)));
    all.targets(output, i) = (root - model.mean_root) / model.scale_root;
    all.loss_weights(output, i) = 1;
  });
  for (auto weights : all.loss_weights.colwise()) {
    weights /= static_cast<float>(std::max((weights.array() > 0).count(), Eigen::Index{1}));
  }
  return all;
}

/// Normally distributed weights with the variance that preserves that of the activations from layer
/// to layer (He et al. 2015). The output layer's are a third of that, so that all clips start near
/// the mean. Biases are zero.
VectorXf initial_weights(const NetworkShape& shape, features::Random& random) {
  VectorXf weights = VectorXf::Zero(static_cast<Eigen::Index>(shape.weight_count()));
  const auto draw = [&](std::size_t first, std::size_t count, double deviation) {
    for (std::size_t i = first; i < first + count; ++i) {
      weights[static_cast<Eigen::Index>(i)] = static_cast<float>(deviation * random.normal());
    }
  };
  const double hidden = shape.hidden_count;
  draw(0, shape.first_biases(), std::sqrt(2.0 / shape.feature_count));
  draw(shape.second_weights(), shape.hidden() * shape.hidden(), std::sqrt(2 / hidden));
  draw(shape.output_weights(), shape.outputs() * shape.hidden(), std::sqrt(1 / hidden) / 3);
  return weights;
}

// AdamW: with the gradient g of step t, m += (1 - b1) (g - m), v += (1 - b2) (g^2 - v),
//   w -= rate (m / (1 - b1^t) / (sqrt(v / (1 - b2^t)) + 1e-8) + decay w).
class AdamW {
 public:
  AdamW(Eigen::Index size, double decay, const Kernels& kernels)
      : mean_(VectorXf::Zero(size)),
        square_(VectorXf::Zero(size)),
        decay_(decay),
        kernels_(kernels) {}

  void step(const VectorXf& gradient, double rate, VectorXf& weights) {
    mean_decay_power_ *= kMeanDecay;
    square_decay_power_ *= kSquareDecay;
    kernels_.adamw_step({.mean_gain = static_cast<float>(1 - kMeanDecay),
                         .square_gain = static_cast<float>(1 - kSquareDecay),
                         .rate = static_cast<float>(rate / (1 - mean_decay_power_)),
                         .root_scale = static_cast<float>(1 / std::sqrt(1 - square_decay_power_)),
                         .kept = static_cast<float>(1 - rate * decay_)},
                        static_cast<std::size_t>(weights.size()), gradient.data(), mean_.data(),
                        square_.data(), weights.data());
  }

 private:
  static constexpr double kMeanDecay = 0.9;
  static constexpr double kSquareDecay = 0.999;
  VectorXf mean_, square_;
  double decay_;
  double mean_decay_power_ = 1;    ///< b1^t
  double square_decay_power_ = 1;  ///< b2^t
  const Kernels& kernels_;
};

/// Sets the batch to the chosen observations, followed by rows of zeros. The loss is their mean.
void choose(const Observations& all, std::span<const int> chosen, NetworkBatch& batch) {
  const auto rows = Eigen::seqN(0, static_cast<Eigen::Index>(chosen.size()));
  const auto fill = [&](const MatrixXf& from, MatrixXf& to) {
    to.setZero(kBatchSize, from.rows());
    to(rows, Eigen::all) = from(Eigen::all, chosen).transpose();
  };
  fill(all.inputs, batch.inputs);
  fill(all.targets, batch.targets);
  fill(all.loss_weights, batch.loss_weights);
  batch.loss_weights /= static_cast<float>(chosen.size());
}

VectorXf fit_member(const NetworkShape& shape, const Observations& all,
                    const NetworkParameters& parameters, std::size_t member,
                    const Kernels& kernels) {
  constexpr double kFirstRate = 3e-3;
  features::Random random(parameters.seed, features::RandomStream::fitting, member);
  VectorXf weights = initial_weights(shape, random);
  AdamW adam(weights.size(), parameters.weight_decay, kernels);
  std::vector<int> order(static_cast<std::size_t>(all.inputs.cols()));
  std::iota(order.begin(), order.end(), 0);
  const double seen_in_all = static_cast<double>(order.size()) * parameters.epoch_count;
  double seen = 0;
  NetworkBatch batch;
  for (int epoch = 0; epoch < parameters.epoch_count; ++epoch) {
    random.shuffle(order);
    for (std::size_t first = 0; first < order.size(); first += kBatchSize) {
      const auto chosen =
          std::span(order).subspan(first, std::min(std::size_t{kBatchSize}, order.size() - first));
      choose(all, chosen, batch);
      const double rate = kFirstRate * (1 + features::cos_of_turns(seen / seen_in_all / 2)) / 2;
      adam.step(network_gradient(shape, batch, weights, kernels), rate, weights);
      seen += static_cast<double>(chosen.size());
    }
  }
  return weights;
}

}  // namespace

NetworkModel fit_network(const TrainingSet& set, const NetworkParameters& parameters,
                         const Kernels& kernels) {
  check(set);
  check_costs(set);
  check_parameters(parameters);
  NetworkModel model;
  model.feature_count = set.feature_count;
  model.hidden_count = parameters.hidden_count;
  model.member_count = parameters.member_count;
  model.clip = tried_clips(set);
  standardise(set, model);
  const NetworkShape shape = model.shape();
  const Observations all = observations_of(set, model);
  model.weights.resize(shape.weight_count() * static_cast<std::size_t>(parameters.member_count));
  parallel_for(static_cast<std::size_t>(parameters.member_count), [&](std::size_t member) {
    const VectorXf weights = fit_member(shape, all, parameters, member, kernels);
    if (!(weights.cwiseAbs().maxCoeff() <= kMaxNetworkWeight)) {
      throw Error("", "the network's weights diverge; look for extreme costs");
    }
    std::copy(weights.begin(), weights.end(),
              model.weights.begin() + static_cast<std::ptrdiff_t>(member * shape.weight_count()));
  });
  model.variance_ns = static_cast<float>(std::max(cost_variance_ns(model, set), 0.0));
  return model;
}

double cost_variance_ns(const NetworkModel& model, const TrainingSet& set) {
  double count = 0;
  double sum = 0;
  for (int i = 0; i < set.size(); ++i) {
    for (const Candidate& candidate : expected_costs(model, set.point(i), set.allowed_clips(i))) {
      const float cost = set.costs(i)[static_cast<std::size_t>(candidate.clip)];
      if (std::isfinite(cost)) {
        sum += double{cost / set.unit_of(i)} -
               (double{candidate.expected_cost_ns} - double{model.variance_ns});
        count += 1;
      }
    }
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace flinch::models
