// SPDX-License-Identifier: MIT
#include "train/evaluate/studies.h"

#include <gtest/gtest.h>

#include "tests/train/evaluate/comparison.h"

namespace flinch::train {
namespace {

const ProgressCallback kSilence = [](const std::string&) {};

const EvaluationRow& row(const Comparison& comparison, const std::string& name) {
  return *row_named(comparison.evaluation, name);
}

// The neighbours' majority is as coarse as the made-up directions and averages the noise out.
TEST(Noise, OfZeroChangesNothingAndLargeNoiseHurtsAnAccurateSelector) {
  const Comparison comparison(split_of(made_up_store(800)));
  const std::vector<NoiseRow> rows = noise_rows(comparison.plan(), comparison.fitted);
  ASSERT_EQ(rows.size(), 5 * kTestMethods.size());
  for (std::size_t first = 0; first < rows.size(); first += 5) {
    EXPECT_EQ(rows[first].noise, 0);
    EXPECT_NEAR(rows[first].protection, row(comparison, rows[first].name).protection.value, 1e-12);
    if (rows[first].name == name_of(Method::svm)) {
      EXPECT_GT(rows[first + 4].regret_ns, rows[first].regret_ns + 0.01);
    }
  }
}

TEST(LearningCurves, EndAtTheComparisonsRow) {
  const Comparison comparison(split_of(made_up_store(700)));
  const std::vector<LearningCurveRow> rows = learning_curve_rows(comparison.plan(), kSilence);
  ASSERT_EQ(rows.size(), 2 * kTestMethods.size());  // 500 and all 525
  for (std::size_t first = 0; first < rows.size(); first += 2) {
    EXPECT_EQ(rows[first].fitted_count, 500U);
    EXPECT_EQ(rows[first + 1].fitted_count, 525U);
    EXPECT_NEAR(rows[first + 1].regret_ns, row(comparison, rows[first].name).regret_ns.value,
                1e-12);
  }
}

TEST(Transfer, ToTheSameBrawnIsTheComparisonsRow) {
  const Comparison comparison(split_of(made_up_store(200)));
  const std::vector<TransferRow> rows = transfer_rows(comparison.plan(), kSilence);
  ASSERT_EQ(rows.size(), 16 * kTestMethods.size());
  std::size_t same = 0;
  for (const TransferRow& r : rows) {
    if (r.fitted_brawn != 0.1 || r.judged_brawn != 0.1) continue;
    EXPECT_NEAR(r.regret_ns, row(comparison, r.name).regret_ns.value, 1e-12);
    ++same;
  }
  EXPECT_EQ(same, kTestMethods.size());
}

TEST(Ablation, LeavesOutOneGroupAtATime) {
  const Comparison comparison(split_of(made_up_store(120)));
  const std::array methods{Method::knn};
  const StudyPlan plan{comparison.split, comparison.cost_model, methods, 1};
  const std::vector<AblationRow> rows = ablation_rows(plan, kSilence);
  EXPECT_GT(rows.size(), 15U);
  for (const AblationRow& r : rows) {
    if (r.features == "paper") {
      EXPECT_EQ(r.feature_count, features::kFeatureCount);
      EXPECT_NEAR(r.regret_ns, row(comparison, "knn").regret_ns.value, 1e-12);
    }
    if (r.features == "paper without heading") {
      EXPECT_EQ(r.feature_count, features::kFeatureCount - 3);
    }
  }
}

}  // namespace
}  // namespace flinch::train
