// SPDX-License-Identifier: MIT
// Several threats at once, without looking ahead.
#include <gtest/gtest.h>

#include <vector>

#include "motion/rotation.h"
#include "runtime/character.h"
#include "runtime/response/prepared_library.h"
#include "tests/runtime/loaded_selector.h"
#include "tests/scenes/allocation_count.h"
#include "tests/scenes/not_finite.h"

namespace flinch::runtime {
namespace {

constexpr float kFrame_s = 1.0F / 60;

const Library& loaded_library() {
  static const Library kLibrary = tests::loaded_selector(400, tests::ModelKind::knn);
  return kLibrary;
}

Workspace selection_memory() {
  Workspace workspace;
  workspace.reserve_memory(loaded_library().selection_bytes());
  return workspace;
}

/// A ball at the trunk of a character at the origin, from this direction, there in `time_s`.
features::Threat ball_in(float time_s, float azimuth_degrees) {
  features::ThreatDescription approach;
  approach.azimuth = motion::radians(azimuth_degrees);
  approach.elevation = motion::radians(20);
  approach.speed_mps = 14;
  approach.time_to_impact_s = time_s;
  return features::threat_from_description(approach, {0, 0, 1.2F}, 0);
}

/// What the selector chooses for one ball alone.
Character answering(const features::Threat& threat) {
  Workspace workspace = selection_memory();
  Character character(loaded_library());
  EXPECT_EQ(character.perceive(threat, workspace), Status::ok);
  return character;
}

TEST(SeveralThreats, TheMostUrgentIsAnsweredFirstAndThenTheNext) {
  Workspace workspace = selection_memory();
  const features::Threat soon = ball_in(0.5F, 30);
  const features::Threat late = ball_in(1.3F, -100);
  const Character first = answering(soon);
  const Character second = answering(late);
  for (const bool in_order : {true, false}) {
    Character character(loaded_library());
    const std::array threats{in_order ? soon : late, in_order ? late : soon};
    ASSERT_EQ(character.perceive(threats, workspace), Status::ok);
    EXPECT_EQ(character.clip(), first.clip());
    EXPECT_EQ(character.time_to_impact_s(), first.time_to_impact_s());
    float time_s = 0;
    while (time_s < first.time_to_impact_s()) {
      EXPECT_EQ(character.clip(), first.clip()) << time_s;
      character.update(kFrame_s);
      time_s += kFrame_s;
    }
    EXPECT_EQ(character.clip(), second.clip());
    EXPECT_EQ(character.target(), second.target());
    EXPECT_NEAR(character.time_to_impact_s(), second.time_to_impact_s() - time_s, 1e-4F);
    EXPECT_NEAR(character.response().peak_s, character.time_to_impact_s(), 0.05F);
  }
}

TEST(SeveralThreats, OneThatFollowsTooSoonIsLeftToTheResponseThatPlays) {
  Workspace workspace = selection_memory();
  Character character(loaded_library());
  ASSERT_EQ(character.perceive(std::array{ball_in(0.6F, 0), ball_in(0.75F, 90)}, workspace),
            Status::ok);
  const int clip = character.clip();
  for (float time_s = 0; time_s < 0.8F; time_s += kFrame_s) {
    EXPECT_EQ(character.clip(), clip);
    character.update(kFrame_s);
  }
}

TEST(SeveralThreats, ALaterCallForgetsThoseThatWait) {
  Workspace workspace = selection_memory();
  Character character(loaded_library());
  const std::array threats{ball_in(0.4F, 30), ball_in(1.3F, -100)};
  ASSERT_EQ(character.perceive(threats, workspace), Status::ok);
  ASSERT_EQ(character.respond(answering(threats[0]).clip(), 0.4F), Status::ok);
  Character alone(loaded_library());
  alone.respond(character.clip(), 0.4F);
  for (int frame = 0; frame < 120; ++frame) {
    EXPECT_EQ(character.clip(), alone.clip());
    character.update(kFrame_s);
    alone.update(kFrame_s);
  }
}

TEST(SeveralThreats, OneThatIsNotUsableRefusesAll) {
  Workspace workspace = selection_memory();
  features::Threat bad = ball_in(0.5F, 0);
  bad.mass_kg = tests::kNan;
  Character character(loaded_library());
  EXPECT_EQ(character.perceive(std::array{ball_in(0.5F, 0), bad}, workspace), Status::bad_threat);
  EXPECT_EQ(character.phase(), Phase::idle);
  EXPECT_TRUE(std::isinf(character.time_to_impact_s()));
}

TEST(SeveralThreats, NoneAndThoseThatMissAreNotAnswered) {
  Workspace workspace = selection_memory();
  Character character(loaded_library());
  EXPECT_EQ(character.perceive(std::span<const features::Threat>{}, workspace), Status::misses);
  features::Threat leaving = ball_in(0.5F, 0);
  leaving.velocity = -leaving.velocity;
  EXPECT_EQ(character.perceive(std::array{leaving, leaving}, workspace), Status::misses);
  Workspace small;
  EXPECT_EQ(character.perceive(std::array{ball_in(0.5F, 0)}, small), Status::other_workspace);
  EXPECT_EQ(character.phase(), Phase::idle);
}

TEST(SeveralThreats, OfHundredsTheMostUrgentAreAnsweredWithoutAllocations) {
  Workspace workspace = selection_memory();
  std::vector<features::Threat> threats;
  for (int i = 0; i < 300; ++i)
    threats.push_back(ball_in(1.4F - 0.003F * static_cast<float>(i), static_cast<float>(i)));
  Character character(loaded_library());
  std::array<Perception, Character::kMaxThreats> urgent;
  Character noticing = character;
  const Notice notice = noticing.notice(threats, urgent);
  EXPECT_EQ(notice.count, urgent.size());
  EXPECT_EQ(notice.count + notice.ignored, threats.size());
  for (std::size_t i = 1; i < urgent.size(); ++i)
    EXPECT_LE(urgent[i - 1].scenario.time_to_impact_s, urgent[i].scenario.time_to_impact_s);
  const std::size_t allocations = tests::allocation_count();
  ASSERT_EQ(character.perceive(threats, workspace), Status::ok);
  for (int frame = 0; frame < 180; ++frame) character.update(kFrame_s);
  EXPECT_EQ(tests::allocation_count(), allocations);
}

}  // namespace
}  // namespace flinch::runtime
