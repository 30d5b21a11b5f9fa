// SPDX-License-Identifier: MIT
#include "train/evaluate/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "features/ball.h"
#include "lookahead/oracle/response_motion.h"
#include "motion/error.h"
#include "runtime/response/brace.h"
#include "sim/rehearsal/simulator.h"
#include "tests/train/evaluate/comparison.h"
#include "train/evaluate/groups.h"
#include "train/evaluate/reliability.h"
#include "train/report/report.h"

namespace flinch::train {
namespace {

const EvaluationRow& row(const Evaluation& evaluation, const std::string& name) {
  const EvaluationRow* found = row_named(evaluation, name);
  if (found == nullptr) throw std::runtime_error("no row " + name);
  return *found;
}

TEST(CostModel, TakesItsReferencesFromTheStore) {
  const Store store = made_up_store(1);
  EXPECT_DOUBLE_EQ(default_cost(store.header).reference_damage_ns.front(),
                   13.77);  // vulnerability 1
  EXPECT_DOUBLE_EQ(default_cost(store.header).reference_work_j, 250);
}

TEST(Evaluation, RowsMatchTheirDefinitions) {
  const Comparison comparison(split_of(made_up_store(400)));
  const Evaluation& evaluation = comparison.evaluation;
  ASSERT_EQ(comparison.split.tested.size(), 100U);
  EXPECT_EQ(comparison.split.fitted.size(), 300U);
  ASSERT_EQ(evaluation.rows.size(), 5 + kTestMethods.size());
  const EvaluationRow& idle = row(evaluation, "idle");
  const EvaluationRow& oracle = row(evaluation, "oracle");
  EXPECT_EQ(oracle.accuracy.value, 1);
  EXPECT_EQ(oracle.regret_ns.value, 0);
  EXPECT_EQ(oracle.protection.value, 1);
  EXPECT_EQ(idle.protection.value, 0);
  for (const EvaluationRow& r : evaluation.rows) {
    if (r.name == "rules") continue;  // below: it chooses no clip
    double sum = 0;
    double damages = 0;
    double hits = 0;
    for (std::size_t i = 0; i < r.chosen.size(); ++i) {
      const Observation& observation = comparison.split.tested[i];
      EXPECT_EQ(observation.number % 4, 3U);
      const Trial& trial = observation.trials[trial_of(observation, r.chosen[i])];
      // The cost formula by hand: head 1, left hand 0.2, brawn 0.1.
      const double damage = double{trial.impulse[motion::Body::head]} + 0.2 * 0.125;
      EXPECT_NEAR(r.cost_ns[i], 0.9 * damage + 0.1 * double{trial.work_j} * 13.77 / 250, 1e-12);
      sum += r.cost_ns[i];
      damages += damage;
      hits += r.chosen[i] == evaluation.labels.clip[i] ? 1 : 0;
    }
    EXPECT_NEAR(r.mean_cost_ns.value, sum / 100, 1e-12);
    EXPECT_NEAR(r.mean_damage_ns.value, damages / 100, 1e-12);
    EXPECT_NEAR(r.accuracy.value, hits / 100, 1e-12);
    EXPECT_NEAR(r.regret_ns.value, r.mean_cost_ns.value - oracle.mean_cost_ns.value, 1e-12);
    EXPECT_NEAR(r.protection.value,
                (idle.mean_cost_ns.value - r.mean_cost_ns.value) /
                    (idle.mean_cost_ns.value - oracle.mean_cost_ns.value),
                1e-12);
    EXPECT_LE(r.protection.interval.low, r.protection.value);
    EXPECT_GE(r.protection.interval.high, r.protection.value);
  }
}

// The response, its simulation and the cost anew, from their parts.
TEST(Evaluation, RulesAreSimulatedAsTheClipsAre) {
  const Comparison comparison(split_of(made_up_store(40)));
  const EvaluationRow& rules = row(comparison.evaluation, "rules");
  const database::ClipLibrary library = scenes::synthetic_library();
  const runtime::PreparedLibrary prepared = runtime::prepare(library);
  const sim::SimulationOptions options;
  const sim::Simulator simulator(library.character, options);
  double most_ns = 0;
  for (std::size_t i = 0; i < comparison.split.tested.size(); ++i) {
    const features::Scenario& scenario = comparison.split.tested[i].scenario;
    const float time_s = scenario.time_to_impact_s;
    const runtime::Response braced =
        make_brace(prepared, scenario.state,
                   {scenario.threat, position_at(scenario.threat, time_s), time_s, 0, false});
    const lookahead::ResponseMotion motion =
        lookahead::make_response_motion(prepared, braced, double{time_s} + 0.3);
    const sim::SimulationResult result =
        simulator.simulate(simulator.rehearse(motion.motion, 0, motion.simulated_s),
                           features::ball_of(scenario.threat, options.gravity_mps2));
    double damage_ns = 0;
    for (const motion::Body body : motion::kBodies)
      damage_ns += comparison.cost_model.vulnerability[body] * result.impulse[body];
    EXPECT_NEAR(rules.cost_ns[i], 0.9 * damage_ns + 0.1 * motion.work_j * 13.77 / 250, 1e-6) << i;
    EXPECT_EQ(rules.chosen[i], runtime::kNoClip);
    most_ns = std::max(most_ns, damage_ns);
  }
  EXPECT_GT(most_ns, 0.5);
  EXPECT_EQ(rules.accuracy.value, 0);
}

TEST(Evaluation, TopThreeCountsTheLabelAmongTheFirstThreeCandidates) {
  const Comparison comparison(split_of(made_up_store(200)));
  for (const FittedMethod& fitted : comparison.fitted) {
    double hits = 0;
    for (std::size_t i = 0; i < comparison.split.tested.size(); ++i) {
      const Observation& observation = comparison.split.tested[i];
      const auto all = models::candidates(fitted.training.selector, observation.features,
                                          observation.scenario.target);
      for (std::size_t k = 0; k < all.size() && k < 3; ++k)
        hits += all[k].clip == comparison.evaluation.labels.clip[i] ? 1 : 0;
    }
    const EvaluationRow& r = row(comparison.evaluation, std::string(name_of(fitted.method)));
    EXPECT_NEAR(r.top_three.value, hits / 50, 1e-12);
    EXPECT_GE(r.top_three.value, r.accuracy.value);
  }
}

// Reference implementation: the mean of the scenarios' differences in every resample.
TEST(Evaluation, DifferencesArePairedByScenario) {
  const Comparison comparison(split_of(made_up_store(120)));
  const Evaluation& evaluation = comparison.evaluation;
  const EvaluationRow& svm = row(evaluation, "svm");
  const Resamples resamples = draw_resamples(30, 2000, 1);
  for (const EvaluationRow& r : evaluation.rows) {
    EXPECT_EQ(r.differences.size(), r.name == "svm" || r.name == "knn" ? 1U : 2U);
    for (const Difference& difference : r.differences) {
      if (difference.from != "svm") continue;
      std::vector<double> means;
      for (const auto& indices : resamples) {
        double sum = 0;
        for (const std::uint32_t i : indices) sum += r.cost_ns[i] - svm.cost_ns[i];
        means.push_back(sum / 30);
      }
      std::ranges::sort(means);
      // 2000 values: the 2.5th percentile lies at 0.025 * 1999 = 49.975, the 97.5th at 1949.025.
      EXPECT_NEAR(difference.cost_ns.interval.low, means[49] + 0.975 * (means[50] - means[49]),
                  1e-9);
      EXPECT_NEAR(difference.cost_ns.interval.high,
                  means[1949] + 0.025 * (means[1950] - means[1949]), 1e-9);
      EXPECT_NEAR(difference.cost_ns.value, r.mean_cost_ns.value - svm.mean_cost_ns.value, 1e-12);
    }
  }
}

TEST(Evaluation, MethodsLearnARuleOfTheFeatures) {
  const Comparison comparison(split_of(made_up_store(400)));
  EXPECT_GT(row(comparison.evaluation, "svm").protection.value, 0.9);
  EXPECT_GT(row(comparison.evaluation, "knn").protection.value, 0.8);
  EXPECT_LT(row(comparison.evaluation, "random").protection.value,
            row(comparison.evaluation, "svm").protection.value);
}

TEST(Evaluation, IsDeterministicExceptForTiming) {
  const Comparison once(split_of(made_up_store(60)), 1e-6);
  const Comparison again(split_of(made_up_store(60)), 5e-6);
  EXPECT_EQ(report_document(report_of(once)).dump(), report_document(report_of(again)).dump());
  EXPECT_EQ(scenarios_csv(once.split, once.evaluation),
            scenarios_csv(again.split, again.evaluation));
  EXPECT_NE(timing_document(once.evaluation).dump(), timing_document(again.evaluation).dump());
}

TEST(Evaluation, TimingFollowsTheClock) {
  const Comparison comparison(split_of(made_up_store(60)), 3e-6);
  for (const RowTiming& timing : comparison.evaluation.timing) {
    EXPECT_NEAR(timing.median_us, 3, 1e-6);
    EXPECT_NEAR(timing.p99_us, 3, 1e-6);
    EXPECT_NEAR(timing.fit_s, 3e-6, 1e-12);
    EXPECT_GT(timing.file_bytes, 1000U);
  }
}

TEST(Groups, HoldEveryScenarioOncePerKindWithTheirOwnMeans) {
  const Comparison comparison(split_of(made_up_store(400)));
  const std::vector<GroupRow> groups = group_rows(comparison.split, comparison.evaluation, 1);
  std::map<std::string, std::size_t> scenarios;
  std::map<std::pair<std::string, std::string>, double> costs;
  for (const GroupRow& group : groups) {
    if (group.name == "idle") scenarios[group.group] += group.scenarios;
    costs[{group.group, group.name}] +=
        group.mean_cost_ns.value * static_cast<double>(group.scenarios);
  }
  ASSERT_EQ(scenarios.size(), 3U);
  for (const auto& [kind, count] : scenarios) {
    EXPECT_EQ(count, comparison.split.tested.size()) << kind;
    for (const EvaluationRow& r : comparison.evaluation.rows)
      EXPECT_NEAR((costs[{kind, r.name}]), 100 * r.mean_cost_ns.value, 1e-9) << kind;
  }
  // The head's row by hand.
  double sum = 0;
  double count = 0;
  const EvaluationRow& idle = row(comparison.evaluation, "idle");
  for (std::size_t i = 0; i < comparison.split.tested.size(); ++i) {
    if (comparison.split.tested[i].scenario.target != motion::Target::head) continue;
    sum += idle.cost_ns[i];
    ++count;
  }
  EXPECT_EQ(groups.front().value, "head");
  EXPECT_NEAR(groups.front().mean_cost_ns.value, sum / count, 1e-12);
}

TEST(Reliability, BinsHoldEveryScenarioOnceByRisingConfidence) {
  const Comparison comparison(split_of(made_up_store(400)));
  const std::vector<ReliabilityBin> bins = reliability(comparison.evaluation);
  for (const Method method : kTestMethods) {
    const EvaluationRow& r = row(comparison.evaluation, std::string(name_of(method)));
    std::size_t scenarios = 0;
    double hits = 0;
    double before = -std::numeric_limits<double>::infinity();
    for (const ReliabilityBin& bin : bins) {
      if (bin.name != r.name) continue;
      scenarios += bin.scenarios;
      hits += bin.accuracy * static_cast<double>(bin.scenarios);
      EXPECT_GE(bin.mean_said, before - 1e-9);
      before = bin.mean_said;
    }
    EXPECT_EQ(scenarios, 100U);
    EXPECT_NEAR(hits, 100 * r.accuracy.value, 1e-9);
  }
}

TEST(Relabelling, MoreBrawnLabelsIdleMoreOften) {
  const Store store = made_up_store(200);
  const auto idling = [&](double brawn) {
    const Labels labels = label(store.observations,
                                make_cost_model(store.header, vulnerability_profiles()[0], brawn));
    return std::ranges::count(labels.clip, store.header.idle);
  };
  EXPECT_LT(idling(0.1), idling(0.5));
  EXPECT_EQ(idling(1.0), 200);
}

}  // namespace
}  // namespace flinch::train
