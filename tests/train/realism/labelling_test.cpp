// SPDX-License-Identifier: MIT
#include "train/realism/labelling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/push/push_scene.h"

namespace flinch::train {
namespace {

/// A judge who goes by the size of the deformation.
float answer_to(const PushExample& example) {
  return example.answer.deformation.norm() < 0.8F ? 1.0F : 0.0F;
}

TEST(Labelling, EstimatesEveryMotionFromAllAnswersBeforeIt) {
  const tests::PushScene scene;
  Labelling labelling(scene.responses, 4);
  std::vector<Label> answers;
  for (std::size_t k = 0; k < 60; ++k) {
    ASSERT_EQ(labelling.label_count(), k);
    ASSERT_EQ(labelling.estimate().has_value(), k > models::kRealismNeighbours);
    if (labelling.estimate()) {
      // From the model that all answers so far give.
      ASSERT_TRUE(models::is_sound(*labelling.model()));
      ASSERT_EQ(labelling.model()->size(), k);
      std::vector<Label> one{{labelling.example(), 0, "", ""}};
      const LabelledConfigurations asked = configurations_of(scene.responses, std::move(one));
      EXPECT_EQ(
          *labelling.estimate(),
          models::estimate_realism(*labelling.model(), features_of(*labelling.model(), asked, 0)));
      const models::RealismModel again =
          fit_realism_with(configurations_of(scene.responses, answers), {1, 1, 1, 1, 1, 1}, "");
      EXPECT_EQ(again.quality, labelling.model()->quality);
    }
    const float answer = answer_to(labelling.example());
    answers.push_back({labelling.example(), answer, "", ""});
    labelling.judge(answer);
    labelling.next();
  }
}

TEST(Labelling, AgreesInTimeWithAJudgeWhoGoesByWhatItSees) {
  const tests::PushScene scene;
  Labelling labelling(scene.responses, 1);
  std::size_t answers = 0;
  for (; answers < 600 && !labelling.agreement().is_enough; ++answers) {
    labelling.judge(answer_to(labelling.example()));
    labelling.next();
  }
  EXPECT_TRUE(labelling.agreement().is_enough) << labelling.agreement().mean_error;
  EXPECT_GE(answers, kRecentAnswers);
  // Whoever answers at random is not agreed with.
  Labelling random(scene.responses, 1);
  features::Random coin(9, features::RandomStream::realism, 0);
  for (int k = 0; k < 150; ++k) {
    random.judge(static_cast<float>(coin.uniform()));
    random.next();
    EXPECT_FALSE(random.agreement().is_enough);
  }
}

TEST(Labelling, IsTheSameForTheSameSeedAndTakesEarlierLabels) {
  const tests::PushScene scene;
  Labelling one(scene.responses, 2);
  Labelling other(scene.responses, 2);
  EXPECT_EQ(one.example().asked, other.example().asked);
  EXPECT_NE(one.example().asked, Labelling(scene.responses, 3).example().asked);
  std::vector<Label> earlier;
  for (int k = 0; k < 20; ++k) {
    earlier.push_back({one.example(), answer_to(one.example()), "", ""});
    one.judge(earlier.back().quality);
    one.next();
  }
  other.add(earlier);
  EXPECT_EQ(other.label_count(), 20U);
  ASSERT_TRUE(one.model() && other.model());
  EXPECT_EQ(one.model()->quality, other.model()->quality);
}

TEST(Agrees, NeedsEnoughAnswersOfEitherSide) {
  EXPECT_TRUE(agrees(50, 0.9, 0.1, 20));
  EXPECT_FALSE(agrees(49, 0.9, 0.1, 20));
  EXPECT_FALSE(agrees(50, 0.84, 0.1, 20));
  EXPECT_FALSE(agrees(50, 0.9, 0.16, 20));
  EXPECT_FALSE(agrees(50, 1, 0, 4)) << "always bad";
  EXPECT_FALSE(agrees(50, 1, 0, 46)) << "always good";
}

TEST(Played, PutsThePushWhereItSays) {
  const tests::PushScene scene;
  int late = 0;
  for (std::uint64_t i = 0; i < 30; ++i) {
    features::Random random(3, features::RandomStream::realism, i);
    const PushExample example = sample_example(scene.responses, random);
    const motion::Motion motion = played(scene.responses, example);
    const auto frame = static_cast<std::size_t>(std::lround(60 * push_time_s(example)));
    ASSERT_LT(frame, motion.poses.size());
    const motion::Pose now = state_of(scene.responses, example).now;
    EXPECT_LT((motion.poses[frame].root_position - now.root_position).norm(), 1e-3F);
    late += push_time_s(example) == kLeadIn_s ? 1 : 0;
  }
  EXPECT_GT(late, 15);
}

}  // namespace
}  // namespace flinch::train
