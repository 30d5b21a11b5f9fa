// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "runtime/c/flinch.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/scenes/not_finite.h"

// Common set-up of the tests of the C interface.
namespace flinch::tests {

inline const std::string& selector_file() {
  static const std::string kFile =
      made_up_selector(database::authored_library(motion::default_character()), 60, ModelKind::knn)
          .file();
  return kFile;
}

template <class T>
T sized() {
  T value{};
  value.size = sizeof(T);
  return value;
}

inline flinch_library* load(const std::string& file) {
  flinch_library* library = nullptr;
  EXPECT_EQ(flinch_library_load_memory(file.data(), file.size(), &library), FLINCH_OK);
  return library;
}

/// A ball at the head of a character at the origin, from the front left, that hits in half a
/// second.
inline flinch_threat ball() {
  auto threat = sized<flinch_threat>();
  const float velocity[3] = {-16, -8, 2.7F};
  const float position[3] = {8, 4, 1.5F};
  std::copy_n(position, 3, threat.position);
  std::copy_n(velocity, 3, threat.velocity);
  threat.radius = 0.105F;
  threat.mass_kg = 0.27F;
  return threat;
}

inline flinch_mask half_of_everything() {
  auto mask = sized<flinch_mask>();
  mask.weight = 0.5F;
  std::fill(std::begin(mask.joint), std::end(mask.joint), 1.0F);
  return mask;
}

/// A library, a workspace and a character in C.
class CApi : public testing::Test {
 protected:
  void SetUp() override {
    library = load(selector_file());
    ASSERT_EQ(flinch_workspace_create(library, &workspace), FLINCH_OK);
    ASSERT_EQ(flinch_character_create(library, &character), FLINCH_OK);
  }
  void TearDown() override {
    EXPECT_EQ(flinch_character_free(character), FLINCH_OK);
    EXPECT_EQ(flinch_workspace_free(workspace), FLINCH_OK);
    EXPECT_EQ(flinch_library_free(library), FLINCH_OK);
  }

  flinch_pose pose() const {
    auto value = sized<flinch_pose>();
    EXPECT_EQ(flinch_character_pose(character, &value), FLINCH_OK);
    return value;
  }
  flinch_character_state state() const {
    auto value = sized<flinch_character_state>();
    EXPECT_EQ(flinch_character_describe(character, &value), FLINCH_OK);
    return value;
  }
  flinch_status perceive(const flinch_threat& threat) {
    return flinch_character_perceive(character, &threat, workspace);
  }
  /// Expects that the call returns this status and leaves the character unchanged.
  void refuses(flinch_status expected, const std::function<flinch_status()>& call) {
    const flinch_pose pose_before = pose();
    const flinch_character_state state_before = state();
    EXPECT_EQ(call(), expected) << flinch_status_message(expected);
    const flinch_pose pose_after = pose();
    const flinch_character_state state_after = state();
    EXPECT_EQ(std::memcmp(&pose_before, &pose_after, sizeof pose_after), 0);
    EXPECT_EQ(std::memcmp(&state_before, &state_after, sizeof state_after), 0);
  }

  flinch_library* library = nullptr;
  flinch_workspace* workspace = nullptr;
  flinch_character* character = nullptr;
};

}  // namespace flinch::tests
