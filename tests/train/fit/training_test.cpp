// SPDX-License-Identifier: MIT
#include "train/fit/training.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/scenes/error_of.h"
#include "tests/train/evaluate/comparison.h"
#include "train/fit/selector_writer.h"

namespace flinch::train {
namespace {

TEST(TrainSelector, AShuffledStoreGivesTheSameSelectorByEveryMethod) {
  const Store store = made_up_store(60);
  Store shuffled = store;
  std::shuffle(shuffled.observations.begin(), shuffled.observations.end(), std::mt19937_64(3));
  const CostModel cost_model = default_cost(store.header);
  for (const Method method : methods()) {
    const auto bytes_from = [&](const Store& from) {
      return selector_bytes(
          train_selector(from.header, from.observations, cost_model, method, 1).selector);
    };
    EXPECT_EQ(bytes_from(store), bytes_from(shuffled)) << name_of(method);
  }
}

TEST(TrainSelector, AnSvmHasItsClassesInTheOrderOfClips) {
  const Store store = made_up_store(60);
  const Training training =
      train_selector(store.header, store.observations, default_cost(store.header), Method::svm, 1);
  const std::vector<int>& label = std::get<models::SvmModel>(training.selector.model).label;
  EXPECT_GT(label.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(label));
}

Training train_with(Method method, const FixedParameters& fixed) {
  const Store store = made_up_store(60);
  return train_selector(store.header, store.observations, default_cost(store.header), method, 1,
                        fixed);
}

TEST(TrainSelector, GivenParametersAreUsedAndTheOthersChosen) {
  EXPECT_EQ(train_with(Method::knn, {.k = 4}).parameters.substr(0, 3), "k 4");
  EXPECT_EQ(train_with(Method::svm, {.c = 7, .gamma = 0.5, .degree = 4, .coef0 = 2}).parameters,
            "kernel polynomial, degree 4, coef0 2, gamma 0.5, c 7");
  EXPECT_NE(train_with(Method::svm_rbf, {.c = 7}).parameters.find(", c 7"), std::string::npos);
  EXPECT_EQ(train_with(Method::pairwise_cost, {.c = 2}).parameters.substr(0, 3), "c 2");
}

TEST(TrainSelector, LibsvmsDefaultsAreThoseOfSvmTrain) {
  const Training training = train_with(Method::svm, {.libsvm_defaults = true});
  const auto& model = std::get<models::SvmModel>(training.selector.model);
  EXPECT_EQ(model.degree, 3);
  EXPECT_EQ(model.coef0, 0);
  EXPECT_EQ(model.cost, 1);
  EXPECT_EQ(model.gamma, 1.0 / model.feature_count);
  EXPECT_EQ(std::get<models::SvmModel>(
                train_with(Method::svm, {.c = 5, .libsvm_defaults = true}).selector.model)
                .cost,
            5);
}

TEST(TrainSelector, AParameterThatTheMethodDoesNotHaveIsRefused) {
  const auto error = [](Method method, const FixedParameters& fixed) {
    return tests::error_of([&] { train_with(method, fixed); });
  };
  EXPECT_NE(error(Method::knn, {.gamma = 1.0}).find("gamma cannot be given for knn"),
            std::string::npos);
  EXPECT_NE(error(Method::svm_rbf, {.degree = 2}).find("degree"), std::string::npos);
  EXPECT_NE(error(Method::network, {.c = 1.0}).find("c cannot be given"), std::string::npos);
  EXPECT_NE(error(Method::svm, {.c = -1.0}).find("c is out of its range"), std::string::npos);
}

TEST(NarrowGrid, KeepsEachCandidateOnceInTheGridsOrder) {
  EXPECT_EQ(narrow(models::knn_grid(), {.k = 5}).size(), 2U);  // both votes
  EXPECT_EQ(narrow(models::knn_grid(), {}), models::knn_grid());
  EXPECT_EQ(narrow(models::svm_grid(10), {}, 10), models::svm_grid(10));
  EXPECT_EQ(narrow(models::svm_grid(10), {.c = 3}, 10).size(), 7U);
  EXPECT_EQ(narrow(models::svm_grid(10), {.libsvm_defaults = true}, 10).size(), 1U);
}

}  // namespace
}  // namespace flinch::train
