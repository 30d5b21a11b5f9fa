// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "train/evaluate/brawn.h"
#include "train/evaluate/confusions.h"
#include "train/evaluate/directions.h"
#include "train/evaluate/evaluation.h"
#include "train/evaluate/groups.h"
#include "train/evaluate/prevention.h"
#include "train/evaluate/reliability.h"
#include "train/evaluate/studies.h"

namespace flinch::train {

/// What made a store.
struct StoreOrigin {
  std::uint64_t seed = 0;
  std::string distribution = "{}";  ///< JSON text
  std::string simulation = "{}";    ///< JSON text
};

/// Options of `flinch compare` that no result tells.
struct ReportOptions {
  std::string feature_set;  ///< name
  bool curves = false;
  bool transfer = false;
  bool ablation = false;
};

/// All results of `flinch compare`.
struct Report {
  std::string version;            ///< of the program
  std::string provenance = "{}";  ///< JSON text
  ReportOptions options;
  StoreOrigin fitted_store;
  StoreOrigin tested_store;
  std::string library;
  std::uint64_t library_hash = 0;
  std::uint64_t seed = 0;
  std::size_t fitted_count = 0;
  std::size_t tested_count = 0;
  bool has_test_store = false;
  std::vector<std::string> features;
  std::vector<std::string> clips;  ///< in the library's order
  Evaluation evaluation;
  std::vector<KindRow> kinds;  ///< empty where there is one kind of threat
  std::vector<MethodSummary> methods;
  std::vector<GroupRow> groups;
  std::vector<DirectionRow> directions;
  std::vector<ConfusionRow> confusions;
  std::vector<ReliabilityBin> reliability;
  std::vector<NoiseRow> noise;
  std::vector<LearningCurveRow> curves;   ///< empty unless requested
  std::vector<TransferRow> transfer;      ///< empty unless requested
  std::vector<AblationRow> ablation;      ///< empty unless requested
  std::vector<BrawnRow> brawn;            ///< over the test scenarios
  std::vector<PreventionRow> prevention;  ///< over all scenarios of the training store
};

/// Returns what `flinch compare --json` prints, except the timing: the same for the same stores and
/// options, so that reports can be compared. Contains the cost model, with which anyone can
/// recompute the costs from the store.
nlohmann::ordered_json report_document(const Report& report);

/// Returns parameters as an object: each name with its value.
nlohmann::ordered_json parameters_document(std::span<const NamedValue> parameters);

/// Returns the time that the rows took to fit and to choose, which differs from run to run.
nlohmann::ordered_json timing_document(const Evaluation& evaluation);

/// Returns one line per test scenario: number, target, label and, for each row, the chosen clip and
/// its cost.
std::string scenarios_csv(const TrainTestSplit& split, const Evaluation& evaluation);

/// Returns the names of all files that write_report may write.
std::vector<std::string> report_file_names();

/// Writes report.json, timing.json, scenarios.csv and the data of each chart into a folder, which
/// it creates if missing. Throws Error.
void write_report(const Report& report, const TrainTestSplit& split, const std::string& folder);

}  // namespace flinch::train
