// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/lookahead/trained_library.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/scenes/not_finite.h"

namespace flinch::lookahead {
namespace {

using tests::trained;

using runtime::Character;
using runtime::Status;

const features::Scenario& scenario() {
  return trained().observations[3].scenario;
}

LookAheadStatus answer(std::span<const features::Threat> threats, const LookAhead& look_ahead) {
  LookAheadWorkspace workspace = trained().workspace();
  Character character = tests::character_of(trained(), scenario());
  return perceive(character, threats, look_ahead, workspace);
}

TEST(LookAheadBadInput, AnyNumberOfCandidatesIsClamped) {
  const std::array threats{scenario().threat};
  for (const int few : {0, -7, 1}) EXPECT_EQ(answer(threats, {.candidates = few}).count, 1U);
  const LookAheadStatus many = answer(threats, {.candidates = 1000});
  EXPECT_EQ(many.status, Status::ok);
  EXPECT_GT(many.count, 1U);
  EXPECT_LE(many.count, kMaxCandidates);
}

TEST(LookAheadBadInput, ABudgetOfNothingGivesTheSelectorsFirst) {
  for (const double us : {0.0, -1.0, std::nan("")}) {
    const Budget nothing{.us = us, .now_us = [](void*) { return 5.0; }, .clock = nullptr};
    const std::array threats{scenario().threat};
    const LookAheadStatus status = answer(threats, {.candidates = 8, .budget = nothing});
    EXPECT_EQ(status.status, Status::ok);
    EXPECT_EQ(status.chosen, 0U);
    EXPECT_EQ(status.tried, 0U);
    EXPECT_EQ(status.encounters, 0U);
    EXPECT_FALSE(status.is_complete);
    EXPECT_EQ(status.candidates[0].foreseen, Foreseen::nothing);
  }
}

TEST(LookAheadBadInput, ABudgetIsExceededByOneEncounterAtMost) {
  // A clock that an encounter alone moves on: it is asked before each, and each takes 10 us.
  double now_us = 0;
  const Budget budget{.us = 25,
                      .now_us = [](void* clock) { return *static_cast<double*>(clock) += 10; },
                      .clock = &now_us};
  const std::array threats{scenario().threat};
  const LookAheadStatus status = answer(threats, {.candidates = 16, .budget = budget});
  EXPECT_LE(status.encounters, 2U);
  EXPECT_FALSE(status.is_complete);
}

TEST(LookAheadBadInput, AThreatThatIsNotUsableRefusesAllAndChangesNothing) {
  features::Threat bad = scenario().threat;
  bad.velocity.x() = tests::kNan;
  const std::array threats{scenario().threat, bad};
  LookAheadWorkspace workspace = trained().workspace();
  Character character = tests::character_of(trained(), scenario());
  character.limit_perception(runtime::human_limits(), 5);
  EXPECT_EQ(perceive(character, threats, {}, workspace).status, Status::bad_threat);
  EXPECT_EQ(character.phase(), runtime::Phase::idle);
  // No random numbers were drawn.
  Character fresh = tests::character_of(trained(), scenario());
  fresh.limit_perception(runtime::human_limits(), 5);
  runtime::Perception expected;
  runtime::Perception found;
  EXPECT_EQ(character.notice(scenario().threat, found), fresh.notice(scenario().threat, expected));
  EXPECT_EQ(found.scenario.threat.position, expected.scenario.threat.position);
}

TEST(LookAheadBadInput, NoThreatOrOneThatNeverArrivesMisses) {
  EXPECT_EQ(answer({}, {}).status, Status::misses);
  features::Threat leaving = scenario().threat;
  leaving.velocity = -leaving.velocity;
  leaving.position = {0, 30, 2};
  features::Threat resting;
  resting.position = {4, 0, 0.105F};
  EXPECT_EQ(answer(std::array{leaving, resting}, {}).status, Status::misses);
}

TEST(LookAheadBadInput, AThreatInsideTheBodyIsAnswered) {
  features::Threat inside = scenario().threat;
  inside.position = {0, 0, 1};
  const LookAheadStatus status = answer(std::array{inside}, {});
  EXPECT_EQ(status.status, Status::ok);
  EXPECT_GT(status.count, 0U);
}

TEST(LookAheadBadInput, ThreatsThatOverlapCountOnceEach) {
  const LookAheadStatus one = answer(std::array{scenario().threat}, {.candidates = 2});
  const LookAheadStatus two =
      answer(std::array{scenario().threat, scenario().threat}, {.candidates = 2});
  EXPECT_EQ(two.threats, 2U);
  EXPECT_NEAR(two.candidates[0].damage_ns, 2 * one.candidates[0].damage_ns, 1e-5F);
}

TEST(LookAheadBadInput, OfHundredsTheMostUrgentAreAnswered) {
  std::vector<features::Threat> threats(300, scenario().threat);
  features::Threat sooner = features::advanced(scenario().threat, 0.05F);
  threats.back() = sooner;
  const LookAheadStatus status = answer(threats, {.candidates = 2});
  EXPECT_EQ(status.status, Status::ok);
  EXPECT_EQ(status.threats, kMaxThreats);
  EXPECT_EQ(status.ignored, 300 - kMaxThreats);
  LookAheadWorkspace workspace = trained().workspace();
  Character character = tests::character_of(trained(), scenario());
  perceive(character, threats, {.candidates = 2}, workspace);
  Character expected = tests::character_of(trained(), scenario());
  runtime::Perception urgent;
  expected.notice(sooner, urgent);
  EXPECT_EQ(character.time_to_impact_s(), urgent.scenario.time_to_impact_s);
}

TEST(LookAheadBadInput, WithoutDataOrMemoryOrWithAnotherLibraryItIsRefused) {
  const runtime::Library empty;
  EXPECT_EQ(make_look_ahead_data(empty), nullptr);
  LookAheadWorkspace workspace;
  EXPECT_FALSE(workspace.reserve_memory(trained().library, nullptr));
  EXPECT_FALSE(workspace.reserve_memory(empty, trained().data));
  const std::array threats{scenario().threat};
  Character character = tests::character_of(trained(), scenario());
  EXPECT_EQ(perceive(character, threats, {}, workspace).status, Status::other_workspace);
  Character unloaded(empty);
  EXPECT_EQ(perceive(unloaded, threats, {}, workspace).status, Status::not_loaded);
}

TEST(LookAheadBadInput, ASelectorWithoutCostsHasNoData) {
  const std::string file =
      tests::made_up_selector(scenes::synthetic_library(), 50, tests::ModelKind::knn).file();
  runtime::Library library;
  ASSERT_EQ(library.load(std::as_bytes(std::span(file))), database::LoadStatus::ok);
  EXPECT_EQ(make_look_ahead_data(library), nullptr);
}

}  // namespace
}  // namespace flinch::lookahead
