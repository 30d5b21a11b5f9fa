// SPDX-License-Identifier: MIT
#include "models/fit/svm_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "motion/error.h"
#include "tests/models/fit/libsvm_oracle.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

TEST(SvmGrid, StartsWithLibsvmsDefaultsWithoutDuplicates) {
  const std::vector<SvmParameters> grid = svm_grid(16);
  EXPECT_EQ(grid.front(), (SvmParameters{3, 1.0 / 16, 0, 1}));
  std::set<std::tuple<int, double, double, double, double>> different;
  for (const SvmParameters& one : grid) {
    EXPECT_EQ(one.kernel, SvmKernel::polynomial);
    different.insert({one.degree, one.gamma, one.coef0, one.cost, one.balance});
  }
  EXPECT_EQ(grid.size(), 19U);
  EXPECT_EQ(different.size(), 19U);
}

TEST(SvmFit, KeepsTheTrainingVectorsWithClassesInTheOrderOfClips) {
  const TrainingSet set = make_set(2, {1, 0.5, -1, 0.25, 2, 0.125}, {7, 2, 7}, 8);
  const SvmModel model = fit_svm(set, {1, 0.5, 0, 100});
  EXPECT_THAT(model.label, testing::ElementsAre(2, 7));
  EXPECT_EQ(model.degree, 1);
  EXPECT_EQ(model.gamma, 0.5);
  EXPECT_EQ(model.cost, 100);
  // The nearest points of the two classes are the support vectors; the third point is outside the
  // margin.
  EXPECT_THAT(model.vectors_of_class, testing::ElementsAre(1, 1));
  EXPECT_EQ(model.value(0, 0), -1);
  EXPECT_EQ(model.value(0, 1), 0.25F);
  EXPECT_EQ(model.value(1, 0), 1);
  EXPECT_EQ(model.value(1, 1), 0.5F);
  ASSERT_EQ(model.coefficients.size(), 2U);
  EXPECT_GT(model.coefficients[0], 0);
  EXPECT_DOUBLE_EQ(model.coefficients[0], model.coefficients[1]);
}

/// Returns libsvm's sv_coef for a machine's vectors of one class, as the model stores them.
std::map<int, double> coefficients_of(const SvmModel& model, const SvmMachine& machine, int side) {
  std::map<int, double> found;
  const std::uint16_t* vector = &model.vectors[machine.first_vector];
  const double* coefficient = model.coefficients.data() + machine.first_coefficient;
  if (side == 1) {
    vector += machine.count[0] + machine.count[1];
    coefficient += machine.count[0];
  }
  for (int k = 0; k < machine.count[static_cast<std::size_t>(2 * side)]; ++k) {
    found[*vector++] = *coefficient++;
  }
  return found;
}

TEST(SvmFit, PairwiseFitMatchesLibsvmBitForBit) {
  std::uint64_t seed = 40;
  for (const SvmKernel kernel : {SvmKernel::polynomial, SvmKernel::rbf}) {
    for (const auto& [count, classes] : {std::pair{40, 2}, {500, 20}, {300, 2}}) {
      const TrainingSet set = random_clouds(seed++, count, classes, 7);
      for (const double cost : {1.0, 50.0}) {
        const SvmParameters parameters{
            .degree = 3, .gamma = 0.2, .coef0 = 1, .cost = cost, .kernel = kernel};
        const LibsvmOracle oracle(set, parameters);
        const SvmModel model = fit_svm(set, parameters);
        const svm_model& theirs = oracle.model();
        ASSERT_EQ(model.class_count(), theirs.nr_class);
        ASSERT_EQ(model.vector_count(), theirs.l);
        for (int c = 0; c < theirs.nr_class; ++c) {
          EXPECT_EQ(model.label[static_cast<std::size_t>(c)], theirs.label[c]);
          EXPECT_EQ(model.vectors_of_class[static_cast<std::size_t>(c)], theirs.nSV[c]);
        }
        std::size_t pair = 0;
        for (int i = 0; i < theirs.nr_class; ++i) {
          for (int j = i + 1; j < theirs.nr_class; ++j, ++pair) {
            const SvmMachine& machine = model.machines[pair];
            EXPECT_EQ(machine.rho, theirs.rho[pair]);
            for (const int side : {0, 1}) {
              const int one = side == 0 ? i : j;
              const double* sv_coef = theirs.sv_coef[side == 0 ? j - 1 : i];
              std::map<int, double> free;
              int at_bound = 0;
              for (int k = 0; k < theirs.nSV[one]; ++k) {
                const double a =
                    std::abs(sv_coef[model.first_of_class[static_cast<std::size_t>(one)] + k]);
                if (a == cost) ++at_bound;
                if (a != 0 && a != cost) free[k] = a;
              }
              ASSERT_EQ(coefficients_of(model, machine, side), free);
              ASSERT_EQ(machine.count[static_cast<std::size_t>(2 * side + 1)], at_bound);
            }
          }
        }
      }
    }
  }
}

TEST(SvmFit, DoesNotDependOnTheNumberOfThreads) {
  const TrainingSet set = random_clouds(50, 400, 15, 6);
  const SvmParameters parameters{.degree = 2, .gamma = 0.5, .coef0 = 1, .cost = 10};
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const SvmModel alone = fit_svm(set, parameters);
  omp_set_num_threads(5);
  const SvmModel together = fit_svm(set, parameters);
  omp_set_num_threads(threads);
  EXPECT_EQ(alone.support_vectors, together.support_vectors);
  EXPECT_EQ(alone.vectors, together.vectors);
  EXPECT_EQ(alone.coefficients, together.coefficients);
}

TEST(SvmFit, RefusesInvalidInput) {
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
    EXPECT_THROW(fit_svm(good, {.gamma = bad}), Error);
    EXPECT_THROW(fit_svm(good, {.balance = bad}), Error);
  }
  EXPECT_THROW(fit_svm(good, {.cost = 0}), Error);
  EXPECT_THROW(fit_svm(good, {.gamma = -1, .kernel = SvmKernel::rbf}), Error);
  EXPECT_THROW(fit_svm(good, {.degree = -1}), Error);
  TrainingSet masked = good;
  masked.masks[0][1] = false;
  EXPECT_THROW(fit_svm(masked, parameters), Error);
  masked = good;
  masked.mask[1] = 1;
  EXPECT_THROW(fit_svm(masked, parameters), Error);
}

}  // namespace
}  // namespace flinch::models
