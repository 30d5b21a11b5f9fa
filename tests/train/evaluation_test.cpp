// SPDX-License-Identifier: MIT
#include "train/evaluation.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "motion/error.h"
#include "tests/train/made_up_store.h"
#include "train/export.h"
#include "train/labels.h"
#include "train/report.h"

namespace flinch::train {
namespace {

Store made_up_store(std::uint64_t count) {
  Store store;
  store.header = made_up_header();
  store.observations = made_up_observations(store.header, 0, count);
  return store;
}

CostModel default_cost(const Store& store) {
  return make_cost_model(store.header, vulnerability_profiles()[0].vulnerability, 0.1);
}

const EvaluationRow& row(const Evaluation& evaluation, const std::string& name) {
  for (const EvaluationRow& candidate : evaluation.rows)
    if (candidate.name == name) return candidate;
  throw std::runtime_error("no row " + name);
}

TEST(CostModel, TakesItsReferencesFromTheStore) {
  const Store store = made_up_store(1);
  EXPECT_DOUBLE_EQ(default_cost(store).reference_damage_ns, 13.77);  // largest vulnerability 1
  EXPECT_DOUBLE_EQ(default_cost(store).reference_work_j, 250);
}

TEST(Evaluation, RowsAddUpToTheirDefinitions) {
  const Store store = made_up_store(400);
  const Evaluation evaluation = evaluate(store, default_cost(store), 1);
  ASSERT_EQ(evaluation.observations.size(), 100U);
  EXPECT_EQ(evaluation.fitted_count, 300U);
  ASSERT_EQ(evaluation.rows.size(), 6U);
  const EvaluationRow& idle = row(evaluation, "idle");
  const EvaluationRow& oracle = row(evaluation, "oracle");
  EXPECT_EQ(oracle.accuracy, 1);
  EXPECT_EQ(oracle.regret_ns, 0);
  EXPECT_EQ(oracle.protection, 1);
  EXPECT_EQ(idle.protection, 0);
  for (const EvaluationRow& r : evaluation.rows) {
    double sum = 0;
    double hits = 0;
    for (std::size_t i = 0; i < r.chosen.size(); ++i) {
      const Observation& observation = evaluation.observations[i];
      EXPECT_EQ(observation.number % 4, 3U);
      const Trial& trial = observation.trials[trial_of(observation, r.chosen[i])];
      // The formula of the design, by hand: head 1, left hand 0.2, brawn 0.1.
      const double damage = double{trial.impulse[motion::Body::head]} + 0.2 * 0.125;
      EXPECT_NEAR(r.cost_ns[i], 0.9 * damage + 0.1 * double{trial.work_j} * 13.77 / 250, 1e-12);
      sum += r.cost_ns[i];
      hits += r.chosen[i] == evaluation.label[i] ? 1 : 0;
    }
    EXPECT_NEAR(r.mean_cost_ns, sum / 100, 1e-12);
    EXPECT_NEAR(r.accuracy, hits / 100, 1e-12);
    EXPECT_NEAR(r.regret_ns, r.mean_cost_ns - oracle.mean_cost_ns, 1e-12);
    EXPECT_NEAR(r.protection,
                (idle.mean_cost_ns - r.mean_cost_ns) / (idle.mean_cost_ns - oracle.mean_cost_ns),
                1e-12);
    EXPECT_LE(r.protection_interval.low, r.protection);
    EXPECT_GE(r.protection_interval.high, r.protection);
  }
  EXPECT_NEAR(evaluation.svm_minus_knn_ns,
              row(evaluation, "svm").mean_cost_ns - row(evaluation, "knn").mean_cost_ns, 1e-12);
}

TEST(Evaluation, LearnersFindARuleThatFollowsFromTheFeatures) {
  const Store store = made_up_store(400);
  const Evaluation evaluation = evaluate(store, default_cost(store), 1);
  EXPECT_GT(row(evaluation, "svm").protection, 0.9);
  EXPECT_GT(row(evaluation, "knn").protection, 0.8);
  EXPECT_LT(row(evaluation, "random").protection, row(evaluation, "svm").protection);
}

TEST(Evaluation, IsTheSameEveryTime) {
  const Store store = made_up_store(60);
  const Evaluation once = evaluate(store, default_cost(store), 1);
  const Evaluation again = evaluate(store, default_cost(store), 1);
  EXPECT_EQ(report_document(once, store.header).dump(),
            report_document(again, store.header).dump());
  EXPECT_EQ(scenarios_csv(once), scenarios_csv(again));
}

TEST(Evaluation, TooFewScenariosAreRefused) {
  const Store store = made_up_store(7);
  EXPECT_THROW(evaluate(store, default_cost(store), 1), Error);
}

TEST(Relabelling, MoreBrawnMakesIdlingBestMoreOften) {
  const Store store = made_up_store(200);
  const auto idling = [&](double brawn) {
    const Labels labels =
        label(store.observations,
              make_cost_model(store.header, vulnerability_profiles()[0].vulnerability, brawn));
    return std::ranges::count(labels.clip, store.header.idle);
  };
  EXPECT_LT(idling(0.1), idling(0.5));
  EXPECT_EQ(idling(1.0), 200);
}

TEST(Export, LibsvmTextHoldsTheTrainingSetToTheLastBit) {
  const Store store = made_up_store(50);
  const Labels labels = label(store.observations, default_cost(store));
  const models::TrainingSet set =
      make_training_set(store.header, store.observations, labels, scaling_of(store.observations));
  std::istringstream lines(libsvm_text(store.observations, labels));
  std::string line;
  int count = 0;
  for (; std::getline(lines, line); ++count) {
    std::istringstream fields(line);
    int label = -1;
    fields >> label;
    EXPECT_EQ(label, set.label[static_cast<std::size_t>(count)]);
    for (int k = 0; k < set.feature_count; ++k) {
      std::string field;
      fields >> field;
      const std::size_t colon = field.find(':');
      EXPECT_EQ(std::stoi(field.substr(0, colon)), k + 1);
      EXPECT_EQ(std::strtod(field.c_str() + colon + 1, nullptr),
                set.point(count)[static_cast<std::size_t>(k)]);
    }
  }
  EXPECT_EQ(count, 50);
}

TEST(Export, CellsWithCommasAndQuotesAreQuoted) {
  EXPECT_EQ(csv_cell("duck"), "duck");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("say \"hi\""), "\"say \"\"hi\"\"\"");
}

}  // namespace
}  // namespace flinch::train
