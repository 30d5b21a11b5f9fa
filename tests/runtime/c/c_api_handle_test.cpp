// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <thread>

#include "tests/runtime/c/c_api_scene.h"

namespace flinch::runtime {
namespace {

using tests::ball;
using tests::CApi;
using tests::load;
using tests::selector_file;
using tests::sized;

TEST_F(CApi, RejectsHandlesOfAnotherKind) {
  auto* as_character = reinterpret_cast<flinch_character*>(library);
  auto* as_library = reinterpret_cast<flinch_library*>(character);
  auto info = sized<flinch_library_info>();
  flinch_character* made = nullptr;
  refuses(FLINCH_BAD_HANDLE, [&] { return flinch_character_update(as_character, 0.1F); });
  refuses(FLINCH_BAD_HANDLE, [&] { return flinch_character_free(as_character); });
  refuses(FLINCH_BAD_HANDLE, [&] { return flinch_library_describe(as_library, &info); });
  refuses(FLINCH_BAD_HANDLE, [&] { return flinch_character_create(as_library, &made); });
  refuses(FLINCH_BAD_HANDLE, [&] {
    const flinch_threat threat = ball();
    return flinch_character_perceive(character, &threat,
                                     reinterpret_cast<flinch_workspace*>(library));
  });
}

TEST_F(CApi, RejectsAWorkspaceOfAnotherLibrary) {
  flinch_library* other = load(selector_file());
  flinch_workspace* its = nullptr;
  ASSERT_EQ(flinch_workspace_create(other, &its), FLINCH_OK);
  const flinch_threat threat = ball();
  refuses(FLINCH_OTHER_LIBRARY, [&] { return flinch_character_perceive(character, &threat, its); });
  refuses(FLINCH_OTHER_LIBRARY, [&] {
    return flinch_character_perceive_known(character, &threat, FLINCH_HEAD, 0.5F, its);
  });
  flinch_workspace_free(its);
  flinch_library_free(other);
  EXPECT_EQ(perceive(threat), FLINCH_OK);
}

TEST(CApiHandles, ALibraryMayBeFreedBeforeItsCharacters) {
  flinch_library* library = load(selector_file());
  flinch_workspace* workspace = nullptr;
  flinch_character* character = nullptr;
  ASSERT_EQ(flinch_workspace_create(library, &workspace), FLINCH_OK);
  ASSERT_EQ(flinch_character_create(library, &character), FLINCH_OK);
  ASSERT_EQ(flinch_library_free(library), FLINCH_OK);
  const flinch_threat threat = ball();
  EXPECT_EQ(flinch_character_perceive(character, &threat, workspace), FLINCH_OK);
  EXPECT_EQ(flinch_character_update(character, 0.2F), FLINCH_OK);
  EXPECT_EQ(flinch_workspace_free(workspace), FLINCH_OK);
  EXPECT_EQ(flinch_character_free(character), FLINCH_OK);
}

TEST(CApiThreads, ShareALibraryWithAWorkspaceAndCharactersPerThread) {
  flinch_library* library = load(selector_file());
  std::array<flinch_pose, 4> end{};
  std::array<std::thread, 4> threads;
  for (std::size_t i = 0; i < threads.size(); ++i) {
    threads[i] = std::thread([library, &last = end[i]] {
      flinch_workspace* workspace = nullptr;
      flinch_character* character = nullptr;
      flinch_workspace_create(library, &workspace);
      flinch_character_create(library, &character);
      const flinch_threat threat = ball();
      for (int frame = 0; frame < 60; ++frame) {
        if (frame == 10) flinch_character_perceive(character, &threat, workspace);
        flinch_character_update(character, 1.0F / 60);
      }
      last.size = sizeof last;
      flinch_character_pose(character, &last);
      flinch_character_free(character);
      flinch_workspace_free(workspace);
    });
  }
  for (std::thread& thread : threads) thread.join();
  flinch_library_free(library);
  EXPECT_GT(end[0].root_position[2], 0.1F);
  for (const flinch_pose& pose : end) EXPECT_EQ(std::memcmp(&pose, &end[0], sizeof pose), 0);
}

#ifdef FLINCH_CHECK_HANDLES
TEST(CApiHandles, UseAfterFreeIsReported) {
  flinch_library* library = load(selector_file());
  flinch_workspace* workspace = nullptr;
  flinch_character* character = nullptr;
  flinch_character* another = nullptr;
  ASSERT_EQ(flinch_workspace_create(library, &workspace), FLINCH_OK);
  ASSERT_EQ(flinch_character_create(library, &character), FLINCH_OK);
  ASSERT_EQ(flinch_character_create(library, &another), FLINCH_OK);
  const flinch_threat threat = ball();
  auto pose = sized<flinch_pose>();
  auto info = sized<flinch_library_info>();

  ASSERT_EQ(flinch_character_free(character), FLINCH_OK);
  EXPECT_EQ(flinch_character_free(character), FLINCH_BAD_HANDLE);
  EXPECT_EQ(flinch_character_update(character, 0.1F), FLINCH_BAD_HANDLE);
  EXPECT_EQ(flinch_character_pose(character, &pose), FLINCH_BAD_HANDLE);
  EXPECT_EQ(flinch_character_perceive(character, &threat, workspace), FLINCH_BAD_HANDLE);
  ASSERT_EQ(flinch_workspace_free(workspace), FLINCH_OK);
  EXPECT_EQ(flinch_workspace_free(workspace), FLINCH_BAD_HANDLE);
  EXPECT_EQ(flinch_character_perceive(another, &threat, workspace), FLINCH_BAD_HANDLE);
  ASSERT_EQ(flinch_library_free(library), FLINCH_OK);
  EXPECT_EQ(flinch_library_free(library), FLINCH_BAD_HANDLE);
  EXPECT_EQ(flinch_library_describe(library, &info), FLINCH_BAD_HANDLE);
  EXPECT_EQ(flinch_character_create(library, &character), FLINCH_BAD_HANDLE);
  EXPECT_EQ(flinch_character_update(another, 0.1F), FLINCH_OK) << "others live on";
  EXPECT_EQ(flinch_character_free(another), FLINCH_OK);
}
#endif

}  // namespace
}  // namespace flinch::runtime
