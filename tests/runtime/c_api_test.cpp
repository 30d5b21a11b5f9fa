// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <thread>

#include "database/authored_library.h"
#include "motion/default_character.h"
#include "runtime/c_struct.h"
#include "runtime/character.h"
#include "runtime/flinch.h"
#include "tests/runtime/allocation_count.h"
#include "tests/runtime/made_up_selector.h"

namespace flinch::runtime {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

const std::string& selector_file() {
  static const std::string kFile =
      tests::made_up_selector(database::authored_library(motion::default_character()), 60,
                              tests::Fitted::knn)
          .file();
  return kFile;
}

template <class T>
T sized() {
  T value{};
  value.size = sizeof(T);
  return value;
}

flinch_library* load(const std::string& file) {
  flinch_library* library = nullptr;
  EXPECT_EQ(flinch_library_load_memory(file.data(), file.size(), &library), FLINCH_OK);
  return library;
}

/// At the head of a character at the origin, from the front left, there in half a second.
flinch_threat ball() {
  auto threat = sized<flinch_threat>();
  const float velocity[3] = {-16, -8, 2.7F};
  const float position[3] = {8, 4, 1.5F};
  std::copy_n(position, 3, threat.position);
  std::copy_n(velocity, 3, threat.velocity);
  threat.radius = 0.105F;
  threat.mass_kg = 0.27F;
  return threat;
}

flinch_mask half_of_everything() {
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
  /// The call gives this status and leaves the character as it was.
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

bool is_same(const flinch_pose& c, const motion::Pose& ours) {
  bool same = Eigen::Vector3f(c.root_position) == ours.root_position;
  for (const motion::Role role : motion::kRoles) {
    const auto& q = c.rotation[static_cast<std::size_t>(role)];
    const Eigen::Quaternionf& rotation = ours.rotation[role];
    same = same && q[0] == rotation.w() && q[1] == rotation.x() && q[2] == rotation.y() &&
           q[3] == rotation.z();
  }
  return same;
}

TEST_F(CApi, PlaysTheMotionOfTheCxxApiBitForBit) {
  Library ours;
  ASSERT_EQ(ours.load(std::as_bytes(std::span(selector_file()))), database::LoadStatus::ok);
  Workspace our_workspace;
  ASSERT_EQ(our_workspace.make_room(ours.selection_bytes()), database::LoadStatus::ok);
  Character twin(ours);
  twin.place({0.03F, -0.02F}, 0.4F, 1.1F);
  ASSERT_EQ(flinch_character_place(character, 0.03F, -0.02F, 0.4F, 1.1F), FLINCH_OK);

  const flinch_threat threat = ball();
  features::Threat same{.position = {8, 4, 1.5F}, .velocity = {-16, -8, 2.7F}};
  ASSERT_EQ(twin.perceive(same, our_workspace), Status::ok);
  ASSERT_EQ(perceive(threat), FLINCH_OK);
  std::set<std::int32_t> phases;
  for (int frame = 0; frame < 200; ++frame) {
    const float dt_s = frame % 3 == 0 ? 0.031F : 0.008F;
    twin.update(dt_s);
    ASSERT_EQ(flinch_character_update(character, dt_s), FLINCH_OK);
    ASSERT_TRUE(is_same(pose(), twin.pose())) << frame;
    const flinch_character_state now = state();
    phases.insert(now.phase);
    EXPECT_EQ(now.phase, static_cast<int>(twin.phase()));
    EXPECT_STREQ(flinch_phase_name(now.phase), name_of(twin.phase()));
    EXPECT_EQ(now.clip, twin.clip());
    EXPECT_EQ(now.target, static_cast<int>(twin.target()));
    EXPECT_EQ(now.time_to_impact_s, twin.time_to_impact_s());
    EXPECT_EQ(now.position[0], twin.state().position.x());
    EXPECT_EQ(now.facing, twin.state().facing);
  }
  EXPECT_GE(phases.size(), 3U);

  flinch_candidate candidates[FLINCH_MOST_CANDIDATES];
  std::int32_t count = 0;
  ASSERT_EQ(flinch_character_candidates(character, candidates, FLINCH_MOST_CANDIDATES, &count),
            FLINCH_OK);
  ASSERT_EQ(static_cast<std::size_t>(count), twin.candidates().size());
  ASSERT_GT(count, 0);
  for (std::int32_t i = 0; i < count; ++i) {
    EXPECT_EQ(candidates[i].clip, twin.candidates()[static_cast<std::size_t>(i)].clip);
    EXPECT_EQ(candidates[i].vote, twin.candidates()[static_cast<std::size_t>(i)].vote);
    EXPECT_TRUE(std::isnan(candidates[i].expected_cost_ns));
  }
  EXPECT_EQ(flinch_character_candidates(character, candidates, 1, &count), FLINCH_OK);
  EXPECT_EQ(count, 1);
}

TEST_F(CApi, AnswersAKnownThreatWithAClipOfItsChoice) {
  const flinch_threat threat = ball();
  ASSERT_EQ(flinch_character_perceive_known(character, &threat, FLINCH_HEAD, 0.5F, workspace),
            FLINCH_OK);
  EXPECT_EQ(state().target, FLINCH_HEAD);
  EXPECT_FLOAT_EQ(state().time_to_impact_s, 0.5F);
  ASSERT_EQ(flinch_character_respond(character, 7, 0.4F), FLINCH_OK);
  EXPECT_EQ(state().clip, 7);
  EXPECT_FLOAT_EQ(state().time_to_impact_s, 0.4F);
  ASSERT_EQ(flinch_character_settle(character), FLINCH_OK);
  for (int i = 0; i < 200; ++i) ASSERT_EQ(flinch_character_update(character, 0.02F), FLINCH_OK);
  EXPECT_EQ(state().phase, FLINCH_IDLE);
}

TEST_F(CApi, TellsOfTheLibraryWhatTheFileHolds) {
  const database::Library authored = database::authored_library(motion::default_character());
  auto info = sized<flinch_library_info>();
  ASSERT_EQ(flinch_library_describe(library, &info), FLINCH_OK);
  ASSERT_EQ(static_cast<std::size_t>(info.clip_count), authored.clips.size());
  EXPECT_EQ(info.idle_clip, authored.idle);
  EXPECT_EQ(info.rate_hz, authored.rate_hz);
  EXPECT_EQ(info.mass_kg, authored.character.mass_kg);
  for (std::int32_t i = 0; i < info.clip_count; ++i) {
    const motion::Clip& ours = authored.clips[static_cast<std::size_t>(i)];
    auto clip = sized<flinch_clip>();
    ASSERT_EQ(flinch_library_clip(library, i, &clip), FLINCH_OK);
    EXPECT_EQ(clip.name, ours.name);
    EXPECT_EQ(clip.kind, ours.kind);
    EXPECT_EQ(clip.duration_s, ours.motion.duration_s());
    ASSERT_EQ(clip.is_annotated != 0, ours.annotation.has_value());
    if (!ours.annotation) continue;
    EXPECT_EQ(flinch_target_name(clip.target), name_of(ours.annotation->target));
    EXPECT_EQ(clip.direction, ours.annotation->direction);
    EXPECT_EQ(clip.degree, static_cast<int>(ours.annotation->degree));
    EXPECT_EQ(clip.onset_s, ours.annotation->onset_s);
    EXPECT_EQ(clip.peak_s, ours.annotation->peak_s);
    EXPECT_EQ(clip.end_s, ours.annotation->end_s);
  }
}

// Forward kinematics once more, from the skeleton as the C interface tells it.
TEST_F(CApi, JointFramesFollowFromTheSkeletonAndThePose) {
  auto skeleton = sized<flinch_skeleton>();
  auto frames = sized<flinch_joint_frames>();
  ASSERT_EQ(flinch_library_skeleton(library, &skeleton), FLINCH_OK);
  ASSERT_EQ(flinch_character_respond(character, 9, 0.4F), FLINCH_OK);
  ASSERT_EQ(flinch_character_update(character, 0.4F), FLINCH_OK);
  const flinch_pose now = pose();
  ASSERT_EQ(flinch_library_joint_frames(library, &now, &frames), FLINCH_OK);
  std::array<Eigen::Affine3f, FLINCH_JOINT_COUNT> world;
  for (std::int32_t joint = 0; joint < FLINCH_JOINT_COUNT; ++joint) {
    const std::int32_t parent = flinch_joint_parent(joint);
    ASSERT_LT(parent, joint) << "parents come first";
    const float(&q)[4] = now.rotation[joint];
    const Eigen::Vector3f offset(parent < 0 ? now.root_position : skeleton.offset[joint]);
    const Eigen::Affine3f local =
        Eigen::Translation3f(offset) * Eigen::Quaternionf(q[0], q[1], q[2], q[3]);
    world[static_cast<std::size_t>(joint)] =
        parent < 0 ? local : world[static_cast<std::size_t>(parent)] * local;
    const Eigen::Vector3f position(frames.position[joint]);
    EXPECT_LT((position - world[static_cast<std::size_t>(joint)].translation()).norm(), 1e-5F)
        << flinch_joint_name(joint);
  }
}

TEST_F(CApi, LaysItsPoseOverTheGamesWhereTheMaskSaysSo) {
  ASSERT_EQ(flinch_character_respond(character, 9, 0.4F), FLINCH_OK);
  ASSERT_EQ(flinch_character_update(character, 0.4F), FLINCH_OK);
  auto game = sized<flinch_pose>();
  for (auto& rotation : game.rotation) rotation[0] = 1;
  flinch_mask mask = half_of_everything();
  mask.weight = 1;
  mask.joint[12] = 0;  // the right hand stays the game's
  flinch_pose over = game;
  ASSERT_EQ(flinch_character_pose_over(character, &game, &mask, &over), FLINCH_OK);
  const flinch_pose whole = pose();
  for (std::size_t joint = 0; joint < FLINCH_JOINT_COUNT; ++joint) {
    const Eigen::Vector4f expected(joint == 12 ? game.rotation[joint] : whole.rotation[joint]);
    EXPECT_NEAR(std::abs(expected.dot(Eigen::Vector4f(over.rotation[joint]))), 1, 1e-5) << joint;
  }
  EXPECT_NEAR(over.root_position[2], whole.root_position[2], 1e-6);
  // In place.
  ASSERT_EQ(flinch_character_pose_over(character, &game, &mask, &game), FLINCH_OK);
  EXPECT_EQ(std::memcmp(&game, &over, sizeof game), 0);
}

TEST_F(CApi, APersonsLimitsDelayTheAnswer) {
  auto limits = sized<flinch_perception_limits>();
  ASSERT_EQ(flinch_human_limits(1, &limits), FLINCH_OK);
  EXPECT_GT(limits.reaction_delay_s, 0.1F);
  limits.chance_to_fail = 0;
  ASSERT_EQ(flinch_character_limit_perception(character, &limits, 3), FLINCH_OK);
  const flinch_threat threat = ball();
  ASSERT_EQ(flinch_character_perceive_known(character, &threat, FLINCH_HEAD, 0.5F, workspace),
            FLINCH_OK);
  EXPECT_EQ(state().phase, FLINCH_REACTING);
  limits.chance_to_fail = 1;
  ASSERT_EQ(flinch_character_limit_perception(character, &limits, 3), FLINCH_OK);
  EXPECT_EQ(perceive(threat), FLINCH_UNNOTICED);
}

TEST_F(CApi, StructsOfOlderProgramsAreServedAndOfNewerOnesRefused) {
  flinch_threat threat = ball();
  ASSERT_EQ(perceive(threat), FLINCH_OK);
  const flinch_character_state whole = state();
  ASSERT_EQ(flinch_character_place(character, 0, 0, 0, 0), FLINCH_OK);
  threat.radius = kNan;  // not looked at: the program knows of no radius
  threat.size = offsetof(flinch_threat, radius);
  ASSERT_EQ(perceive(threat), FLINCH_OK);
  const flinch_character_state old = state();
  EXPECT_EQ(std::memcmp(&whole, &old, sizeof old), 0);

  for (const std::uint32_t size : {0U, 4U, 24U, 29U, 40U, 4096U, 0xFFFFFFFFU}) {
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
  flinch_pose good_pose = pose();
  flinch_mask good_mask = half_of_everything();
  refuses_sizes(flinch_library_info{},
                [&](auto* p) { return flinch_library_describe(library, p); });
  refuses_sizes(flinch_skeleton{}, [&](auto* p) { return flinch_library_skeleton(library, p); });
  refuses_sizes(flinch_clip{}, [&](auto* p) { return flinch_library_clip(library, 0, p); });
  refuses_sizes(flinch_joint_frames{},
                [&](auto* p) { return flinch_library_joint_frames(library, &good_pose, p); });
  refuses_sizes(flinch_pose{}, [&](auto* p) { return flinch_character_pose(character, p); });
  refuses_sizes(good_pose,
                [&](auto* p) { return flinch_character_stand_in(character, p, &good_pose, 0.1F); });
  refuses_sizes(good_mask, [&](auto* p) {
    return flinch_character_pose_over(character, &good_pose, p, &good_pose);
  });
  refuses_sizes(flinch_perception_limits{},
                [&](auto* p) { return flinch_character_limit_perception(character, p, 0); });
  refuses_sizes(flinch_character_state{},
                [&](auto* p) { return flinch_character_describe(character, p); });
}

TEST_F(CApi, WritesNoMoreThanAnOlderProgramHasRoomFor) {
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

// What other languages write down by hand.
TEST(CApiLayout, IsThatOfThePublishedVersion) {
  EXPECT_EQ(sizeof(flinch_threat), 36U);
  EXPECT_EQ(sizeof(flinch_pose), 16U + 16 * FLINCH_JOINT_COUNT);
  EXPECT_EQ(sizeof(flinch_joint_frames), 4U + 28 * FLINCH_JOINT_COUNT);
  EXPECT_EQ(sizeof(flinch_skeleton), 4U + 24 * FLINCH_JOINT_COUNT);
  EXPECT_EQ(sizeof(flinch_mask), 8U + 4 * FLINCH_JOINT_COUNT);
  EXPECT_EQ(sizeof(flinch_perception_limits), 28U);
  EXPECT_EQ(sizeof(flinch_character_state), 32U);
  EXPECT_EQ(sizeof(flinch_library_info), 20U);
  EXPECT_EQ(sizeof(flinch_clip), 24U + 32);
  EXPECT_EQ(sizeof(flinch_candidate), 8U);
}

TEST_F(CApi, NullIsAStatusEverywhere) {
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
      [&] { return flinch_character_stand_in(nullptr, &some_pose, &some_pose, 0.1F); },
      [&] { return flinch_character_stand_in(character, nullptr, &some_pose, 0.1F); },
      [&] { return flinch_character_stand_in(character, &some_pose, nullptr, 0.1F); },
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

TEST_F(CApi, HandlesOfAnotherKindAreNoticed) {
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

TEST_F(CApi, AWorkspaceServesItsOwnLibrary) {
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

TEST_F(CApi, NumbersThatAreNoneAreRefusedAndHarmNothing) {
  ASSERT_EQ(flinch_character_respond(character, 9, 0.4F), FLINCH_OK);
  ASSERT_EQ(flinch_character_update(character, 0.1F), FLINCH_OK);
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (std::size_t i = 0; i < 7; ++i) {
      flinch_threat threat = ball();
      (i < 3 ? threat.position[i] : i < 6 ? threat.velocity[i - 3] : threat.radius) = bad;
      refuses(FLINCH_BAD_THREAT, [&] { return perceive(threat); });
      refuses(FLINCH_BAD_THREAT, [&] {
        return flinch_character_perceive_known(character, &threat, FLINCH_HEAD, 0.5F, workspace);
      });
    }
    for (std::size_t i = 0; i < 3 + 4 * FLINCH_JOINT_COUNT; ++i) {
      flinch_pose changed = pose();
      const flinch_pose good = pose();
      const flinch_mask mask = half_of_everything();
      auto frames = sized<flinch_joint_frames>();
      (i < 3 ? changed.root_position[i] : changed.rotation[(i - 3) / 4][(i - 3) % 4]) = bad;
      refuses(FLINCH_BAD_POSE,
              [&] { return flinch_character_stand_in(character, &changed, &good, 0.1F); });
      refuses(FLINCH_BAD_POSE,
              [&] { return flinch_character_stand_in(character, &good, &changed, 0.1F); });
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
  for (const float bad : {kNan, kInfinity, -kInfinity, 0.0F, -0.5F}) {
    const flinch_threat threat = ball();
    const flinch_pose good = pose();
    refuses(FLINCH_BAD_TIME, [&] { return flinch_character_update(character, bad); });
    refuses(FLINCH_BAD_TIME,
            [&] { return flinch_character_stand_in(character, &good, &good, bad); });
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
  // After all of this the character still comes back to idle.
  for (int i = 0; i < 200; ++i) ASSERT_EQ(flinch_character_update(character, 0.02F), FLINCH_OK);
  EXPECT_EQ(state().phase, FLINCH_IDLE);
  EXPECT_EQ(perceive(ball()), FLINCH_OK);
}

/// A number as games have them, or one that no sound game has.
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

// Whatever is asked, in whatever order: a status, and a pose that can be drawn.
TEST_F(CApi, AnyCallsLeaveAPoseThatCanBeDrawn) {
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
    if (which == 1) status = flinch_character_stand_in(character, &before, &now, number());
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

TEST_F(CApi, ARotationThatIsNotUnitIsRefused) {
  flinch_pose stretched = pose();
  stretched.rotation[3][0] *= 1.5F;
  const flinch_pose good = pose();
  refuses(FLINCH_BAD_POSE,
          [&] { return flinch_character_stand_in(character, &stretched, &good, 0.1F); });
}

TEST_F(CApi, ThereIsNothingBeyondTheLastIndex) {
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

TEST_F(CApi, NamesAreThoseOfTheCxxApi) {
  for (const motion::Role role : motion::kRoles) {
    const auto joint = static_cast<std::int32_t>(role);
    EXPECT_EQ(flinch_joint_name(joint), motion::name_of(role));
    const auto parent = motion::parent_of(role);
    EXPECT_EQ(flinch_joint_parent(joint), parent ? static_cast<int>(*parent) : -1);
  }
  EXPECT_STREQ(flinch_target_name(FLINCH_TRUNK), "trunk");
  EXPECT_STREQ(flinch_phase_name(FLINCH_IDLE), "idle");
  EXPECT_STREQ(flinch_phase_name(FLINCH_RETURNING), "returning");
}

TEST(CApiStatus, EachHasAMessageOfItsOwn) {
  std::set<std::string> messages;
  for (flinch_status status = -40; status < 10; ++status) {
    const char* message = flinch_status_message(status);
    ASSERT_NE(message, nullptr);
    EXPECT_GT(std::strlen(message), 1U);
    messages.insert(message);
  }
  EXPECT_EQ(messages.size(), 22U + 1) << "and one for all that are none";
}

TEST(CApiLoad, TellsWhatIsWrongWithAFile) {
  flinch_library* library = nullptr;
  EXPECT_EQ(flinch_library_load("no such file", &library), FLINCH_CANNOT_OPEN);
  EXPECT_EQ(flinch_library_load("/", &library), FLINCH_CANNOT_OPEN);
  EXPECT_EQ(flinch_library_load(FLINCH_SOURCE_DIR "/README.md", &library), FLINCH_NOT_A_SELECTOR);
  EXPECT_EQ(flinch_library_load_memory("", 0, &library), FLINCH_NOT_A_SELECTOR);
  const tests::MadeUpSelector made = tests::made_up_selector(
      database::authored_library(motion::default_character()), 60, tests::Fitted::knn);
  const std::string bare = train::selector_bytes(made.selector);
  EXPECT_EQ(flinch_library_load_memory(bare.data(), bare.size(), &library), FLINCH_WITHOUT_CLIPS);
  std::string later = bare;
  later[7] = '\x7F';
  EXPECT_EQ(flinch_library_load_memory(later.data(), later.size(), &library), FLINCH_OTHER_VERSION);
  EXPECT_EQ(library, nullptr);
}

TEST(CApiLoad, RefusesAFileThatIsCutShortOrChangedAnywhere) {
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

TEST(CApiThreads, EachWithAWorkspaceAndCharactersOfItsOwnShareALibrary) {
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

TEST_F(CApi, AllocatesNothingButHandles) {
  const flinch_threat threat = ball();
  const flinch_mask mask = half_of_everything();
  auto frames = sized<flinch_joint_frames>();
  flinch_pose now = pose();
  const std::size_t before = tests::allocation_count();
  for (int frame = 0; frame < 300; ++frame) {
    if (frame % 50 == 10) flinch_character_perceive(character, &threat, workspace);
    if (frame % 100 == 90) flinch_character_stand_in(character, &now, &now, 0.01F);
    flinch_character_update(character, 0.01F);
    flinch_character_pose(character, &now);
    flinch_character_pose_over(character, &now, &mask, &now);
    flinch_library_joint_frames(library, &now, &frames);
    state();
  }
  EXPECT_EQ(tests::allocation_count(), before);
}

#ifdef FLINCH_CHECK_HANDLES
TEST(CApiHandles, AreKnownAfterTheyWereFreed) {
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
