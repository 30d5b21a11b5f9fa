// SPDX-License-Identifier: MIT
// Looking ahead, and several threats, in C.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/runtime/c/c_api_scene.h"
#include "tests/scenes/allocation_count.h"

namespace flinch::runtime {
namespace {

using tests::ball;
using tests::kNan;
using tests::sized;

/// The file of a selector that knows what clips cost: work alike for all of them.
const std::string& file_with_costs() {
  static const std::string kFile = [] {
    tests::MadeUpSelector made = tests::made_up_selector(
        database::authored_library(motion::default_character()), 60, tests::ModelKind::knn);
    models::ResponseCosts& costs = made.selector.costs.emplace();
    for (double& vulnerability : costs.vulnerability) vulnerability = 0.5;
    costs.reference_damage_ns = {13};
    costs.reference_work_j = 300;
    costs.work_j.assign(made.selector.clips.size(), 40);
    return made.file();
  }();
  return kFile;
}

class CApiLookAhead : public testing::Test {
 protected:
  void SetUp() override {
    library = tests::load(file_with_costs());
    ASSERT_EQ(flinch_workspace_create(library, &workspace), FLINCH_OK);
    ASSERT_EQ(flinch_look_ahead_create(library, &look_ahead), FLINCH_OK);
    ASSERT_EQ(flinch_character_create(library, &character), FLINCH_OK);
  }
  void TearDown() override {
    EXPECT_EQ(flinch_character_free(character), FLINCH_OK);
    EXPECT_EQ(flinch_look_ahead_free(look_ahead), FLINCH_OK);
    EXPECT_EQ(flinch_workspace_free(workspace), FLINCH_OK);
    EXPECT_EQ(flinch_library_free(library), FLINCH_OK);
  }

  static flinch_look_ahead_options options(std::int32_t candidates) {
    auto value = sized<flinch_look_ahead_options>();
    value.candidates = candidates;
    return value;
  }
  flinch_status look(const flinch_threat* threats, std::int32_t count,
                     const flinch_look_ahead_options& how, flinch_look_ahead_status* out) {
    return flinch_character_look_ahead(character, threats, count, &how, look_ahead, out);
  }
  std::int32_t clip() const {
    auto state = sized<flinch_character_state>();
    EXPECT_EQ(flinch_character_describe(character, &state), FLINCH_OK);
    return state.clip;
  }

  flinch_library* library = nullptr;
  flinch_workspace* workspace = nullptr;
  flinch_look_ahead* look_ahead = nullptr;
  flinch_character* character = nullptr;
};

TEST_F(CApiLookAhead, AnswersWithTheCheapestAndTellsWhy) {
  const flinch_threat threat = ball();
  auto status = sized<flinch_look_ahead_status>();
  const std::size_t allocations = tests::allocation_count();
  ASSERT_EQ(look(&threat, 1, options(6), &status), FLINCH_OK);
  EXPECT_EQ(tests::allocation_count(), allocations);
  EXPECT_EQ(status.candidate_count, 6);
  EXPECT_EQ(status.tried, 6);
  EXPECT_EQ(status.is_complete, 1);
  EXPECT_EQ(status.threats, 1);
  EXPECT_GT(status.encounters, 0);
  ASSERT_LT(status.chosen, 6);
  EXPECT_EQ(status.candidate[status.chosen].clip, clip());
  for (int i = 0; i < status.candidate_count; ++i) {
    EXPECT_LE(status.candidate[status.chosen].cost_ns, status.candidate[i].cost_ns);
    EXPECT_EQ(status.candidate[i].work_j, 40);
    EXPECT_NE(flinch_foreseen_name(status.candidate[i].foreseen), nullptr);
  }
  EXPECT_EQ(look(&threat, 1, options(6), nullptr), FLINCH_OK);
}

TEST_F(CApiLookAhead, OneCandidateIsThatOfPerceive) {
  const flinch_threat threat = ball();
  ASSERT_EQ(flinch_character_perceive(character, &threat, workspace), FLINCH_OK);
  const std::int32_t expected = clip();
  ASSERT_EQ(flinch_character_place(character, 0, 0, 0, 0), FLINCH_OK);
  ASSERT_EQ(look(&threat, 1, options(1), nullptr), FLINCH_OK);
  EXPECT_EQ(clip(), expected);
}

TEST_F(CApiLookAhead, AClockLimitsTheSearch) {
  const flinch_threat threat = ball();
  auto how = options(16);
  how.budget_us = 0;
  how.now_us = [](void* clock) { return *static_cast<double*>(clock) += 1; };
  double now_us = 0;
  how.clock = &now_us;
  auto status = sized<flinch_look_ahead_status>();
  ASSERT_EQ(look(&threat, 1, how, &status), FLINCH_OK);
  EXPECT_EQ(status.tried, 0);
  EXPECT_EQ(status.is_complete, 0);
  EXPECT_TRUE(std::isnan(status.candidate[0].cost_ns));
  how.size = offsetof(flinch_look_ahead_options, budget_us);  // an older program: no limit
  ASSERT_EQ(look(&threat, 1, how, &status), FLINCH_OK);
  EXPECT_EQ(status.is_complete, 1);
}

TEST_F(CApiLookAhead, SeveralThreatsAreTakenTogether) {
  const flinch_threat threats[2] = {ball(), ball()};
  auto status = sized<flinch_look_ahead_status>();
  ASSERT_EQ(look(threats, 2, options(4), &status), FLINCH_OK);
  EXPECT_EQ(status.threats, 2);
  ASSERT_EQ(flinch_character_place(character, 0, 0, 0, 0), FLINCH_OK);
  EXPECT_EQ(flinch_character_perceive_all(character, threats, 2, workspace), FLINCH_OK);
  EXPECT_EQ(flinch_character_perceive_all(character, nullptr, 0, workspace), FLINCH_MISSES);
}

TEST_F(CApiLookAhead, BadInputIsRefusedAndChangesNothing) {
  flinch_threat threats[2] = {ball(), ball()};
  auto status = sized<flinch_look_ahead_status>();
  const flinch_look_ahead_status before = status;
  const auto refuses = [&](flinch_status expected, flinch_status found) {
    EXPECT_EQ(found, expected) << flinch_status_message(found);
    EXPECT_EQ(std::memcmp(&status, &before, sizeof status), 0);
    auto state = sized<flinch_character_state>();
    EXPECT_EQ(flinch_character_describe(character, &state), FLINCH_OK);
    EXPECT_EQ(state.phase, FLINCH_IDLE);
  };
  const auto how = options(8);
  refuses(FLINCH_NULL_POINTER, look(nullptr, 1, how, &status));
  refuses(FLINCH_BAD_INDEX, look(threats, -1, how, &status));
  refuses(FLINCH_BAD_INDEX, look(threats, FLINCH_MOST_THREATS + 1, how, &status));
  refuses(FLINCH_NULL_POINTER,
          flinch_character_look_ahead(character, threats, 2, nullptr, look_ahead, &status));
  refuses(FLINCH_NULL_POINTER,
          flinch_character_look_ahead(character, threats, 2, &how, nullptr, &status));
  refuses(FLINCH_BAD_HANDLE,
          flinch_character_look_ahead(character, threats, 2, &how,
                                      reinterpret_cast<flinch_look_ahead*>(workspace), &status));
  auto half_a_pointer = how;
  half_a_pointer.size = offsetof(flinch_look_ahead_options, now_us) + 4;
  refuses(FLINCH_BAD_SIZE, look(threats, 2, half_a_pointer, &status));
  threats[1].size = offsetof(flinch_threat, radius);
  refuses(FLINCH_BAD_SIZE, look(threats, 2, how, &status));
  refuses(FLINCH_BAD_SIZE, flinch_character_perceive_all(character, threats, 2, workspace));
  threats[1] = ball();
  threats[1].velocity[0] = kNan;
  refuses(FLINCH_BAD_THREAT, look(threats, 2, how, &status));
  refuses(FLINCH_BAD_THREAT, flinch_character_perceive_all(character, threats, 2, workspace));
  flinch_library* other = tests::load(file_with_costs());
  flinch_look_ahead* foreign = nullptr;
  ASSERT_EQ(flinch_look_ahead_create(other, &foreign), FLINCH_OK);
  refuses(FLINCH_OTHER_LIBRARY,
          flinch_character_look_ahead(character, threats, 1, &how, foreign, &status));
  EXPECT_EQ(flinch_look_ahead_free(foreign), FLINCH_OK);
  EXPECT_EQ(flinch_library_free(other), FLINCH_OK);
}

TEST(CApiLookAheadData, ASelectorWithoutCostsCannotBeLookedAheadWith) {
  flinch_library* library = tests::load(tests::selector_file());
  auto* look_ahead = reinterpret_cast<flinch_look_ahead*>(library);
  EXPECT_EQ(flinch_look_ahead_create(library, &look_ahead), FLINCH_WITHOUT_COSTS);
  EXPECT_EQ(look_ahead, nullptr);
  EXPECT_EQ(flinch_look_ahead_create(nullptr, &look_ahead), FLINCH_NULL_POINTER);
  EXPECT_EQ(flinch_look_ahead_free(nullptr), FLINCH_OK);
  EXPECT_EQ(flinch_foreseen_name(-1), nullptr);
  EXPECT_EQ(flinch_foreseen_name(FLINCH_FORESEEN_CUT + 1), nullptr);
  EXPECT_EQ(flinch_library_free(library), FLINCH_OK);
}

}  // namespace
}  // namespace flinch::runtime
