// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "train/evaluate/bootstrap.h"
#include "train/evaluate/intended_use.h"
#include "train/evaluate/split.h"
#include "train/fit/labels.h"
#include "train/fit/training.h"

namespace flinch::train {

/// Seconds since any fixed moment, to measure durations. The only input whose results differ from
/// run to run.
using Clock = std::function<double()>;

/// A method's selector and the time that its fit took.
struct FittedMethod {
  Method method{};
  Training training;
  double fit_s = 0;
  std::size_t file_bytes = 0;  ///< size of the selector's file without clips
};

/// Called with the name of what is being fitted, because fits take long. What it throws ends the
/// work.
using ProgressCallback = std::function<void(const std::string& what)>;

/// Fits methods one after the other, each with all processors.
std::vector<FittedMethod> fit_methods(
    const StoreHeader& header, std::span<const Observation> observations,
    const CostModel& cost_model, std::span<const Method> methods, std::uint64_t seed,
    const Clock& clock, const ProgressCallback& progress = [](const std::string&) {});

/// A row's candidates for a scenario: up to three clips, best first.
struct Ranking {
  std::array<models::Candidate, 3> best;
  std::size_t count = 0;
};
using Chooser = std::function<Ranking(const Observation&)>;

/// Returns the ranking of a selector's candidates.
Ranking ranking_of(const models::Selector& selector, const features::FeatureVector& features,
                   motion::Target threatened);

/// Cost of this row's choices less that of another row's, paired by scenario.
struct Difference {
  std::string from;  ///< the row that is subtracted
  Estimate cost_ns;  ///< negative if this row is better
};

/// Results of one row on the test scenarios. Vectors have one value per scenario.
struct EvaluationRow {
  std::string name;
  std::vector<int> chosen;  ///< clip index; runtime::kNoClip of the pose rules
  std::vector<double> cost_ns;
  std::vector<double> damage_ns;
  std::vector<double> hit;           ///< 1 if the label was chosen
  std::vector<double> hit_in_three;  ///< 1 if the label is among the first three candidates
  std::vector<float> vote;           ///< of the chosen clip
  /// Of the chosen clip; not a number if the method gives none.
  std::vector<float> expected_cost_ns;
  Estimate accuracy;
  Estimate top_three;  ///< of `hit_in_three`
  Estimate mean_cost_ns;
  Estimate mean_damage_ns;
  Estimate regret_ns;   ///< mean cost minus the oracle's
  Estimate protection;  ///< 0 for standing still, 1 for the oracle; not a number if those are equal
  std::vector<Difference> differences;  ///< from svm and knn, if those are rows
  IntendedUse use;                      ///< of the chosen clips
};

/// Time that a row takes to choose, from features to clip, and to fit.
struct RowTiming {
  std::string name;
  double median_us = 0;
  double p99_us = 0;
  double fit_s = 0;
  std::size_t file_bytes = 0;
};

/// A row that looks ahead: it simulates the first candidates of another row as a game does
/// (lookahead/look_ahead.h), and chooses the one of least simulated cost. Its costs are those of
/// the store all the same.
struct LookAheadRow {
  EvaluationRow row;  ///< its name is that of the other row, "+" and the number of candidates
  int candidates = 0;
  double median_us = 0;  ///< from features to the chosen clip's response, one thread
  double p99_us = 0;
  double encounters = 0;  ///< balls that were simulated, per choice
};

/// Rows compared on the same scenarios.
struct Evaluation {
  CostModel cost_model;
  Labels labels;                    ///< of the test scenarios
  std::vector<EvaluationRow> rows;  ///< idle, random, nearest_annotation, rules, methods, oracle
  std::vector<RowTiming> timing;    ///< of the methods
  /// Of the baselines and methods; none if the store does not hold its library.
  std::vector<LookAheadRow> look_ahead;
};

/// Returns (idle - cost) / (idle - oracle); not a number if idling is the best choice.
double protection_of(double idle, double cost, double oracle);

/// Returns the row with this name, or null if there is none.
const EvaluationRow* row_named(const Evaluation& evaluation, std::string_view name);

/// Evaluates baselines, methods and the oracle on the split's test scenarios. `seed` seeds the
/// random row and the 2000 bootstrap resamples. The result, except the timing, is the same to the
/// bit for any number of threads.
Evaluation evaluate(const TrainTestSplit& split, const CostModel& cost_model,
                    std::span<const FittedMethod> methods, std::uint64_t seed, const Clock& clock);

/// Returns the mean cost of a selector's choices, N·s, without an interval.
double mean_cost_ns(std::span<const Observation> observations, const Labels& labels,
                    const Chooser& choose);

}  // namespace flinch::train
