// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "tests/runtime/c/c_api_scene.h"
#include "tests/scenes/file_damage.h"

namespace flinch::runtime {
namespace {

using tests::load;
using tests::selector_file;

TEST(CApiLoad, ReportsWhatIsWrongWithAFile) {
  flinch_library* library = nullptr;
  EXPECT_EQ(flinch_library_load("no such file", &library), FLINCH_CANNOT_OPEN);
  EXPECT_EQ(flinch_library_load("/", &library), FLINCH_NOT_A_FILE);
  EXPECT_EQ(flinch_library_load(FLINCH_SOURCE_DIR "/README.md", &library), FLINCH_NOT_A_SELECTOR);
  EXPECT_EQ(flinch_library_load_memory("", 0, &library), FLINCH_NOT_A_SELECTOR);
  const tests::MadeUpSelector made = tests::made_up_selector(
      database::authored_library(motion::default_character()), 60, tests::ModelKind::knn);
  const std::string bare = train::selector_bytes(made.selector);
  EXPECT_EQ(flinch_library_load_memory(bare.data(), bare.size(), &library), FLINCH_WITHOUT_CLIPS);
  std::string later = bare;
  later[7] = '\x7F';
  EXPECT_EQ(flinch_library_load_memory(later.data(), later.size(), &library), FLINCH_OTHER_VERSION);
  EXPECT_EQ(library, nullptr);
}

TEST(CApiLoad, RejectsAFileTruncatedOrChangedAnywhere) {
  const std::string& file = selector_file();
  flinch_library* library = nullptr;
  const auto is_refused = [&](const std::string& damaged) {
    return flinch_library_load_memory(damaged.data(), damaged.size(), &library) < 0 &&
           library == nullptr;
  };
  const std::vector<std::size_t> places = tests::places(file.size(), file.size() / 40, 64);
  tests::expect_wrong_sizes_are_refused(file, places, is_refused);
  std::vector<tests::Flip> flips;
  for (const std::size_t byte : places) flips.push_back({byte, 0x10});
  tests::expect_flips_are_refused(file, flips, is_refused);
  flinch_library_free(load(file));
}

}  // namespace
}  // namespace flinch::runtime
