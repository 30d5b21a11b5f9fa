// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>

#include "runtime/c/c_struct.h"
#include "tests/runtime/c/c_api_scene.h"

namespace flinch::runtime {
namespace {

using tests::ball;
using tests::CApi;
using tests::half_of_everything;
using tests::kNan;
using tests::sized;

TEST_F(CApi, AcceptsStructsOfOlderProgramsAndRejectsThoseOfNewerOnes) {
  flinch_threat threat = ball();
  ASSERT_EQ(perceive(threat), FLINCH_OK);
  const flinch_character_state whole = state();
  ASSERT_EQ(flinch_character_place(character, 0, 0, 0, 0), FLINCH_OK);
  threat.radius = kNan;  // ignored: a program with this struct size does not know the radius
  threat.size = offsetof(flinch_threat, radius);
  ASSERT_EQ(perceive(threat), FLINCH_OK);
  const flinch_character_state old = state();
  EXPECT_EQ(std::memcmp(&whole, &old, sizeof old), 0);

  for (const std::uint32_t size : {0U, 4U, 24U, 29U, 84U, 4096U, 0xFFFFFFFFU}) {
    threat.size = size;
    refuses(FLINCH_BAD_SIZE, [&] { return perceive(threat); });
  }
  const auto refuses_sizes = [&](auto value, const auto& call) {
    for (const std::size_t size : {std::size_t{0}, sizeof value - 4, sizeof value + 4}) {
      value.size = static_cast<std::uint32_t>(size);
      const auto before = value;
      refuses(FLINCH_BAD_SIZE, [&] { return call(&value); });
      EXPECT_EQ(std::memcmp(&before, &value, sizeof value), 0);
    }
  };
  auto info = sized<flinch_library_info>();
  info.size = offsetof(flinch_library_info, kind_count);
  info.kind_count = -7;
  EXPECT_EQ(flinch_library_describe(library, &info), FLINCH_OK);
  EXPECT_EQ(info.kind_count, -7) << "which an older program does not have";
  info.size -= 4;
  EXPECT_EQ(flinch_library_describe(library, &info), FLINCH_BAD_SIZE);
  flinch_pose good_pose = pose();
  flinch_mask good_mask = half_of_everything();
  refuses_sizes(flinch_skeleton{}, [&](auto* p) { return flinch_library_skeleton(library, p); });
  refuses_sizes(flinch_clip{}, [&](auto* p) { return flinch_library_clip(library, 0, p); });
  refuses_sizes(flinch_joint_frames{},
                [&](auto* p) { return flinch_library_joint_frames(library, &good_pose, p); });
  refuses_sizes(flinch_pose{}, [&](auto* p) { return flinch_character_pose(character, p); });
  refuses_sizes(good_pose,
                [&](auto* p) { return flinch_character_set_pose(character, p, &good_pose, 0.1F); });
  refuses_sizes(good_mask, [&](auto* p) {
    return flinch_character_pose_over(character, &good_pose, p, &good_pose);
  });
  refuses_sizes(flinch_perception_limits{},
                [&](auto* p) { return flinch_character_limit_perception(character, p, 0); });
  refuses_sizes(flinch_character_state{},
                [&](auto* p) { return flinch_character_describe(character, p); });
}

TEST_F(CApi, WritesNoMoreThanTheCallersStructSize) {
  flinch_threat old = ball();
  old.size = offsetof(flinch_threat, radius);
  old.radius = -7;
  flinch_threat now = sized<flinch_threat>();
  now.radius = 3;
  write_struct(old, now);
  EXPECT_EQ(old.size, offsetof(flinch_threat, radius));
  EXPECT_EQ(old.position[0], 0);
  EXPECT_EQ(old.radius, -7);
}

// Bindings in other languages copy this layout by hand.
TEST(CApiLayout, MatchesThePublishedVersion) {
  EXPECT_EQ(sizeof(flinch_threat), 80U);
  EXPECT_EQ(sizeof(flinch_pose), 16U + 16 * FLINCH_JOINT_COUNT);
  EXPECT_EQ(sizeof(flinch_joint_frames), 4U + 28 * FLINCH_JOINT_COUNT);
  EXPECT_EQ(sizeof(flinch_skeleton), 4U + 24 * FLINCH_JOINT_COUNT);
  EXPECT_EQ(sizeof(flinch_mask), 8U + 4 * FLINCH_JOINT_COUNT);
  EXPECT_EQ(sizeof(flinch_perception_limits), 28U);
  EXPECT_EQ(sizeof(flinch_character_state), 32U);
  EXPECT_EQ(sizeof(flinch_library_info), 24U);
  EXPECT_EQ(sizeof(flinch_kind), 88U);
  EXPECT_EQ(sizeof(flinch_outside), 24U);
  EXPECT_EQ(sizeof(flinch_clip), 24U + 32);
  EXPECT_EQ(sizeof(flinch_candidate), 12U);
}

}  // namespace
}  // namespace flinch::runtime
