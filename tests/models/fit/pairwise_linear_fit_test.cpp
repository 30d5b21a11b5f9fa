// SPDX-License-Identifier: MIT
#include "models/fit/pairwise_linear_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numeric>

#include "models/selector.h"
#include "motion/error.h"
#include "tests/models/fit/kernel_sets.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

int choice(const PairwiseModel& model, const TrainingSet& set, int i) {
  return candidates(model, set.point(i), set.allowed_clips(i), set.idle).front().clip;
}

double mean_regret(const TrainingSet& set, const std::function<int(int)>& choose) {
  double sum = 0;
  for (int i = 0; i < set.size(); ++i) {
    const auto costs = set.costs(i);
    sum += double{costs[static_cast<std::size_t>(choose(i))]} -
           double{*std::min_element(costs.begin(), costs.end())};
  }
  return sum / set.size();
}

TEST(PairwiseFit, ChoosesCheapClipsForHeldOutObservations) {
  const TrainingSet all = with_costs(random_clouds(1, 1200, 6, 4), 2);
  std::vector<int> first(900);
  std::iota(first.begin(), first.end(), 0);
  std::vector<int> rest(300);
  std::iota(rest.begin(), rest.end(), 900);
  const TrainingSet tested = subset(all, rest);
  const PairwiseModel model = fit_pairwise(subset(all, first), {});
  const double learned = mean_regret(tested, [&](int i) { return choice(model, tested, i); });
  const double by_chance = mean_regret(tested, [&](int i) { return i % 12; });
  // Which of two such clips is cheaper is decided by a polynomial of degree 2, as in the machines.
  EXPECT_LT(learned, 0.02 * by_chance);
}

/// Two clips with observations at one point: the first costs a little less on 60 of them, the
/// second much less on 40. Choosing the first makes the fewest mistakes, choosing the second costs
/// least.
TEST(PairwiseFit, WeightsMistakesByTheirCost) {
  TrainingSet set = make_set(1, std::vector<double>(100, 0.5), std::vector<int>(100, 0), 2);
  for (int i = 0; i < 100; ++i) {
    const bool is_first_cheaper = i < 60;
    set.cost.push_back(is_first_cheaper ? 1 : 2);
    set.cost.push_back(is_first_cheaper ? 1.25F : 1);
    set.label[static_cast<std::size_t>(i)] = is_first_cheaper ? 0 : 1;
  }
  EXPECT_EQ(choice(fit_pairwise(set, {}), set, 0), 1);
}

/// On 15 of 20 observations the second clip costs much less than the first, but there the third one
/// costs nothing; on the other 5, where the first is the best, the second costs a little more.
TEST(PairwiseFit, IrrelevantPairsHaveNoWeight) {
  TrainingSet set = make_set(1, std::vector<double>(20, 0.5), std::vector<int>(20, 0), 3);
  for (int i = 0; i < 20; ++i) {
    const bool decides = i < 5;
    set.cost.insert(set.cost.end(), decides ? std::initializer_list<float>{1, 1.5, 2}
                                            : std::initializer_list<float>{9, 4, 0});
    set.label[static_cast<std::size_t>(i)] = decides ? 0 : 2;
  }
  const PairwiseModel model = fit_pairwise(set, {});
  std::vector<std::int16_t> terms(model.row_size());
  expand(set.point(0), terms);
  EXPECT_TRUE(beats(model, terms, 0, 1));
}

TEST(PairwiseFit, HasNoMachineForPairsWithoutExamples) {
  TrainingSet set = with_costs(random_clouds(3, 60, 2, 2), 4);
  const float untried = std::numeric_limits<float>::infinity();
  for (int i = 0; i < set.size(); ++i) {
    float* costs = &set.cost[static_cast<std::size_t>(i) * 4];
    costs[2] = costs[0];                  // the same costs, so never a difference
    costs[i % 2 == 0 ? 1 : 3] = untried;  // never both tried
  }
  const PairwiseModel model = fit_pairwise(set, {});
  EXPECT_THAT(model.clip, testing::ElementsAre(0, 1, 2, 3));
  const int none = PairwiseModel::kNone;
  // (0,1) (0,2) (0,3) (1,2) (1,3) (2,3)
  EXPECT_THAT(model.machine, testing::ElementsAre(0, none, 1, 2, none, 3));
  EXPECT_EQ(model.weights.size(), 4 * model.row_size());
}

TEST(PairwiseFit, WeightSumsFillButDoNotOverflow32Bits) {
  const TrainingSet set = with_costs(random_clouds(5, 200, 3, 6), 6);
  const PairwiseModel model = fit_pairwise(set, {});
  for (std::size_t at = 0; at < model.weights.size(); at += model.row_size()) {
    std::int32_t sum = 0;
    std::int32_t largest = 0;
    for (const std::int16_t weight : std::span(model.weights).subspan(at, model.row_size())) {
      sum += std::abs(weight);
      largest = std::max(largest, std::abs(std::int32_t{weight}));
    }
    EXPECT_LE(sum, PairwiseModel::kMaxWeightSum);
    EXPECT_TRUE(sum > 0.99 * PairwiseModel::kMaxWeightSum || largest == 0x7FFF);
  }
}

TEST(PairwiseFit, HasTheSameBitsForAnyNumberOfThreads) {
  const TrainingSet set = with_costs(random_clouds(7, 150, 4, 5), 8);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const PairwiseModel alone = fit_pairwise(set, {});
  for (const int count : {2, 5}) {
    omp_set_num_threads(count);
    EXPECT_EQ(fit_pairwise(set, {}).weights, alone.weights);
  }
  omp_set_num_threads(threads);
  EXPECT_NE(fit_pairwise(set, {.c = 0.01}).weights, alone.weights);
}

TEST(PairwiseFit, HasTheSameBitsForAnyInstructionSet) {
  const TrainingSet set = with_costs(random_clouds(7, 300, 6, 9), 8);
  const PairwiseModel expected = fit_pairwise(set, {}, *kernels_for(InstructionSet::baseline));
  for (const Kernels* kernels : kernel_sets()) {
    EXPECT_EQ(fit_pairwise(set, {}, *kernels).weights, expected.weights)
        << kernels->instruction_set;
  }
}

TEST(PairwiseFit, RefusesInvalidInput) {
  TrainingSet set = with_costs(random_clouds(11, 20, 2, 2), 12);
  EXPECT_NO_THROW(fit_pairwise(set, {}));
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(fit_pairwise(set, {.c = bad}), Error);
    EXPECT_THROW(fit_pairwise(set, {.nearness = bad}), Error);
  }
  set.cost.clear();
  EXPECT_THROW(fit_pairwise(set, {}), Error);
}

}  // namespace
}  // namespace flinch::models
