// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "train/evaluate/bootstrap.h"
#include "train/evaluate/split.h"
#include "train/fit/labels.h"
#include "train/fit/training.h"

namespace flinch::train {

/// Seconds from whenever: what durations are measured with. The only thing here whose results
/// differ from run to run.
using Clock = std::function<double()>;

/// A method's selector and how long it took to fit.
struct FittedMethod {
  Method method{};
  Training training;
  double fit_s = 0;
  std::size_t file_bytes = 0;  ///< of the selector's file without clips
};

/// Fits methods one after the other, each on all processors.
std::vector<FittedMethod> fit_methods(const StoreHeader& header,
                                      std::span<const Observation> observations,
                                      const CostModel& cost_model, std::span<const Method> methods,
                                      std::uint64_t seed, const Clock& clock);

/// What a row makes of a scenario: up to three clips, best first.
struct Ranking {
  std::array<models::Candidate, 3> best;
  std::size_t count = 0;
};
using Chooser = std::function<Ranking(const Observation&)>;

/// How a selector's candidates rank.
Ranking ranking_of(const models::Selector& selector, const features::FeatureVector& features,
                   motion::Target threatened);

/// How much another row's choices cost more than this one's, scenario by scenario.
struct Difference {
  std::string from;  ///< the row that is subtracted
  Estimate cost_ns;  ///< negative where this row is the better one
};

/// How one row did on the tested scenarios. Vectors have one value a scenario.
struct EvaluationRow {
  std::string name;
  std::vector<int> chosen;  ///< clip
  std::vector<double> cost_ns;
  std::vector<double> damage_ns;
  std::vector<double> hit;              ///< 1 where the label was chosen
  std::vector<double> hit_in_three;     ///< 1 where it is among the first three candidates
  std::vector<float> vote;              ///< of the chosen clip
  std::vector<float> expected_cost_ns;  ///< of the chosen clip; not a number where none is told
  Estimate accuracy;
  Estimate top_three;  ///< of `hit_in_three`
  Estimate mean_cost_ns;
  Estimate mean_damage_ns;
  Estimate regret_ns;   ///< mean cost minus the oracle's
  Estimate protection;  ///< 0 stands still, 1 is the oracle; not a number if those are the same
  std::vector<Difference> differences;  ///< from svm and knn, where those are rows
};

/// How long a row takes to choose, from the features to the clip, and to fit.
struct RowTiming {
  std::string name;
  double median_us = 0;
  double p99_us = 0;
  double fit_s = 0;
  std::size_t file_bytes = 0;
};

/// Rows side by side on the same scenarios.
struct Evaluation {
  CostModel cost_model;
  Labels labels;                    ///< of the tested scenarios
  std::vector<EvaluationRow> rows;  ///< idle, random, nearest_annotation, methods, oracle
  std::vector<RowTiming> timing;    ///< of the methods
};

/// (idle - cost) / (idle - oracle): not a number where idling is the best.
double protection_of(double idle, double cost, double oracle);

/// The row with this name; null if there is none.
const EvaluationRow* row_named(const Evaluation& evaluation, std::string_view name);

/// Tries baselines, methods and the oracle on the split's tested scenarios. `seed` draws the random
/// row and 2000 bootstrap resamples. The same bits for any number of threads but for the timing.
Evaluation evaluate(const TrainTestSplit& split, const CostModel& cost_model,
                    std::span<const FittedMethod> methods, std::uint64_t seed, const Clock& clock);

/// What a chooser's choices are worth, without intervals: mean cost, N·s.
double mean_cost_ns(std::span<const Observation> observations, const Labels& labels,
                    const Chooser& choose);

}  // namespace flinch::train
