// SPDX-License-Identifier: MIT
#include "evolve/run/evolution_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/error.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/temporary_folder.h"

namespace flinch::evolve {
namespace {

class EvolutionFile : public testing::Test {
 protected:
  tests::TemporaryFolder folder_;
  std::string path_ = folder_ / "run.evolution";
  Evolution evolution_{{{1.0 / 3, 2.5, {1, 2}}, {0.1, 2, {65535, 0}}}, {{3, 4}, {5, 6}, {7, 8}}};

  std::string error(const std::string& bytes, const std::string& key = "key") {
    folder_.write("run.evolution", bytes);
    return tests::error_of([&] { read_evolution(path_, key, 3, 2); });
  }
};

TEST_F(EvolutionFile, IsReadAsItWasWrittenToTheLastBit) {
  write_evolution(path_, "key", evolution_);
  const auto read = read_evolution(path_, "key", 3, 2);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->chromosomes, evolution_.chromosomes);
  ASSERT_EQ(read->history.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(read->history[k].best_fitness, evolution_.history[k].best_fitness);
    EXPECT_EQ(read->history[k].mean_fitness, evolution_.history[k].mean_fitness);
    EXPECT_EQ(read->history[k].best, evolution_.history[k].best);
  }
}

TEST_F(EvolutionFile, IsNothingWhereThereIsNone) {
  EXPECT_FALSE(read_evolution(path_, "key", 3, 2));
}

TEST_F(EvolutionFile, OfOtherOptionsIsRefused) {
  write_evolution(path_, "key", evolution_);
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
  for (const std::string& rest :
       {std::string("\"key\":"), std::string("\"key\":3}"), std::string("\"key\":\"key\"}"),
        std::string("\"key\":\"key\",\"history\":[],\"chromosomes\":[[1,2],[3,4],[5,65536]]}"),
        std::string("\"key\":\"key\",\"history\":[],\"chromosomes\":[[1,2],[3,4],[5,-6]]}"),
        std::string("\"key\":\"key\",\"history\":[[1,2]],\"chromosomes\":[[1,2],[3,4],[5,6]]}"),
        "\"key\":\"key\",\"history\":" + std::string(100000, '[')}) {
    EXPECT_THAT(error(start + rest), testing::HasSubstr("damaged")) << rest.substr(0, 80);
  }
}

}  // namespace
}  // namespace flinch::evolve
