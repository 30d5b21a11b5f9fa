// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "tests/runtime/c/c_api_scene.h"

namespace flinch::runtime {
namespace {

using tests::load;
using tests::selector_file;

TEST(CApiLoad, ReportsWhatIsWrongWithAFile) {
  flinch_library* library = nullptr;
  EXPECT_EQ(flinch_library_load("no such file", &library), FLINCH_CANNOT_OPEN);
  EXPECT_EQ(flinch_library_load("/", &library), FLINCH_CANNOT_OPEN);
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
  std::string file = selector_file();
  flinch_library* library = nullptr;
  const std::size_t step = file.size() / 40;
  for (std::size_t at = 0; at < file.size(); at += at < 64 ? 1 : step) {
    EXPECT_LT(flinch_library_load_memory(file.data(), at, &library), 0) << "cut at " << at;
    file[at] = static_cast<char>(file[at] ^ 0x10);
    EXPECT_LT(flinch_library_load_memory(file.data(), file.size(), &library), 0) << "byte " << at;
    file[at] = static_cast<char>(file[at] ^ 0x10);
    ASSERT_EQ(library, nullptr);
  }
  flinch_library_free(load(file));
}

}  // namespace
}  // namespace flinch::runtime
