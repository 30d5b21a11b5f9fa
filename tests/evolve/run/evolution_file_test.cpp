// SPDX-License-Identifier: MIT
#include "evolve/run/evolution_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/error.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/read_cost.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::evolve {
namespace {

class EvolutionFile : public testing::Test {
 protected:
  tests::TemporaryFolder folder_;
  std::string path_ = folder_ / "run.evolution";
  EvolutionSeries series_{
      {{Chromosome{9, 10}, {{0.7, 2.0 / 3, {11, 12}, 1.0 / 7}}}, {std::nullopt, {}}},
      {{{1.0 / 3, 2.5, {1, 2}, 3}, {0.1, 2, {65535, 0}, 0.2}}, {{3, 4}, {5, 6}, {7, 8}}}};

  static void expect_equal(const std::vector<GenerationRecord>& found,
                           const std::vector<GenerationRecord>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_EQ(found[k].best_fitness, expected[k].best_fitness);
      EXPECT_EQ(found[k].mean_fitness, expected[k].mean_fitness);
      EXPECT_EQ(found[k].best, expected[k].best);
      EXPECT_EQ(found[k].check_fitness, expected[k].check_fitness);
    }
  }

  std::string error(const std::string& bytes, const std::string& key = "key") {
    folder_.write("run.evolution", bytes);
    return tests::error_of([&] { read_evolution(path_, key, 3, 2); });
  }
};

TEST_F(EvolutionFile, IsReadAsItWasWrittenToTheLastBit) {
  write_evolution(path_, "key", series_);
  const auto read = read_evolution(path_, "key", 3, 2);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->current.chromosomes, series_.current.chromosomes);
  expect_equal(read->current.history, series_.current.history);
  ASSERT_EQ(read->finished.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(read->finished[k].kept, series_.finished[k].kept);
    expect_equal(read->finished[k].history, series_.finished[k].history);
  }
}

TEST_F(EvolutionFile, BetweenTwoRunsHasNoChromosomes) {
  series_.current = {};
  write_evolution(path_, "key", series_);
  EXPECT_TRUE(read_evolution(path_, "key", 3, 2)->current.chromosomes.empty());
}

TEST_F(EvolutionFile, IsNothingWhereThereIsNone) {
  EXPECT_FALSE(read_evolution(path_, "key", 3, 2));
}

TEST_F(EvolutionFile, OfOtherOptionsIsRefused) {
  write_evolution(path_, "key", series_);
  EXPECT_THAT(tests::error_of([&] { read_evolution(path_, "other", 3, 2); }),
              testing::HasSubstr("an evolution with other options is unfinished here"));
  EXPECT_THAT(tests::error_of([&] { read_evolution(path_, "key", 4, 2); }),
              testing::HasSubstr("damaged"));
  EXPECT_THAT(tests::error_of([&] { read_evolution(path_, "key", 3, 3); }),
              testing::HasSubstr("damaged"));
}

TEST_F(EvolutionFile, ThatIsDamagedIsRefused) {
  EXPECT_THAT(error("height = 3\n"), testing::HasSubstr("is no unfinished evolution"));
  const std::string start(kEvolutionMark);
  const std::string key = "\"key\":\"key\",\"finished\":";
  for (const std::string& rest :
       {std::string("\"key\":"), std::string("\"key\":3}"), std::string("\"key\":\"key\"}"),
        key + "[],\"history\":[],\"chromosomes\":[[1,2],[3,4],[5,65536]]}",
        key + "[],\"history\":[],\"chromosomes\":[[1,2],[3,4],[5,-6]]}",
        key + "[],\"history\":[[1,2]],\"chromosomes\":[[1,2],[3,4],[5,6]]}",
        key + "[],\"history\":[[1,2,[3,4],5]],\"chromosomes\":[]}",
        key + "[[[1],[]]],\"history\":[],\"chromosomes\":[[1,2],[3,4],[5,6]]}",
        key + "[[null]],\"history\":[],\"chromosomes\":[[1,2],[3,4],[5,6]]}",
        key + "null,\"history\":[],\"chromosomes\":[[1,2],[3,4],[5,6]]}",
        key + std::string(100000, '[')}) {
    EXPECT_THAT(error(start + rest), testing::HasSubstr("damaged")) << rest.substr(0, 80);
  }
}

// Three bytes in the file would be forty in memory.
TEST_F(EvolutionFile, WithMoreValuesThanARunHasIsRefusedBeforeTheyTakeMemory) {
  std::string text(kEvolutionMark);
  text.append("\"key\":\"key\",\"history\":[[]");
  for (int k = 0; k < 2'000'000; ++k) text.append(",[]");
  folder_.write("run.evolution", text.append("],\"chromosomes\":[]}"));
  const tests::ReadCost cost;
  EXPECT_THAT(tests::error_of([&] { read_evolution(path_, "key", 3, 2); }),
              testing::HasSubstr("damaged"));
  cost.expect_below(std::size_t{128} << 20);
}

}  // namespace
}  // namespace flinch::evolve
