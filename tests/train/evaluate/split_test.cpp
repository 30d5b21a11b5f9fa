// SPDX-License-Identifier: MIT
#include "train/evaluate/split.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/error.h"
#include "tests/scenes/error_of.h"
#include "tests/train/evaluate/comparison.h"

namespace flinch::train {
namespace {

using testing::HasSubstr;

std::string refusal_of(const Store& training, const Store& test) {
  return tests::error_of([&] { require_independent(training, test, "test.flinchobs"); });
}

TEST(TrainTestSplit, HoldsOutEveryFourthScenario) {
  const TrainTestSplit split = split_of(made_up_store(10));
  ASSERT_EQ(split.tested.size(), 2U);
  EXPECT_EQ(split.tested[0].number, 3U);
  EXPECT_EQ(split.tested[1].number, 7U);
  EXPECT_EQ(split.fitted.size(), 8U);
  EXPECT_FALSE(split.has_test_store);
}

TEST(TrainTestSplit, OfTwoStoresFitsOneAndTestsTheOther) {
  const TrainTestSplit split = split_of(made_up_store(10), made_up_store(6, 6));
  EXPECT_EQ(split.fitted.size(), 10U);
  EXPECT_EQ(split.tested.size(), 6U);
  EXPECT_EQ(split.header.seed, 5U);
  EXPECT_TRUE(split.has_test_store);
}

TEST(TrainTestSplit, RejectsTooFewScenarios) {
  EXPECT_THROW(split_of(made_up_store(7)), Error);
  EXPECT_THROW(split_of(made_up_store(10), made_up_store(1, 6)), Error);
  EXPECT_THROW(split_of(made_up_store(0), made_up_store(10, 6)), Error);
}

TEST(TestStore, IsRejectedIfItSharesAScenario) {
  const Store training = made_up_store(10);
  Store test = made_up_store(12);
  EXPECT_THAT(refusal_of(training, test), HasSubstr("test.flinchobs: shares scenarios"));
  test.observations.erase(test.observations.begin(), test.observations.begin() + 9);
  EXPECT_THAT(refusal_of(training, test), HasSubstr("another --seed"));  // number 9
  test.observations.erase(test.observations.begin());
  EXPECT_EQ(refusal_of(training, test), "");  // 10 and 11 of the same seed
  EXPECT_EQ(refusal_of(training, made_up_store(12, 6)), "");
  test = made_up_store(12);
  test.header.distribution = "{}";
  EXPECT_EQ(refusal_of(training, test), "");
}

TEST(TestStore, IsRejectedIfLibrarySimulationOrLayoutDiffers) {
  const Store training = made_up_store(10);
  Store test = made_up_store(10, 6);
  test.header.library_hash = 1;
  EXPECT_THAT(refusal_of(training, test), HasSubstr("another library"));
  test = made_up_store(10, 6);
  test.header.simulation = "{}";
  EXPECT_THAT(refusal_of(training, test), HasSubstr("another simulation"));
  test = made_up_store(10, 6);
  derive_features(features::feature_set_named("both")->layout, test);
  EXPECT_THAT(refusal_of(training, test), HasSubstr("other features"));
}

}  // namespace
}  // namespace flinch::train
