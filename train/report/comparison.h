// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "train/objective/vulnerability.h"
#include "train/report/report.h"
#include "train/store/store.h"

namespace flinch::train {

/// What `flinch compare` fits, and for what.
struct ComparisonPlan {
  std::string feature_set{features::feature_sets().front().name};
  std::vector<Method> methods;  ///< in the order of the rows
  double brawn = CostModel{}.brawn;
  VulnerabilityProfile vulnerability = vulnerability_profiles()[0];
  /// Name or file that it is from, and that of the pain map; for the provenance alone.
  std::string vulnerability_choice{vulnerability_profiles()[0].name};
  std::optional<std::string> pain_choice{};
  /// Reads a store, whose damage counts by `vulnerability`.
  std::function<Store(const std::string& path)> read = read_store;
  bool curves = false;    ///< also fit to fewer scenarios
  bool transfer = false;  ///< also fit for other brawns
  bool ablation = false;  ///< also fit with other features
  Clock clock = [] { return 0.0; };
  /// Called on the calling thread before each fit; may throw to end the comparison.
  ProgressCallback progress = [](const std::string&) {};
};

/// The results, and the scenarios that they were computed on.
struct Comparison {
  Report report;
  TrainTestSplit split;
};

/// Fits every method to a store and compares them on the same scenarios: those of the store `test`
/// or, where it is empty, every fourth of `store`. Throws Error for stores that cannot be used.
Comparison compare_methods(const std::string& store, const std::string& test,
                           const ComparisonPlan& plan);

}  // namespace flinch::train
