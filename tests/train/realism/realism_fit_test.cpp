// SPDX-License-Identifier: MIT
#include "train/realism/realism_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/push/push_scene.h"
#include "train/realism/proxy_judge.h"
#include "train/realism/realism_evaluation.h"

namespace flinch::train {
namespace {

/// Examples that are good where the deformation is small, in five sittings.
LabelledConfigurations small_is_good(const tests::PushScene& scene, std::size_t count) {
  std::vector<Label> labels;
  for (std::size_t i = 0; i < count; ++i) {
    features::Random random(7, features::RandomStream::realism, i);
    Label label{sample_example(scene.responses, random), 0, "made up", std::to_string(i % 5)};
    label.quality = label.example.answer.deformation.norm() < 0.8F ? 1.0F : 0.0F;
    labels.push_back(label);
  }
  return configurations_of(scene.responses, std::move(labels));
}

TEST(FitRealism, FindsWhatJudgesGoByOnHeldOutLabels) {
  const tests::PushScene scene;
  const LabelledConfigurations all = small_is_good(scene, 250);
  const RealismAgreement ours = held_out_agreement(all, RealismKind::ours);
  EXPECT_EQ(ours.count, 250U);
  EXPECT_GT(ours.auc, 0.9);
  EXPECT_GT(ours.agreement, ours.chance + 0.1);
  EXPECT_GT(held_out_agreement(all, RealismKind::paper).auc, 0.75);
  const models::RealismModel model = fit_realism(all, RealismKind::ours, "made up");
  EXPECT_TRUE(models::is_sound(model));
  EXPECT_EQ(model.judge, "made up");
  EXPECT_GT(model.weight[11], 0) << "of the deformation";
}

TEST(FitRealism, ComponentsAreThoseOfGreatestVariance) {
  const tests::PushScene scene;
  const LabelledConfigurations all = small_is_good(scene, 60);
  const models::RealismModel model = fit_realism(all, RealismKind::paper, "made up");
  const std::size_t size = model.mean.size();
  double captured = 0;
  double whole = 0;
  for (const auto* group : {&all.character, &all.response}) {
    for (const runtime::BodyConfiguration& one : *group) {
      const Eigen::Map<const runtime::BodyConfiguration> mean(model.mean.data());
      whole += double{(one - mean).squaredNorm()};
      for (const float part : models::components_of(model, std::span(one.data(), size)))
        captured += double{part} * double{part};
    }
  }
  EXPECT_GT(captured / whole, 0.8);
  EXPECT_LE(captured / whole, 1.0001);
  for (std::size_t k = kRealismAskedFeature; k < models::kRealismFeatureCount; ++k)
    EXPECT_EQ(model.weight[k], 0) << "the paper's G does not see the asked push";
}

TEST(FitRealism, ThePapersFKnowsWhatEveryLabelNeeded) {
  const tests::PushScene scene;
  const LabelledConfigurations all = small_is_good(scene, 120);
  EXPECT_FALSE(fit_realism(all, RealismKind::ours, "made up").theta);
  const models::RealismModel model = fit_realism(all, RealismKind::paper, "made up");
  ASSERT_TRUE(model.theta);
  EXPECT_TRUE(models::is_sound(model));
  int turned = 0;
  for (std::size_t i = 0; i < all.labels.size(); ++i) {
    // A push of a turned response is the same push of the response that is not turned, from a
    // direction that is turned back.
    const PushExample& example = all.labels[i].example;
    const float turn = example.answer.turn;
    turned += std::abs(turn) > 0.1F ? 1 : 0;
    const auto turned_back = [&](const Eigen::Vector3f& v) {
      return Eigen::Vector3f(std::cos(turn) * v.x() + std::sin(turn) * v.y(),
                             std::cos(turn) * v.y() - std::sin(turn) * v.x(), v.z());
    };
    const auto components =
        models::components_of(model, std::span(all.response[i].data(), model.mean.size()));
    const models::Theta theta = models::estimate_theta(
        *model.theta, runtime::impulse_features(components, all.response[i], example.place,
                                                turned_back(example.asked)));
    EXPECT_NEAR(theta[0], std::log(example.answer.taper), 0.1F);
    const Eigen::Vector3f m = turned_back(example.answer.deformation);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(theta[static_cast<std::size_t>(k) + 1], m(k), 0.05F);
    // What the unturned response has, and what it lacks, is what was asked.
    const auto response = static_cast<std::size_t>(example.answer.response);
    const Eigen::Vector3f own =
        scene.responses.responses[response].velocity[runtime::push_place_index(example.place)];
    EXPECT_LT((m + own - turned_back(example.asked)).head<2>().norm(), 1e-4F);
  }
  EXPECT_GT(turned, 20);
}

TEST(AreaUnderCurve, IsTheShareOfPairsInOrder) {
  EXPECT_EQ(area_under_curve(std::array{0.1F, 0.4F, 0.3F, 0.9F}, {false, false, true, true}), 0.75);
  EXPECT_EQ(area_under_curve(std::array{0.5F, 0.5F}, {false, true}), 0.5);
  EXPECT_EQ(area_under_curve(std::array{0.5F}, {true}), 0.5);
}

TEST(ProxyJudge, LikesTheRecordedPushAndDislikesAWildOne) {
  const tests::PushScene scene;
  const ProxyJudge judge(scene.responses);
  for (std::size_t i = 0; i < scene.responses.responses.size(); ++i) {
    const runtime::PushResponse& response = scene.responses.responses[i];
    PushExample example;
    example.state_clip = response.clip;
    example.state_s = response.contact_s;
    example.asked = response.velocity[0];
    example.answer =
        runtime::deformed_candidate(scene.responses, i, motion::Role::chest, example.asked);
    example.answer.taper = 3;
    EXPECT_GT(judge.quality_of(example), 0.9F) << i;
    example.asked *= -4;
    example.answer =
        runtime::deformed_candidate(scene.responses, i, motion::Role::chest, example.asked);
    example.answer.taper = 100;
    EXPECT_LT(judge.quality_of(example), 0.3F) << i;
  }
}

TEST(ProxyLabels, AreTheJudgesAndInTenSittings) {
  const tests::PushScene scene;
  const ProxyJudge judge(scene.responses);
  const std::vector<Label> labels = proxy_labels(scene.responses, judge, 30, 7);
  const std::vector<Label> again = proxy_labels(scene.responses, judge, 30, 7);
  ASSERT_EQ(labels.size(), 30U);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_EQ(labels[i].judge, kProxyJudge);
    EXPECT_EQ(labels[i].sitting, "proxy 7." + std::to_string(i / 3));
    EXPECT_EQ(labels[i].quality, judge.quality_of(labels[i].example));
    EXPECT_EQ(labels[i].example.asked, again[i].example.asked);
  }
  EXPECT_NE(proxy_labels(scene.responses, judge, 1, 8)[0].example.asked, labels[0].example.asked);
}

TEST(SampleExample, IsTheSameForTheSameSeedAndGivesEveryPlace) {
  const tests::PushScene scene;
  std::vector<int> places(motion::kRoleCount);
  for (std::uint64_t i = 0; i < 60; ++i) {
    features::Random one(3, features::RandomStream::realism, i);
    features::Random other(3, features::RandomStream::realism, i);
    const PushExample a = sample_example(scene.responses, one);
    const PushExample b = sample_example(scene.responses, other);
    EXPECT_EQ(a.asked, b.asked);
    EXPECT_EQ(a.state_s, b.state_s);
    EXPECT_EQ(a.answer.response, b.answer.response);
    ++places[static_cast<std::size_t>(a.place)];
  }
  for (const motion::Role place : motion::kPushPlaces)
    EXPECT_GT(places[static_cast<std::size_t>(place)], 0);
}

}  // namespace
}  // namespace flinch::train
