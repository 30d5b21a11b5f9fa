// SPDX-License-Identifier: MIT
#include "train/fit/training.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

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

}  // namespace
}  // namespace flinch::train
