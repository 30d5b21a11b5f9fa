// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>

#include "tests/runtime/c/c_api_scene.h"

namespace flinch::runtime {
namespace {

using tests::ball;
using tests::CApi;
using tests::half_of_everything;
using tests::kInfinity;
using tests::kNan;
using tests::selector_file;
using tests::sized;

TEST_F(CApi, EveryFunctionReportsNullPointers) {
  flinch_pose some_pose = pose();
  flinch_mask mask = half_of_everything();
  auto limits = sized<flinch_perception_limits>();
  auto info = sized<flinch_library_info>();
  auto skeleton = sized<flinch_skeleton>();
  auto clip = sized<flinch_clip>();
  auto frames = sized<flinch_joint_frames>();
  auto what = sized<flinch_character_state>();
  flinch_threat threat = ball();
  flinch_library* new_library = library;
  flinch_workspace* new_workspace = workspace;
  flinch_character* new_character = character;
  std::int32_t count = 0;
  flinch_candidate candidate{};
  const std::string& file = selector_file();
  const std::function<flinch_status()> calls[] = {
      [&] { return flinch_library_load(nullptr, &new_library); },
      [&] { return flinch_library_load("a", nullptr); },
      [&] { return flinch_library_load_memory(nullptr, 4, &new_library); },
      [&] { return flinch_library_load_memory(file.data(), file.size(), nullptr); },
      [&] { return flinch_library_describe(nullptr, &info); },
      [&] { return flinch_library_describe(library, nullptr); },
      [&] { return flinch_library_skeleton(nullptr, &skeleton); },
      [&] { return flinch_library_skeleton(library, nullptr); },
      [&] { return flinch_library_clip(nullptr, 0, &clip); },
      [&] { return flinch_library_clip(library, 0, nullptr); },
      [&] { return flinch_library_joint_frames(nullptr, &some_pose, &frames); },
      [&] { return flinch_library_joint_frames(library, nullptr, &frames); },
      [&] { return flinch_library_joint_frames(library, &some_pose, nullptr); },
      [&] { return flinch_workspace_create(nullptr, &new_workspace); },
      [&] { return flinch_workspace_create(library, nullptr); },
      [&] { return flinch_character_create(nullptr, &new_character); },
      [&] { return flinch_character_create(library, nullptr); },
      [&] { return flinch_character_place(nullptr, 0, 0, 0, 0); },
      [&] { return flinch_character_set_pose(nullptr, &some_pose, &some_pose, 0.1F); },
      [&] { return flinch_character_set_pose(character, nullptr, &some_pose, 0.1F); },
      [&] { return flinch_character_set_pose(character, &some_pose, nullptr, 0.1F); },
      [&] { return flinch_character_settle(nullptr); },
      [&] { return flinch_character_limit_perception(nullptr, &limits, 0); },
      [&] { return flinch_character_limit_perception(character, nullptr, 0); },
      [&] { return flinch_human_limits(1, nullptr); },
      [&] { return flinch_character_perceive(nullptr, &threat, workspace); },
      [&] { return flinch_character_perceive(character, nullptr, workspace); },
      [&] { return flinch_character_perceive(character, &threat, nullptr); },
      [&] { return flinch_character_perceive_known(nullptr, &threat, 0, 1, workspace); },
      [&] { return flinch_character_perceive_known(character, nullptr, 0, 1, workspace); },
      [&] { return flinch_character_perceive_known(character, &threat, 0, 1, nullptr); },
      [&] { return flinch_character_respond(nullptr, 1, 1); },
      [&] { return flinch_character_update(nullptr, 1); },
      [&] { return flinch_character_pose(nullptr, &some_pose); },
      [&] { return flinch_character_pose(character, nullptr); },
      [&] { return flinch_character_pose_over(nullptr, &some_pose, &mask, &some_pose); },
      [&] { return flinch_character_pose_over(character, nullptr, &mask, &some_pose); },
      [&] { return flinch_character_pose_over(character, &some_pose, nullptr, &some_pose); },
      [&] { return flinch_character_pose_over(character, &some_pose, &mask, nullptr); },
      [&] { return flinch_character_describe(nullptr, &what); },
      [&] { return flinch_character_describe(character, nullptr); },
      [&] { return flinch_character_candidates(nullptr, &candidate, 1, &count); },
      [&] { return flinch_character_candidates(character, nullptr, 1, &count); },
      [&] { return flinch_character_candidates(character, &candidate, 1, nullptr); },
  };
  for (std::size_t i = 0; i < std::size(calls); ++i) {
    SCOPED_TRACE(i);
    refuses(FLINCH_NULL_POINTER, calls[i]);
  }
  EXPECT_EQ(new_library, nullptr) << "what was to be made is NULL";
  EXPECT_EQ(new_workspace, nullptr);
  EXPECT_EQ(new_character, nullptr);
  EXPECT_EQ(flinch_library_free(nullptr), FLINCH_OK);
  EXPECT_EQ(flinch_workspace_free(nullptr), FLINCH_OK);
  EXPECT_EQ(flinch_character_free(nullptr), FLINCH_OK);
  EXPECT_EQ(flinch_character_candidates(character, nullptr, 0, &count), FLINCH_OK);
}

TEST_F(CApi, RejectsNonFiniteNumbersAndChangesNothing) {
  ASSERT_EQ(flinch_character_respond(character, 9, 0.4F), FLINCH_OK);
  ASSERT_EQ(flinch_character_update(character, 0.1F), FLINCH_OK);
  for (const float bad : {kNan, kInfinity, -kInfinity, 3e38F, -2e6F}) {
    for (std::size_t i = 0; i < 8; ++i) {
      flinch_threat threat = ball();
      (i < 3   ? threat.position[i]
       : i < 6 ? threat.velocity[i - 3]
       : i < 7 ? threat.radius
               : threat.mass_kg) = bad;
      refuses(FLINCH_BAD_THREAT, [&] { return perceive(threat); });
      refuses(FLINCH_BAD_THREAT, [&] {
        return flinch_character_perceive_known(character, &threat, FLINCH_HEAD, 0.5F, workspace);
      });
    }
  }
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (std::size_t i = 0; i < 3 + 4 * FLINCH_JOINT_COUNT; ++i) {
      flinch_pose changed = pose();
      const flinch_pose good = pose();
      const flinch_mask mask = half_of_everything();
      auto frames = sized<flinch_joint_frames>();
      (i < 3 ? changed.root_position[i] : changed.rotation[(i - 3) / 4][(i - 3) % 4]) = bad;
      refuses(FLINCH_BAD_POSE,
              [&] { return flinch_character_set_pose(character, &changed, &good, 0.1F); });
      refuses(FLINCH_BAD_POSE,
              [&] { return flinch_character_set_pose(character, &good, &changed, 0.1F); });
      refuses(FLINCH_BAD_POSE,
              [&] { return flinch_character_pose_over(character, &changed, &mask, &changed); });
      refuses(FLINCH_BAD_POSE,
              [&] { return flinch_library_joint_frames(library, &changed, &frames); });
    }
    for (const auto place : {&bad}) {
      refuses(FLINCH_BAD_PLACEMENT,
              [&] { return flinch_character_place(character, *place, 0, 0, 0); });
      refuses(FLINCH_BAD_PLACEMENT,
              [&] { return flinch_character_place(character, 0, *place, 0, 0); });
      refuses(FLINCH_BAD_PLACEMENT,
              [&] { return flinch_character_place(character, 0, 0, *place, 0); });
      refuses(FLINCH_BAD_PLACEMENT,
              [&] { return flinch_character_place(character, 0, 0, 0, *place); });
    }
  }
  for (const float bad : {kNan, kInfinity, -kInfinity, 0.0F, -0.5F, 3e38F}) {
    const flinch_threat threat = ball();
    const flinch_pose good = pose();
    refuses(FLINCH_BAD_TIME, [&] { return flinch_character_update(character, bad); });
    refuses(FLINCH_BAD_TIME,
            [&] { return flinch_character_set_pose(character, &good, &good, bad); });
    refuses(FLINCH_BAD_THREAT, [&] { return flinch_character_respond(character, 9, bad); });
    refuses(FLINCH_BAD_THREAT, [&] {
      return flinch_character_perceive_known(character, &threat, FLINCH_HEAD, bad, workspace);
    });
  }
  for (const float bad : {kNan, kInfinity, -0.1F}) {
    for (std::size_t i = 0; i < 6; ++i) {
      auto limits = sized<flinch_perception_limits>();
      (&limits.reaction_delay_s)[i] = bad;
      refuses(FLINCH_BAD_LIMITS,
              [&] { return flinch_character_limit_perception(character, &limits, 0); });
    }
    for (std::size_t i = 0; i <= FLINCH_JOINT_COUNT; ++i) {
      flinch_mask mask = half_of_everything();
      (i == FLINCH_JOINT_COUNT ? mask.weight : mask.joint[i]) = bad;
      flinch_pose game = pose();
      refuses(FLINCH_BAD_MASK,
              [&] { return flinch_character_pose_over(character, &game, &mask, &game); });
    }
  }
  // After all of this, the character still returns to idle.
  for (int i = 0; i < 200; ++i) ASSERT_EQ(flinch_character_update(character, 0.02F), FLINCH_OK);
  EXPECT_EQ(state().phase, FLINCH_IDLE);
  EXPECT_EQ(perceive(ball()), FLINCH_OK);
}

/// A number as games have them, or one that no correct game has.
float any_number(std::mt19937& random) {
  constexpr float kOdd[] = {0,      -0.0F, 1e-45F,    1e-20F,     1e6F, -1e20F, 3e38F,
                            -3e38F, kNan,  kInfinity, -kInfinity, 100,  -1};
  if (random() % 4 == 0) return kOdd[random() % std::size(kOdd)];
  return std::uniform_real_distribution<float>(-2, 3)(random);
}

bool is_sound(const flinch_pose& pose) {
  return std::ranges::all_of(pose.root_position, [](float x) { return std::isfinite(x); }) &&
         std::ranges::all_of(pose.rotation, [](const float(&q)[4]) {
           return std::abs(Eigen::Vector4f(q).norm() - 1) < 1e-3F;
         });
}

// Calls in any order with any arguments give a status and a valid pose.
TEST_F(CApi, PoseStaysValidAfterRandomCalls) {
  std::mt19937 random(1);
  std::map<flinch_status, int> statuses;
  const auto number = [&random] { return any_number(random); };
  for (int call = 0; call < 30000; ++call) {
    flinch_threat threat = ball();
    if (random() % 2 == 0) {
      for (float& x : threat.position) x = 5 * number();
      for (float& x : threat.velocity) x = 10 * number();
    }
    flinch_pose before = pose();
    flinch_pose now = before;
    now.root_position[random() % 3] += number();
    if (random() % 4 == 0) now.rotation[random() % FLINCH_JOINT_COUNT][random() % 4] = number();
    flinch_status status = FLINCH_OK;
    const auto which = random() % 12;
    if (which == 0)
      status = flinch_character_place(character, number(), number(), number(), number());
    if (which == 1) status = flinch_character_set_pose(character, &before, &now, number());
    if (which == 2) status = flinch_character_settle(character);
    if (which == 3) {
      const auto target = static_cast<std::int32_t>(random() % 5);
      status = flinch_character_perceive_known(character, &threat, target, number(), workspace);
    }
    if (which == 4 || which == 5) status = perceive(threat);
    if (which == 6) {
      status =
          flinch_character_respond(character, static_cast<std::int32_t>(random() % 140), number());
    }
    if (which > 6)
      status = flinch_character_update(character, random() % 8 == 0 ? number() : 0.02F);
    ++statuses[status];
    ASSERT_TRUE(is_sound(pose())) << "after call " << call << " of kind " << which;
  }
  for (const flinch_status wanted : {FLINCH_OK, FLINCH_MISSES, FLINCH_BAD_THREAT, FLINCH_BAD_TIME,
                                     FLINCH_BAD_POSE, FLINCH_BAD_PLACEMENT, FLINCH_BAD_CLIP}) {
    EXPECT_GT(statuses[wanted], 10) << flinch_status_message(wanted);
  }
}

TEST_F(CApi, PushSaysWhatIsWrong) {
  constexpr float kAhead[3] = {1, 0, 0};
  constexpr float kNone[3] = {0, 0, 0};
  constexpr std::int32_t kChest = 2;
  const auto push = [&](std::int32_t joint, const float* velocity) {
    return flinch_character_push(character, joint, velocity, workspace);
  };
  ASSERT_STREQ(flinch_joint_name(kChest), "chest");
  refuses(FLINCH_NULL_POINTER, [&] { return push(kChest, nullptr); });
  refuses(FLINCH_NULL_POINTER,
          [&] { return flinch_character_push(nullptr, kChest, kAhead, workspace); });
  refuses(FLINCH_BAD_PUSH, [&] { return push(kChest, kNone); });
  refuses(FLINCH_BAD_PUSH, [&] { return push(-1, kAhead); });
  refuses(FLINCH_BAD_PUSH, [&] { return push(FLINCH_JOINT_COUNT, kAhead); });
  refuses(FLINCH_WITHOUT_PUSHES, [&] { return push(kChest, kAhead); });
  std::int32_t count = -1;
  EXPECT_EQ(flinch_character_push_candidates(character, nullptr, 0, &count), FLINCH_OK);
  EXPECT_EQ(count, 0);
  refuses(FLINCH_NULL_POINTER,
          [&] { return flinch_character_push_candidates(character, nullptr, 1, &count); });
}

TEST_F(CApi, RejectsARotationThatIsNotUnit) {
  flinch_pose stretched = pose();
  stretched.rotation[3][0] *= 1.5F;
  const flinch_pose good = pose();
  refuses(FLINCH_BAD_POSE,
          [&] { return flinch_character_set_pose(character, &stretched, &good, 0.1F); });
}

TEST_F(CApi, RejectsIndicesOutOfRange) {
  auto info = sized<flinch_library_info>();
  ASSERT_EQ(flinch_library_describe(library, &info), FLINCH_OK);
  const flinch_threat threat = ball();
  std::int32_t count = 0;
  auto clip = sized<flinch_clip>();
  for (const std::int32_t index : {-1, info.clip_count, std::numeric_limits<std::int32_t>::max(),
                                   std::numeric_limits<std::int32_t>::min()}) {
    refuses(FLINCH_BAD_INDEX, [&] { return flinch_library_clip(library, index, &clip); });
    refuses(FLINCH_BAD_CLIP, [&] { return flinch_character_respond(character, index, 1); });
    refuses(FLINCH_BAD_INDEX, [&] {
      return flinch_character_perceive_known(character, &threat, index, 0.5F, workspace);
    });
    EXPECT_EQ(flinch_joint_name(index), nullptr);
    EXPECT_EQ(flinch_joint_parent(index), -1);
    EXPECT_EQ(flinch_target_name(index), nullptr);
    EXPECT_EQ(flinch_phase_name(index), nullptr);
  }
  refuses(FLINCH_BAD_INDEX,
          [&] { return flinch_character_candidates(character, nullptr, -1, &count); });
}

TEST(CApiStatus, EachHasAMessageOfItsOwn) {
  std::set<std::string> messages;
  for (flinch_status status = -40; status < 10; ++status) {
    const char* message = flinch_status_message(status);
    ASSERT_NE(message, nullptr);
    EXPECT_GT(std::strlen(message), 1U);
    messages.insert(message);
  }
  EXPECT_EQ(messages.size(), 35U + 1) << "and one for all that are none";
}

}  // namespace
}  // namespace flinch::runtime
