// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "library_generated.h"
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

TEST(CApiLoad, SelectorsWithoutClipsPlayFromALibraryBesideThem) {
  const tests::MadeUpSelector made = tests::made_up_selector(
      database::authored_library(motion::default_character()), 60, tests::ModelKind::knn);
  const std::string bare = train::selector_bytes(made.selector);
  flinch_library* owner = nullptr;
  ASSERT_EQ(flinch_library_take(made.library_file.data(), made.library_file.size(), &owner),
            FLINCH_OK);
  flinch_library* library = nullptr;
  EXPECT_EQ(flinch_library_load_beside(nullptr, 4, owner, &library), FLINCH_NULL_POINTER);
  EXPECT_EQ(flinch_library_load_beside(bare.data(), bare.size(), nullptr, &library),
            FLINCH_NULL_POINTER);
  EXPECT_EQ(flinch_library_load_beside(bare.data(), bare.size(), owner, nullptr),
            FLINCH_NULL_POINTER);
  EXPECT_EQ(flinch_library_load_beside(bare.data(), 900, owner, &library), FLINCH_DAMAGED);
  EXPECT_EQ(library, nullptr);
  ASSERT_EQ(flinch_library_load_beside(bare.data(), bare.size(), owner, &library), FLINCH_OK);
  EXPECT_EQ(flinch_library_free(owner), FLINCH_OK);
  flinch_workspace* workspace = nullptr;
  flinch_character* character = nullptr;
  ASSERT_EQ(flinch_workspace_create(library, &workspace), FLINCH_OK);
  ASSERT_EQ(flinch_character_create(library, &character), FLINCH_OK);
  auto threat = tests::sized<flinch_threat>();
  threat.position[0] = 6;
  threat.position[2] = 1.5F;
  threat.velocity[0] = -12;
  threat.radius = 0.1F;
  threat.mass_kg = 0.3F;
  EXPECT_GE(flinch_character_perceive(character, &threat, workspace), FLINCH_OK);
  const tests::MadeUpSelector other =
      tests::made_up_selector(scenes::synthetic_library(), 60, tests::ModelKind::knn);
  const std::string foreign = train::selector_bytes(other.selector);
  flinch_library* refused = nullptr;
  EXPECT_EQ(flinch_library_load_beside(foreign.data(), foreign.size(), library, &refused),
            FLINCH_OTHER_CLIPS);
  EXPECT_EQ(refused, nullptr);
  EXPECT_EQ(flinch_character_free(character), FLINCH_OK);
  EXPECT_EQ(flinch_workspace_free(workspace), FLINCH_OK);
  EXPECT_EQ(flinch_library_free(library), FLINCH_OK);
}

TEST(CApiLoad, RefusesALibraryThatNamesAHashOfOtherClips) {
  database::ClipLibrary clips = scenes::synthetic_library();
  clips.provenance = "made by a test";
  const auto with_name = [&clips](char last) {
    clips.name.back() = last;
    return database::library_bytes(clips);
  };
  const std::string one = with_name('1');
  std::string content = tests::content_of(with_name('2'));
  const std::uint64_t hash =
      database::schema::GetLibrary(tests::content_of(one).data())->bare_hash();
  ASSERT_NE(hash, database::schema::GetLibrary(content.data())->bare_hash());
  ASSERT_TRUE(flatbuffers::GetMutableRoot<flatbuffers::Table>(content.data())
                  ->SetField<std::uint64_t>(database::schema::Library::VT_BARE_HASH, hash, 0));
  database::FileFormat format = database::kLibraryFormat;
  format.version = static_cast<std::uint8_t>(one[7]);
  const std::string forged = tests::with_header(format, content);
  const auto taken = [](const std::string& file) {
    flinch_library* library = nullptr;
    const flinch_status status = flinch_library_take(file.data(), file.size(), &library);
    flinch_library_free(library);
    return status;
  };
  EXPECT_EQ(taken(one), FLINCH_OK);
  EXPECT_EQ(taken(forged), FLINCH_OTHER_CONTENT);
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
