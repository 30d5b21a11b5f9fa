// SPDX-License-Identifier: MIT
// The steps of perceiving, and clips without a selector.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "database/files/library_writer.h"
#include "tests/runtime/c/c_api_scene.h"

namespace flinch {
namespace {

using tests::ball;
using tests::kInfinity;
using tests::kNan;
using tests::sized;

class CApiSteps : public tests::CApi {
 protected:
  flinch_perception noticed() {
    auto perception = sized<flinch_perception>();
    const flinch_threat threat = ball();
    EXPECT_EQ(flinch_character_notice(character, &threat, &perception), FLINCH_OK);
    return perception;
  }
  std::array<flinch_candidate, FLINCH_MOST_CANDIDATES> ranked(const flinch_perception& perception,
                                                              std::int32_t& count) {
    std::array<flinch_candidate, FLINCH_MOST_CANDIDATES> best{};
    EXPECT_EQ(flinch_character_rank(character, &perception, workspace, best.data(),
                                    FLINCH_MOST_CANDIDATES, &count),
              FLINCH_OK);
    return best;
  }
};

TEST_F(CApiSteps, OneAfterTheOtherDoWhatPerceivingDoesBitForBit) {
  auto limits = sized<flinch_perception_limits>();
  limits.reaction_delay_s = 0.1F;
  limits.distance_noise = 0.002F;  // a little, so that it hits
  flinch_character* other = nullptr;
  ASSERT_EQ(flinch_character_create(library, &other), FLINCH_OK);
  for (flinch_character* one : {character, other})
    ASSERT_EQ(flinch_character_limit_perception(one, &limits, 5), FLINCH_OK);
  const flinch_threat threat = ball();
  ASSERT_EQ(flinch_character_perceive(other, &threat, workspace), FLINCH_OK);

  const flinch_perception perception = noticed();
  EXPECT_EQ(perception.delay_s, 0.1F);
  EXPECT_EQ(perception.threat.size, sizeof(flinch_threat));
  EXPECT_NE(std::memcmp(perception.threat.position, threat.position, sizeof threat.position), 0);
  std::int32_t count = 0;
  const auto best = ranked(perception, count);
  ASSERT_GT(count, 0);
  ASSERT_EQ(flinch_character_answer(character, &perception, best[0].clip, best.data(), count),
            FLINCH_OK);
  for (int frame = 0; frame < 90; ++frame) {
    auto poses = std::array{sized<flinch_pose>(), sized<flinch_pose>()};
    auto states = std::array{sized<flinch_character_state>(), sized<flinch_character_state>()};
    for (std::size_t i = 0; i < 2; ++i) {
      flinch_character* one = i == 0 ? character : other;
      ASSERT_EQ(flinch_character_pose(one, &poses[i]), FLINCH_OK);
      ASSERT_EQ(flinch_character_describe(one, &states[i]), FLINCH_OK);
      ASSERT_EQ(flinch_character_update(one, 1.0F / 60), FLINCH_OK);
    }
    ASSERT_EQ(std::memcmp(&poses[0], &poses[1], sizeof poses[0]), 0) << frame;
    ASSERT_EQ(std::memcmp(&states[0], &states[1], sizeof states[0]), 0) << frame;
  }
  EXPECT_EQ(flinch_character_free(other), FLINCH_OK);
}

TEST_F(CApiSteps, APlanShowsThePosesThatTheAnswerPlays) {
  const flinch_perception perception = noticed();
  std::int32_t count = 0;
  const std::int32_t clip = ranked(perception, count)[0].clip;
  auto plan = sized<flinch_plan>();
  ASSERT_EQ(flinch_character_plan(character, &perception, clip, &plan), FLINCH_OK);
  EXPECT_LE(plan.first_motion_s, plan.begin_s);
  EXPECT_LT(plan.begin_s, plan.peak_s);
  EXPECT_LT(plan.peak_s, plan.end_s);
  EXPECT_LT(plan.end_s, plan.duration_s);
  std::array<flinch_pose, 3> planned{};
  for (std::size_t i = 0; i < planned.size(); ++i) {
    planned[i].size = sizeof planned[i];
    ASSERT_EQ(flinch_character_planned_pose(character, &perception, clip,
                                            0.25F * static_cast<float>(i), &planned[i]),
              FLINCH_OK);
  }
  ASSERT_EQ(flinch_character_answer(character, &perception, clip, nullptr, 0), FLINCH_OK);
  for (const flinch_pose& wanted : planned) {
    const flinch_pose shown = pose();
    EXPECT_EQ(std::memcmp(&shown, &wanted, sizeof shown), 0);
    ASSERT_EQ(flinch_character_update(character, 0.25F), FLINCH_OK);
  }
}

TEST_F(CApiSteps, SeveralAreNoticedTheMostUrgentFirst) {
  std::array threats{ball(), ball(), ball()};
  threats[0].position[0] *= 1.5F;  // later
  threats[0].position[1] *= 1.5F;
  threats[2].velocity[0] *= -1;  // flies away
  std::array<flinch_perception, 3> out{};
  for (flinch_perception& one : out) one.size = sizeof one;
  std::int32_t count = -1;
  ASSERT_EQ(flinch_character_notice_all(character, threats.data(), 3, out.data(), 3, &count),
            FLINCH_OK);
  ASSERT_EQ(count, 2);
  EXPECT_LT(out[0].time_to_impact_s, out[1].time_to_impact_s);
  EXPECT_EQ(out[0].threat.position[0], threats[1].position[0]);
  ASSERT_EQ(flinch_character_notice_all(character, threats.data(), 3, out.data(), 1, &count),
            FLINCH_OK);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(out[0].threat.position[0], threats[1].position[0]);
  threats[1].radius = kNan;
  refuses(FLINCH_BAD_THREAT, [&] {
    return flinch_character_notice_all(character, threats.data(), 3, out.data(), 3, &count);
  });
  EXPECT_EQ(count, 1);
  out[0].size = 8;
  refuses(FLINCH_BAD_SIZE, [&] {
    return flinch_character_notice_all(character, threats.data(), 1, out.data(), 3, &count);
  });
}

TEST_F(CApiSteps, ForgedPerceptionsAreRefused) {
  const flinch_perception good = noticed();
  std::int32_t count = 0;
  const std::int32_t clip = ranked(good, count)[0].clip;
  std::array<flinch_perception, 12> forged;
  forged.fill(good);
  forged[0].target = 4;
  forged[1].target = -1;
  forged[2].time_to_impact_s = kNan;
  forged[3].time_to_impact_s = 0;
  forged[4].time_to_impact_s = 101;
  forged[5].delay_s = -1;
  forged[6].delay_s = kInfinity;
  forged[7].position[1] = 3e5F;  // farther than one that walks at the edge can be
  forged[8].facing = kNan;
  forged[9].stance = 1000;
  forged[10].threat.velocity[2] = kNan;
  forged[11].threat.kind = 77;
  auto plan = sized<flinch_plan>();
  auto shown = sized<flinch_pose>();
  flinch_candidate best{};
  for (const flinch_perception& one : forged) {
    refuses(FLINCH_BAD_THREAT,
            [&] { return flinch_character_answer(character, &one, clip, nullptr, 0); });
    refuses(FLINCH_BAD_THREAT, [&] { return flinch_character_plan(character, &one, clip, &plan); });
    refuses(FLINCH_BAD_THREAT,
            [&] { return flinch_character_planned_pose(character, &one, clip, 0, &shown); });
    refuses(FLINCH_BAD_THREAT,
            [&] { return flinch_character_rank(character, &one, workspace, &best, 1, &count); });
  }
  for (const std::int32_t wrong : {-1, 100'000}) {
    refuses(FLINCH_BAD_CLIP,
            [&] { return flinch_character_answer(character, &good, wrong, nullptr, 0); });
    refuses(FLINCH_BAD_CLIP, [&] { return flinch_character_plan(character, &good, wrong, &plan); });
    best.clip = wrong;
    refuses(FLINCH_BAD_CLIP,
            [&] { return flinch_character_answer(character, &good, clip, &best, 1); });
  }
  flinch_perception delayed = good;
  delayed.delay_s = 2;
  EXPECT_EQ(flinch_character_plan(character, &delayed, clip, &plan), FLINCH_MISSES);
  refuses(FLINCH_BAD_TIME,
          [&] { return flinch_character_planned_pose(character, &good, clip, kNan, &shown); });
}

TEST_F(CApiSteps, ClipsWithoutASelectorAnswerByRuleOrAsTold) {
  const std::string file =
      database::library_bytes(database::authored_library(motion::default_character()));
  flinch_library* clips = nullptr;
  ASSERT_EQ(flinch_library_take(file.data(), file.size(), &clips), FLINCH_OK);
  flinch_character* told = nullptr;
  flinch_workspace* room = nullptr;
  ASSERT_EQ(flinch_character_create(clips, &told), FLINCH_OK);
  ASSERT_EQ(flinch_workspace_create(clips, &room), FLINCH_OK);
  const flinch_threat threat = ball();
  EXPECT_EQ(flinch_character_perceive(told, &threat, room), FLINCH_WITHOUT_SELECTOR);
  EXPECT_EQ(flinch_character_brace(told, &threat, 0), FLINCH_OK);
  EXPECT_EQ(flinch_character_respond(told, 1, 0.5F), FLINCH_OK);
  auto perception = sized<flinch_perception>();
  EXPECT_EQ(flinch_character_notice(told, &threat, &perception), FLINCH_OK);
  std::int32_t count = 0;
  flinch_candidate best{};
  EXPECT_EQ(flinch_character_rank(told, &perception, room, &best, 1, &count),
            FLINCH_WITHOUT_SELECTOR);
  EXPECT_EQ(flinch_character_answer(told, &perception, 1, nullptr, 0), FLINCH_OK);
  EXPECT_EQ(flinch_character_free(told), FLINCH_OK);
  EXPECT_EQ(flinch_workspace_free(room), FLINCH_OK);
  EXPECT_EQ(flinch_library_free(clips), FLINCH_OK);
  for (const std::string& wrong : {tests::selector_file(), std::string(), file.substr(0, 900)}) {
    EXPECT_LT(flinch_library_take(wrong.data(), wrong.size(), &clips), 0);
    EXPECT_EQ(clips, nullptr);
  }
}

}  // namespace
}  // namespace flinch
