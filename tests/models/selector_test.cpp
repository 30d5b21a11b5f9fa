// SPDX-License-Identifier: MIT
#include "models/selector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace flinch::models {
namespace {

using motion::Target;

/// Three classes on a line of one feature, with hand-made machines: class 0 (clip 5) beats class 1
/// (clip 3) for x > 0; class 2 (clip 1) beats class 0 for x < 2 and always loses to class 1.
SvmModel hand_made_svm() {
  SvmModel model;
  model.degree = 1;
  model.gamma = 1;
  model.coef0 = 0;
  model.feature_count = 1;
  model.label = {5, 3, 1};
  model.vectors_of_class = {1, 0, 1};
  model.bound = {1, 1, 1};
  model.support_vectors.assign(2 * SvmModel::kLanes, 1);
  // The vector of class 0 is bounded in the machines (0,1) and (0,2); that of class 2 is in no
  // machine.
  model.machines = {
      {.rho = 0, .count = {0, 1, 0, 0}}, {.rho = 2, .count = {0, 1, 0, 0}}, {.rho = -1}};
  model.vectors = {0, 0};
  update_derived(model);
  return model;
}

KnnModel make_knn(int k, int feature_count, std::vector<float> points, std::vector<int> label) {
  KnnModel model;
  model.k = k;
  model.feature_count = feature_count;
  model.points = std::move(points);
  model.label = std::move(label);
  build_leaves(model);
  return model;
}

TEST(SvmCandidates, RankByVotesThenByTheModelsOrder) {
  const SvmModel model = hand_made_svm();
  const ClipMask all(6, true);
  // x = 3: (0,1) -> 0, (0,2) -> 0, (1,2) -> 1.
  auto ranked = candidates(model, std::vector<double>{3}, all, 0);
  ASSERT_EQ(ranked.size(), 3U);
  EXPECT_EQ(ranked[0].clip, 5);
  EXPECT_FLOAT_EQ(ranked[0].vote, 2.0F / 3);
  EXPECT_EQ(ranked[1].clip, 3);
  EXPECT_FLOAT_EQ(ranked[1].vote, 1.0F / 3);
  EXPECT_EQ(ranked[2].clip, 1);
  EXPECT_FLOAT_EQ(ranked[2].vote, 0);
  // x = 1: (0,1) -> 0, (0,2) -> 2, (1,2) -> 1: a cycle, one vote each.
  ranked = candidates(model, std::vector<double>{1}, all, 0);
  EXPECT_EQ(ranked[0].clip, 5);
  EXPECT_EQ(ranked[1].clip, 3);
  EXPECT_EQ(ranked[2].clip, 1);
}

TEST(SvmCandidates, ExcludeForbiddenClips) {
  ClipMask allowed(6, true);
  allowed[3] = false;
  const auto ranked = candidates(hand_made_svm(), std::vector<double>{1}, allowed, 0);
  ASSERT_EQ(ranked.size(), 2U);
  EXPECT_EQ(ranked[0].clip, 1);
  EXPECT_FLOAT_EQ(ranked[0].vote, 1);
  EXPECT_EQ(ranked[1].clip, 5);
}

TEST(SvmCandidates, AnOnlyChoiceHasAllVotes) {
  ClipMask allowed(6, false);
  allowed[3] = true;
  const auto ranked = candidates(hand_made_svm(), std::vector<double>{1}, allowed, 0);
  ASSERT_EQ(ranked.size(), 1U);
  EXPECT_EQ(ranked[0].clip, 3);
  EXPECT_FLOAT_EQ(ranked[0].vote, 1);
}

TEST(Candidates, FallBackToIdle) {
  ClipMask allowed(6, false);
  allowed[0] = allowed[4] = true;
  auto ranked = candidates(hand_made_svm(), std::vector<double>{1}, allowed, 4);
  ASSERT_EQ(ranked.size(), 1U);
  EXPECT_EQ(ranked[0].clip, 4);
  EXPECT_EQ(ranked[0].vote, 0);

  const KnnModel knn = make_knn(1, 1, {0, 1}, {5, 3});
  ranked = candidates(knn, std::vector<double>{1}, allowed, 4);
  ASSERT_EQ(ranked.size(), 1U);
  EXPECT_EQ(ranked[0].clip, 4);
  EXPECT_EQ(ranked[0].vote, 0);
}

TEST(KnnCandidates, AreAllowedLabelsOfTheNeighbours) {
  const KnnModel knn = make_knn(3, 1, {0, 1, 2, 3, 4}, {5, 3, 5, 1, 1});
  ClipMask allowed(6, true);
  auto ranked = candidates(knn, std::vector<double>{0.9}, allowed, 0);
  ASSERT_EQ(ranked.size(), 2U);
  EXPECT_EQ(ranked[0].clip, 5);
  EXPECT_FLOAT_EQ(ranked[0].vote, 2.0F / 3);
  EXPECT_EQ(ranked[1].clip, 3);
  allowed[5] = false;
  ranked = candidates(knn, std::vector<double>{0.9}, allowed, 0);
  ASSERT_EQ(ranked.size(), 2U);
  EXPECT_EQ(ranked[0].clip, 1);  // two of the three remaining
  EXPECT_EQ(ranked[1].clip, 3);
}

TEST(KnnCandidates, ByCostUseNeighboursWithAnyLabel) {
  KnnModel knn = make_knn(2, 1, {0, 1, 2}, {0, 1, 2});
  knn.vote = KnnVote::cost;
  knn.clip_count = 3;
  knn.cost_step_ns = 0.5F;
  knn.cost = {4, 2, 9, 6, 4, 9, 0, 0, 0};
  ClipMask allowed(3, true);
  allowed[1] = false;
  const auto ranked = candidates(knn, std::vector<double>{0.6}, allowed, 0);
  ASSERT_EQ(ranked.size(), 2U);
  EXPECT_EQ(ranked[0].clip, 0);
  EXPECT_FLOAT_EQ(ranked[0].expected_cost_ns, 2.5F);
  EXPECT_EQ(ranked[1].clip, 2);
  EXPECT_FLOAT_EQ(ranked[1].expected_cost_ns, 4.5F);
  EXPECT_EQ(ranked[0].vote, 0);
  // No allowed clip was tried on a neighbour.
  knn.cost.assign(9, KnnModel::kUntried);
  EXPECT_EQ(candidates(knn, std::vector<double>{0.6}, allowed, 2).front().clip, 2);
}

ClipSummary clip_for(Target target) {
  return {std::string(name_of(target)), motion::Annotation{.target = target}};
}

TEST(AllowedClips, AreThoseOfTheTargetAndItsNeighboursAndIdle) {
  const std::vector<ClipSummary> clips{{"idle", {}},
                                       clip_for(Target::head),
                                       clip_for(Target::trunk),
                                       clip_for(Target::pelvis),
                                       clip_for(Target::legs),
                                       {"unannotated", {}}};
  using testing::ElementsAre;
  EXPECT_THAT(allowed_clips(clips, 0, Target::head), ElementsAre(1, 1, 1, 0, 0, 0));
  EXPECT_THAT(allowed_clips(clips, 0, Target::trunk), ElementsAre(1, 1, 1, 1, 0, 0));
  EXPECT_THAT(allowed_clips(clips, 0, Target::pelvis), ElementsAre(1, 0, 1, 1, 1, 0));
  EXPECT_THAT(allowed_clips(clips, 0, Target::legs), ElementsAre(1, 0, 0, 1, 1, 0));
}

TEST(Selector, ScalesAndMasksBeforePrediction) {
  Selector selector;
  selector.clips = {
      {"idle", {}}, clip_for(Target::head), clip_for(Target::head), clip_for(Target::legs)};
  selector.layout = features::feature_set_named("paper")->layout;
  selector.scaling.min.assign(features::kFeatureCount, 0);
  selector.scaling.max.assign(features::kFeatureCount, 10);
  std::vector<float> points;
  for (const float value : {-1.0F, 0.0F, 1.0F}) {  // raw 0, 5 and 10
    points.insert(points.end(), features::kFeatureCount, value);
  }
  selector.model = make_knn(1, features::kFeatureCount, points, {1, 2, 3});
  features::FeatureVector x;
  x.fill(5.5F);
  EXPECT_EQ(select(selector, x, Target::head), 2);
  x.fill(1);
  EXPECT_EQ(select(selector, x, Target::head), 1);
  x.fill(9);
  EXPECT_EQ(select(selector, x, Target::head), 2);  // the legs' clip is nearer but not allowed
  EXPECT_EQ(select(selector, x, Target::legs), 3);
  EXPECT_EQ(candidates(selector, x, Target::pelvis).front().clip, 3);
}

}  // namespace
}  // namespace flinch::models
