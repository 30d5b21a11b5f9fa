// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/reaction/reaction_scenes.h"
#include "tests/scenes/allocation_count.h"

namespace flinch::reaction {
namespace {

TEST(Reaction, AllocatesNothingAfterBegin) {
  const motion::Physique character = motion::default_character();
  const auto motions = scenes::motions_by_rule(character.skeleton);
  const auto figure_model = make_figure_model(character);
  Reaction reaction(figure_model);
  int hits = 0;
  int knocked_over = 0;
  auto cases = scenes::random_reaction_cases(character, motions, 12, 5);
  for (auto& heavy : scenes::random_reaction_cases(character, motions, 12, 6, 20.0))
    cases.push_back(heavy);
  for (const auto& reaction_case : cases) {
    ASSERT_EQ(scenes::begin(reaction, reaction_case), ReactionStatus::ok);
    for (int k = 1; k < 180; ++k) {
      const motion::Pose wanted =
          scenes::pose_at(*reaction_case.motion, reaction_case.begin_s + k * scenes::kFrame_s);
      const std::size_t allocations = tests::allocation_count();
      ASSERT_EQ(reaction.advance(scenes::kFrame_s, wanted, wanted), ReactionStatus::ok);
      EXPECT_EQ(tests::allocation_count(), allocations) << "frame " << k;
    }
    if (std::isfinite(reaction.contact_s())) ++hits;
    if (reaction.phase() == ReactionPhase::knocked_over) ++knocked_over;
  }
  EXPECT_GT(hits, 16);
  EXPECT_GT(knocked_over, 3);
}

}  // namespace
}  // namespace flinch::reaction
