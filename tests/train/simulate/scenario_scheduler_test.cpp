// SPDX-License-Identifier: MIT
#include "train/simulate/scenario_scheduler.h"

#include <gtest/gtest.h>

#include <set>

namespace flinch::train {
namespace {

std::vector<ScenarioRange> all_of(ScenarioScheduler& ranges, int threads = 1) {
  std::vector<ScenarioRange> handed_out;
  while (const auto range = ranges.next(threads)) handed_out.push_back(*range);
  return handed_out;
}

TEST(ScenarioScheduler, AssignsEachMissingScenarioOnce) {
  const std::vector<ScenarioRange> missing{{3, 40}, {100, 1}, {1000, 5000}};
  for (const int workers : {1, 2, 7}) {
    ScenarioScheduler ranges(missing, workers, {128});
    std::set<std::uint64_t> numbers;
    std::uint64_t count = 0;
    for (const ScenarioRange& range : all_of(ranges)) {
      EXPECT_GT(range.count, 0U);
      count += range.count;
      for (std::uint64_t k = range.first; k < range.end(); ++k) numbers.insert(k);
    }
    EXPECT_EQ(count, 5041U);
    EXPECT_EQ(numbers.size(), 5041U);
    for (const ScenarioRange& range : missing) {
      EXPECT_TRUE(numbers.contains(range.first));
      EXPECT_TRUE(numbers.contains(range.end() - 1));
    }
    EXPECT_FALSE(ranges.next(1));
  }
}

TEST(ScenarioScheduler, RangesStartSmallAndGrowToTheMaximum) {
  ScenarioScheduler ranges({{0, 100'000}}, 1, {128});
  const auto handed_out = all_of(ranges);
  EXPECT_EQ(handed_out.front().count, 16U);
  for (std::size_t i = 1; i + 1 < handed_out.size(); ++i)
    EXPECT_GE(handed_out[i].count, handed_out[i - 1].count);
  EXPECT_EQ(handed_out[20].count, 128U);
}

TEST(ScenarioScheduler, RangesGrowAsFastAsTheyAreToldTo) {
  ScenarioScheduler ranges({{0, 3000}}, 1, {1024, 64});
  std::vector<std::uint64_t> sizes;
  for (const ScenarioRange& range : all_of(ranges)) sizes.push_back(range.count);
  EXPECT_EQ(sizes, (std::vector<std::uint64_t>{16, 1024, 1024, 936}));
}

TEST(ScenarioScheduler, RangesShrinkNearTheEnd) {
  ScenarioScheduler ranges({{0, 10'000}}, 10, {128});
  const auto handed_out = all_of(ranges);
  EXPECT_LE(handed_out.back().count, 16U);
  EXPECT_EQ(handed_out[handed_out.size() / 2].count, 128U);
}

TEST(ScenarioScheduler, RangesAreLargerForProcessesWithMoreThreads) {
  ScenarioScheduler ranges({{0, 100'000}}, 1, {128});
  EXPECT_EQ(ranges.next(8)->count, 8 * 16U);
  for (int i = 0; i < 20; ++i) ranges.next(8);
  EXPECT_EQ(ranges.next(8)->count, 8 * 128U);
  EXPECT_EQ(ranges.next(1)->count, 128U);
}

TEST(ScenarioScheduler, AReturnedRangeIsAssignedNext) {
  ScenarioScheduler ranges({{0, 32}}, 2, {128});
  const ScenarioRange first = *ranges.next(1);
  ranges.put_back(first);
  EXPECT_EQ(ranges.next(1)->first, first.first);
  EXPECT_EQ(ranges.next(1)->first, 16U);
  EXPECT_FALSE(ranges.next(1));
}

}  // namespace
}  // namespace flinch::train
