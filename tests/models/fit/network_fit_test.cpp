// SPDX-License-Identifier: MIT
#include "models/fit/network_fit.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "models/fit/cross_validation.h"
#include "models/fit/network_gradient.h"
#include "models/selector.h"
#include "motion/error.h"
#include "tests/models/fit/held_out.h"
#include "tests/models/fit/kernel_sets.h"
#include "tests/models/network_reference.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

constexpr NetworkShape kShape{4, 16, 3};

constexpr Eigen::Index kObservations = 6;

/// Returns a batch of six observations, on each of which one clip was not tried, and ten rows of
/// zeros.
NetworkBatch random_batch(std::mt19937_64& random) {
  NetworkBatch batch{Eigen::MatrixXf::Zero(16, 4), Eigen::MatrixXf::Zero(16, 3),
                     Eigen::MatrixXf::Zero(16, 3)};
  for (Eigen::Index i = 0; i < kObservations; ++i) {
    for (float& value : batch.inputs.row(i)) value = static_cast<float>(random_point(random, 1)[0]);
    for (Eigen::Index output = 0; output < 3; ++output) {
      if (output == i % 3) continue;
      batch.targets(i, output) = static_cast<float>(random_point(random, 1)[0]);
      batch.loss_weights(i, output) = 0.5F;
    }
  }
  return batch;
}

std::vector<double> row(const Eigen::MatrixXf& matrix, Eigen::Index i) {
  return {matrix.row(i).begin(), matrix.row(i).end()};
}

double reference_loss(const NetworkBatch& batch, const std::vector<double>& weights) {
  double loss = 0;
  for (Eigen::Index i = 0; i < kObservations; ++i) {
    const auto answers = reference_outputs(kShape, weights, row(batch.inputs, i));
    for (Eigen::Index output = 0; output < 3; ++output) {
      const double difference =
          answers[static_cast<std::size_t>(output)] - double{batch.targets(i, output)};
      loss += double{batch.loss_weights(i, output)} * difference * difference / 2;
    }
  }
  return loss;
}

TEST(NetworkGradient, MatchesFiniteDifferences) {
  std::mt19937_64 random(1);
  const NetworkBatch batch = random_batch(random);
  std::vector<double> weights;
  Eigen::VectorXf floats(static_cast<Eigen::Index>(kShape.weight_count()));
  for (float& weight : floats) {
    weight = static_cast<float>(random_point(random, 1)[0]);
    weights.push_back(double{weight});
  }
  const Eigen::VectorXf gradient = network_gradient(kShape, batch, floats, widest_kernels());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    constexpr double kStep = 1e-6;
    std::vector<double> moved = weights;
    moved[i] += kStep;
    const double above = reference_loss(batch, moved);
    moved[i] -= 2 * kStep;
    const double slope = (above - reference_loss(batch, moved)) / (2 * kStep);
    ASSERT_NEAR(gradient[static_cast<Eigen::Index>(i)], slope, 1e-4 + 1e-4 * std::abs(slope)) << i;
  }
}

/// Returns a set with six clips, of which each observation's mask allows four.
TrainingSet set_with_costs(int count) {
  TrainingSet set = random_clouds(2, count, 3, 4);
  set.masks.assign(3, ClipMask(6, true));
  for (std::size_t mask = 0; mask < 3; ++mask) {
    set.masks[mask][2 * mask] = set.masks[mask][2 * mask + 1] = false;
  }
  for (int i = 0; i < count; ++i) {
    set.mask[static_cast<std::size_t>(i)] = i % 3;
  }
  return with_costs(set, 3);
}

double regret_of(const TrainingSet& set, int observation, int chosen) {
  const std::span<const float> costs = set.costs(observation);
  const auto label = static_cast<std::size_t>(set.label[static_cast<std::size_t>(observation)]);
  return double{costs[static_cast<std::size_t>(chosen)]} - double{costs[label]};
}

TEST(NetworkFit, PredictsCostsOfHeldOutObservations) {
  const TrainingSet set = set_with_costs(500);
  std::vector<int> first(400);
  std::vector<int> rest(100);
  for (int i = 0; i < 500; ++i)
    (i < 400 ? first[static_cast<std::size_t>(i)] : rest[static_cast<std::size_t>(i - 400)]) = i;
  const NetworkModel model =
      fit_network(subset(set, first), {.member_count = 1, .epoch_count = 60});
  const TrainingSet others = subset(set, rest);
  double squared_error = 0;
  double squared_spread = 0;
  double regret = 0;
  int count = 0;
  for (int i = 0; i < others.size(); ++i) {
    const auto ranked = expected_costs(model, others.point(i), others.allowed_clips(i));
    ASSERT_EQ(ranked.size(), 4U);
    regret += regret_of(others, i, ranked.front().clip) / others.size();
    for (const Candidate& candidate : ranked) {
      const double cost{others.costs(i)[static_cast<std::size_t>(candidate.clip)]};
      squared_error += std::pow(cost - double{candidate.expected_cost_ns}, 2);
      squared_spread += std::pow(cost - 1.0, 2);  // about the mean cost
      ++count;
    }
  }
  EXPECT_LT(squared_error, 0.02 * squared_spread) << count;
  EXPECT_LT(regret, 0.01);
}

TEST(NetworkFit, HasTheSameBitsForAnyNumberOfThreads) {
  const TrainingSet set = set_with_costs(90);
  const NetworkParameters parameters{.hidden_count = 16, .member_count = 3, .epoch_count = 3};
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const NetworkModel alone = fit_network(set, parameters);
  for (const int count : {2, 5}) {
    omp_set_num_threads(count);
    EXPECT_EQ(fit_network(set, parameters).weights, alone.weights);
  }
  omp_set_num_threads(threads);
  NetworkParameters other = parameters;
  other.seed = 2;
  EXPECT_NE(fit_network(set, other).weights, alone.weights);
}

TEST(NetworkFit, HasTheSameBitsForAnyInstructionSet) {
  const TrainingSet set = set_with_costs(90);
  const NetworkParameters parameters{.hidden_count = 48, .member_count = 1, .epoch_count = 3};
  const NetworkModel expected =
      fit_network(set, parameters, *kernels_for(InstructionSet::baseline));
  for (const Kernels* kernels : kernel_sets()) {
    EXPECT_EQ(fit_network(set, parameters, *kernels).weights, expected.weights)
        << kernels->instruction_set;
  }
}

TEST(NetworkFit, IsValidatedOnHeldOutObservations) {
  const TrainingSet set = set_with_costs(90);
  std::vector<int> fold = assign_folds(set.label, 3, 1);
  std::replace(fold.begin(), fold.end(), 2, kNeverHeldOut);
  const NetworkParameters parameters{.hidden_count = 16, .member_count = 1, .epoch_count = 3};
  std::vector<int> choices(90, -1);
  const NetworkValidation validation =
      validate_network(set, parameters, fold, [&](int observation, int chosen) {
        choices[static_cast<std::size_t>(observation)] = chosen;
        return observation;
      });
  double excess = 0;
  double held_out = 0;
  double sum = 0;
  for (int f = 0; f < 2; ++f) {
    const NetworkModel model = fit_network(all_except(set, fold, f), parameters);
    for (int i = 0; i < set.size(); ++i) {
      if (fold[static_cast<std::size_t>(i)] != f) continue;
      const auto ranked = expected_costs(model, set.point(i), set.allowed_clips(i));
      EXPECT_EQ(choices[static_cast<std::size_t>(i)], ranked.front().clip);
      for (const Candidate& candidate : ranked) {
        excess += double{set.costs(i)[static_cast<std::size_t>(candidate.clip)]} -
                  double{candidate.expected_cost_ns - model.variance_ns};
      }
      held_out += 1;
      sum += i;
    }
  }
  EXPECT_NEAR(validation.mean_score, sum / held_out, 1e-9);
  EXPECT_NEAR(validation.variance_ns, std::max(excess / (held_out * 4), 0.0), 1e-4);
}

TEST(NetworkFit, RefusesInvalidInput) {
  TrainingSet set = set_with_costs(20);
  EXPECT_THROW(fit_network(set, {.hidden_count = 20}), Error);
  EXPECT_THROW(fit_network(set, {.member_count = 0}), Error);
  EXPECT_THROW(fit_network(set, {.epoch_count = 0}), Error);
  EXPECT_THROW(fit_network(set, {.weight_decay = std::nan("")}), Error);
  set.cost.clear();
  EXPECT_THROW(fit_network(set, {}), Error);
}

TEST(NetworkFit, AcceptsConstantCosts) {
  TrainingSet set = set_with_costs(20);
  for (float& cost : set.cost) {
    if (std::isfinite(cost)) cost = 4;
  }
  const NetworkModel model =
      fit_network(set, {.hidden_count = 16, .member_count = 1, .epoch_count = 50});
  EXPECT_NEAR(expected_costs(model, set.point(0), set.allowed_clips(0)).front().expected_cost_ns, 4,
              0.2);
}

}  // namespace
}  // namespace flinch::models
