// SPDX-License-Identifier: MIT
#include "models/fit/cross_validation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <map>
#include <random>

#include "models/selector.h"
#include "motion/error.h"
#include "tests/models/fit/held_out.h"
#include "tests/models/training_sets.h"
#include "tests/scenes/not_finite.h"

namespace flinch::models {
namespace {

/// Labels with very different frequencies.
std::vector<int> uneven_labels(int count) {
  std::vector<int> label;
  for (int i = 0; i < count; ++i) {
    label.push_back(i % 97 == 0 ? 9 : (i % 5 == 0 ? 4 : 1));
  }
  return label;
}

TEST(Folds, AreAStratifiedPartition) {
  const std::vector<int> label = uneven_labels(503);
  for (const int fold_count : {2, 5, 7, 503}) {
    const std::vector<int> fold = assign_folds(label, fold_count, 3);
    ASSERT_EQ(fold.size(), label.size());
    std::map<int, std::vector<int>> count_of;  // label -> observations in each fold
    std::vector<int> size(static_cast<std::size_t>(fold_count));
    for (std::size_t i = 0; i < fold.size(); ++i) {
      ASSERT_GE(fold[i], 0);
      ASSERT_LT(fold[i], fold_count);
      count_of[label[i]].resize(size.size());
      ++count_of[label[i]][static_cast<std::size_t>(fold[i])];
      ++size[static_cast<std::size_t>(fold[i])];
    }
    const auto spread = [](const std::vector<int>& counts) {
      const auto [min, max] = std::minmax_element(counts.begin(), counts.end());
      return *max - *min;
    };
    EXPECT_LE(spread(size), 1);
    for (const auto& [one, counts] : count_of) {
      EXPECT_LE(spread(counts), 1) << "label " << one;
    }
  }
}

TEST(Folds, AreTheSameForTheSameSeedOnly) {
  const std::vector<int> label = uneven_labels(200);
  EXPECT_EQ(assign_folds(label, 5, 1), assign_folds(label, 5, 1));
  EXPECT_NE(assign_folds(label, 5, 1), assign_folds(label, 5, 2));
  // Computed by hand from the first outputs of the 64-bit Mersenne twister for its standard seed
  // 5489: 14514284786278117030, 4620546740167642908 and 13109570281517897720. Swaps with 14514… mod
  // 4 = 2, 4620… mod 3 = 0 and 13109… mod 2 = 0 turn 0123 into 0132, 3102 and 1302.
  EXPECT_THAT(assign_folds(std::vector<int>(4, 0), 4, 5489), testing::ElementsAre(2, 0, 3, 1));
}

TEST(Folds, RefuseImpossibleCounts) {
  const std::vector<int> label(4, 0);
  EXPECT_THROW(assign_folds(label, 1, 1), Error);
  EXPECT_THROW(assign_folds(label, 5, 1), Error);
  EXPECT_THROW(assign_folds({}, 2, 1), Error);
}

TEST(Folds, AreLimitedToEnoughHeldOutObservations) {
  const std::vector<int> label = uneven_labels(4000);
  const std::vector<int> fold = assign_folds(label, 5, 3);  // 800 observations each
  const std::vector<int> few = limit_folds(fold);
  for (std::size_t i = 0; i < fold.size(); ++i) {
    EXPECT_EQ(few[i], fold[i] < 2 ? fold[i] : kNeverHeldOut);
  }
  const std::vector<int> small = assign_folds(uneven_labels(1499), 5, 3);
  EXPECT_EQ(limit_folds(small), small);
}

TEST(Argmin, IsTheFirstMinimum) {
  EXPECT_EQ(argmin(std::vector<double>{3, 1, 2, 1}), 1U);
  EXPECT_EQ(argmin(std::vector<double>{tests::kNanDouble, 2, tests::kNanDouble, 1}), 3U);
  EXPECT_EQ(argmin(std::vector<double>{tests::kNanDouble}), 0U);
}

/// Returns a loss of 1 where the choice is not the label, else 0.
LossFunction mistakes(const TrainingSet& set) {
  return [&set](int observation, int chosen) {
    return chosen == set.label[static_cast<std::size_t>(observation)] ? 0.0 : 1.0;
  };
}

/// The classes are the signs of x y: an even kernel of degree 2 separates them, an odd one of
/// degree 3 cannot.
TrainingSet signs_of_product(int count) {
  std::mt19937_64 random(4);
  std::vector<double> points;
  std::vector<int> label;
  for (int i = 0; i < count; ++i) {
    const std::vector<double> point = random_point(random, 2);
    points.insert(points.end(), point.begin(), point.end());
    label.push_back(point[0] * point[1] > 0 ? 1 : 0);
  }
  return make_set(2, points, label, 2);
}

TEST(ChooseParameters, FindsTheKernelThatFits) {
  const TrainingSet set = signs_of_product(150);
  const std::vector<int> fold = assign_folds(set.label, 5, 1);
  const std::vector<SvmParameters> grid{{3, 1, 0, 10}, {1, 1, 0, 10}, {2, 1, 0, 10}, {5, 1, 0, 10}};
  const auto chosen = choose_parameters(set, grid, fold, mistakes(set));
  EXPECT_EQ(chosen.parameters, grid[2]);
  EXPECT_LT(chosen.mean_score, 0.1);
  const auto whole_grid = choose_parameters(set, svm_grid(2), fold, mistakes(set));
  EXPECT_EQ(whole_grid.parameters.degree, 2);
}

TEST(ChooseParameters, TiesGoToTheFirst) {
  const TrainingSet set = signs_of_product(100);
  const std::vector<int> fold = assign_folds(set.label, 4, 1);
  const LossFunction same = [](int, int) { return 1.0; };
  EXPECT_EQ(choose_parameters(set, svm_grid(2), fold, same).parameters, default_svm_parameters(2));
  EXPECT_EQ(choose_parameters(set, knn_grid(), fold, same).parameters, knn_grid().front());
}

TEST(ChooseParameters, PrefersLargeKForNoisyLabels) {
  std::mt19937_64 random(6);
  std::vector<double> points;
  std::vector<int> label;
  for (int i = 0; i < 600; ++i) {
    const std::vector<double> point = random_point(random, 2);
    points.insert(points.end(), point.begin(), point.end());
    // three in ten labels are wrong
    label.push_back((point[0] > 0) != (random() % 10 < 3) ? 1 : 0);
  }
  const TrainingSet set = make_set(2, points, label, 2);
  const std::vector<KnnParameters> grid{{1, KnnVote::majority}, {25, KnnVote::majority}};
  const auto chosen = choose_parameters(set, grid, assign_folds(set.label, 5, 1), mistakes(set));
  EXPECT_EQ(chosen.parameters.k, 25);
  EXPECT_NEAR(chosen.mean_score, 0.3, 0.06);
}

TEST(ChooseParameters, MinimisesTheGivenLoss) {
  const TrainingSet set = signs_of_product(200);
  const std::vector<int> fold = assign_folds(set.label, 4, 1);
  const std::vector<SvmParameters> grid{{2, 1, 0, 10}, {3, 1, 0, 10}};
  const LossFunction right_is_bad = [&](int observation, int chosen) {
    return 1 - mistakes(set)(observation, chosen);
  };
  EXPECT_EQ(choose_parameters(set, grid, fold, right_is_bad).parameters, grid[1]);
}

/// Overlapping clouds with masks that each forbid every third clip, but never an observation's
/// label.
TrainingSet masked_clouds(int count) {
  TrainingSet set = random_clouds(8, count, 9, 6);
  set.idle = 0;
  set.masks.assign(3, ClipMask(18, true));
  for (std::size_t mask = 0; mask < 3; ++mask) {
    for (std::size_t clip = mask; clip < 18; clip += 3) {
      set.masks[mask][clip] = false;
    }
  }
  for (std::size_t i = 0; i < set.label.size(); ++i) {
    set.mask[i] = (set.label[i] + 1 + static_cast<int>(i % 2)) % 3;
  }
  return set;
}

/// Checks that each held-out choice is that of a model that `fit` makes from the other folds, for
/// all parameters of the grid.
template <typename Parameters, typename Fit>
void expect_choices_of_others(const TrainingSet& set, int fold_count,
                              const std::vector<Parameters>& grid, const Fit& fit) {
  const std::vector<int> fold = assign_folds(set.label, fold_count, 2);
  for (const Parameters& parameters : grid) {
    const std::vector<int> choices = held_out_choices(set, parameters, fold);
    for (int f = 0; f < fold_count; ++f) {
      const auto model = fit(all_except(set, fold, f), parameters);
      for (int i = 0; i < set.size(); ++i) {
        if (fold[static_cast<std::size_t>(i)] != f) continue;
        const int choice = choices[static_cast<std::size_t>(i)];
        ASSERT_EQ(choice, candidates(model, set.point(i), set.allowed_clips(i), 0).front().clip);
        ASSERT_TRUE(set.allowed_clips(i)[static_cast<std::size_t>(choice)]);
      }
    }
  }
}

TEST(HeldOutChoices, MatchSvmsFittedWithoutTheObservation) {
  expect_choices_of_others(masked_clouds(240), 4,
                           std::vector<SvmParameters>{{3, 0.2, 0, 1}, {2, 0.5, 1, 10}}, fit_svm);
}

TEST(HeldOutChoices, MatchKnnsWithoutTheObservation) {
  std::vector<KnnParameters> grid = knn_grid();
  for (const KnnParameters& parameters : knn_cost_grid()) grid.push_back(parameters);
  expect_choices_of_others(with_costs(masked_clouds(240), 9), 4, grid, fit_knn);
}

TEST(HeldOutChoices, MatchPairwiseModelsFittedWithoutTheObservation) {
  expect_choices_of_others(with_costs(masked_clouds(90), 10), 3,
                           std::vector<PairwiseParameters>{{}, {.c = 0.01, .nearness = 1}},
                           [](const TrainingSet& set, const PairwiseParameters& parameters) {
                             return fit_pairwise(set, parameters);
                           });
}

TEST(HeldOutChoices, SkipObservationsThatAreNeverHeldOut) {
  const TrainingSet set = masked_clouds(90);
  std::vector<int> fold = assign_folds(set.label, 3, 1);
  std::replace(fold.begin(), fold.end(), 2, kNeverHeldOut);
  const SvmParameters parameters{3, 0.2, 0, 1};
  const std::vector<int> choices = held_out_choices(set, parameters, fold);
  for (std::size_t i = 0; i < fold.size(); ++i) {
    EXPECT_EQ(choices[i] >= 0, fold[i] != kNeverHeldOut);
  }
}

TEST(HeldOutChoices, DoNotDependOnTheNumberOfThreads) {
  const TrainingSet set = with_costs(masked_clouds(240), 11);
  const std::vector<int> fold = assign_folds(set.label, 5, 3);
  const auto choices = [&] {
    return std::vector{held_out_choices(set, default_svm_parameters(6), fold),
                       held_out_choices(set, knn_grid().front(), fold),
                       held_out_choices(set, knn_cost_grid().front(), fold),
                       held_out_choices(set, PairwiseParameters{}, fold)};
  };
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto alone = choices();
  for (const int count : {2, 7}) {
    omp_set_num_threads(count);
    EXPECT_EQ(choices(), alone);
  }
  omp_set_num_threads(threads);
}

TEST(HeldOutChoices, RethrowErrorsFromWorkerThreads) {
  const TrainingSet set = masked_clouds(60);
  const std::vector<int> fold = assign_folds(set.label, 3, 1);
  EXPECT_THROW(held_out_choices(set, SvmParameters{3, 1, 0, -1}, fold), Error);
}

}  // namespace
}  // namespace flinch::models
