// SPDX-License-Identifier: MIT
#include "models/svm.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/models/libsvm_oracle.h"
#include "tests/models/training_sets.h"

namespace flinch::models {
namespace {

int predicted_label(const SvmModel& model, std::span<const double> point) {
  return model.label[static_cast<std::size_t>(predict(model, point))];
}

/// Our model and libsvm's, of the same set, agree on every point of the set, the origin and random
/// points within and beyond the range of the features.
void expect_predictions_of_libsvm(const TrainingSet& set, const SvmParameters& parameters) {
  const LibsvmOracle oracle(set, parameters);
  const SvmModel model = fit_svm(set, parameters);
  for (int i = 0; i < set.size(); ++i) {
    ASSERT_EQ(predicted_label(model, set.point(i)), oracle.predict(set.point(i))) << "point " << i;
  }
  std::vector<double> point(static_cast<std::size_t>(set.feature_count), 0.0);
  ASSERT_EQ(predicted_label(model, point), oracle.predict(point)) << "origin";
  std::mt19937_64 random(7);
  for (int i = 0; i < 500; ++i) {
    point = random_point(random, set.feature_count);
    if (i % 2 == 1) {
      for (double& value : point) {
        value *= 10;
      }
    }
    ASSERT_EQ(predicted_label(model, point), oracle.predict(point)) << "random point " << i;
  }
}

TEST(Svm, PredictsLibsvmsLabelsForRandomProblems) {
  std::uint64_t seed = 1;
  for (const int classes : {2, 3, 7, 30}) {
    for (const int degree : {1, 2, 3, 5}) {
      for (const double coef0 : {0.0, 1.0}) {
        SCOPED_TRACE(testing::Message() << classes << " classes, degree " << degree);
        const int features = 1 + static_cast<int>(seed % 17);
        const TrainingSet set = random_clouds(seed++, 200, classes, features);
        expect_predictions_of_libsvm(set, {degree, 1.0 / features, coef0, 10});
      }
    }
  }
}

TEST(Svm, PredictsLibsvmsLabelsForDegenerateProblems) {
  const SvmParameters parameters{3, 0.5, 0, 1};
  {
    SCOPED_TRACE("one class");
    expect_predictions_of_libsvm(make_set(2, {1, 2, 3, 4}, {5, 5}, 6), parameters);
  }
  {
    SCOPED_TRACE("one point a class");
    expect_predictions_of_libsvm(make_set(2, {1, 0, 0, 1, -1, 0}, {2, 0, 1}, 3), parameters);
  }
  {
    SCOPED_TRACE("all points the origin");
    expect_predictions_of_libsvm(make_set(3, std::vector<double>(12, 0.0), {0, 1, 2, 1}, 3),
                                 parameters);
  }
  {
    SCOPED_TRACE("the same point under different labels");
    expect_predictions_of_libsvm(make_set(2, {1, 1, 1, 1, 1, 1, -1, 0}, {0, 1, 2, 0}, 3),
                                 parameters);
  }
  {
    SCOPED_TRACE("features that never vary, symmetric classes");
    expect_predictions_of_libsvm(
        make_set(3, {0, 1, 0, 0, -1, 0, 0, 1, 1, 0, -1, -1}, {0, 1, 0, 1}, 2), parameters);
  }
}

TEST(Svm, OnlyPairsOfAllowedClassesVote) {
  const TrainingSet set = random_clouds(3, 300, 12, 6);
  const SvmParameters parameters{3, 0.5, 1, 10};
  const LibsvmOracle oracle(set, parameters);
  const SvmModel model = fit_svm(set, parameters);
  const auto classes = static_cast<std::size_t>(model.class_count());
  ASSERT_EQ(classes, 12U);
  std::mt19937_64 random(9);
  for (int i = 0; i < 500; ++i) {
    const std::vector<double> point = random_point(random, 6);
    std::vector<char> allowed(classes);
    for (char& one : allowed) {
      one = random() % 2 == 0;
    }
    std::vector<int> votes(classes, -1);
    vote(model, point, allowed, votes);
    ASSERT_EQ(votes, oracle.votes(point, allowed)) << "case " << i;
  }
}

}  // namespace
}  // namespace flinch::models
