// SPDX-License-Identifier: MIT
#include "models/svm_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <tuple>

#include "motion/error.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

TEST(SvmGrid, BeginsWithLibsvmsDefaultsAndHoldsEachOnce) {
  const std::vector<SvmParameters> grid = svm_grid(16);
  EXPECT_EQ(grid.front(), (SvmParameters{3, 1.0 / 16, 0, 1}));
  std::set<std::tuple<int, double, double, double>> different;
  for (const SvmParameters& one : grid) {
    different.insert({one.degree, one.gamma, one.coef0, one.cost});
  }
  EXPECT_EQ(grid.size(), 24U);
  EXPECT_EQ(different.size(), 24U);
}

TEST(SvmFit, KeepsTheTrainingVectorsAndTheOrderOfClasses) {
  const TrainingSet set = make_set(2, {1, 0.5, -1, 0.25, 2, 0.125}, {7, 2, 7}, 8);
  const SvmModel model = fit_svm(set, {1, 0.5, 0, 100});
  EXPECT_THAT(model.label, testing::ElementsAre(7, 2));
  EXPECT_EQ(model.degree, 1);
  EXPECT_EQ(model.gamma, 0.5);
  EXPECT_EQ(model.cost, 100);
  // The two nearest points of either class carry the margin; the third lies beyond it.
  EXPECT_THAT(model.vectors_of_class, testing::ElementsAre(1, 1));
  EXPECT_THAT(model.support_vectors, testing::ElementsAre(1, -1, 0.5, 0.25));
  ASSERT_EQ(model.coefficients.size(), 2U);
  EXPECT_GT(model.coefficients[0], 0);
  EXPECT_DOUBLE_EQ(model.coefficients[0], -model.coefficients[1]);
}

TEST(SvmFit, RefusesWhatCannotBeUsed) {
  const SvmParameters parameters = default_svm_parameters(2);
  EXPECT_THROW(fit_svm(make_set(2, {}, {}, 2), parameters), Error);
  EXPECT_THROW(fit_svm(make_set(2, {1, 2}, {0}, 2), parameters), Error);
  EXPECT_THROW(fit_svm(make_set(2, {1, 2, 3}, {0, 1}, 2), parameters), Error);
  EXPECT_THROW(fit_svm(make_set(2, {1, 2, 3, 4}, {0, 2}, 2), parameters), Error);
  EXPECT_THROW(fit_svm(make_set(2, {1, 2, 3, 4}, {0, -1}, 2), parameters), Error);
  const TrainingSet good = make_set(2, {1, 2, 3, 4}, {0, 1}, 2);
  EXPECT_NO_THROW(fit_svm(good, parameters));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TrainingSet set = good;
    set.points[2] = bad;
    EXPECT_THROW(fit_svm(set, parameters), Error);
    EXPECT_THROW(fit_svm(good, {3, bad, 0, 1}), Error);
  }
  EXPECT_THROW(fit_svm(good, {3, 0.5, 0, 0}), Error);
  EXPECT_THROW(fit_svm(good, {-1, 0.5, 0, 1}), Error);
  TrainingSet masked = good;
  masked.masks[0][1] = false;
  EXPECT_THROW(fit_svm(masked, parameters), Error);
  masked = good;
  masked.mask[1] = 1;
  EXPECT_THROW(fit_svm(masked, parameters), Error);
}

}  // namespace
}  // namespace flinch::models
