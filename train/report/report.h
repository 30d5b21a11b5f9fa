// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "train/evaluate/evaluation.h"
#include "train/evaluate/groups.h"
#include "train/evaluate/prevention.h"
#include "train/evaluate/reliability.h"
#include "train/evaluate/studies.h"

namespace flinch::train {

/// All that `flinch compare` finds out.
struct Report {
  std::string library;
  std::uint64_t library_hash = 0;
  std::uint64_t seed = 0;
  std::size_t fitted_count = 0;
  std::size_t tested_count = 0;
  bool has_test_store = false;
  std::vector<std::string> features;
  Evaluation evaluation;
  std::vector<MethodSummary> methods;
  std::vector<GroupRow> groups;
  std::vector<ReliabilityBin> reliability;
  std::vector<NoiseRow> noise;
  std::vector<LearningCurveRow> curves;   ///< empty unless asked for
  std::vector<TransferRow> transfer;      ///< empty unless asked for
  std::vector<AblationRow> ablation;      ///< empty unless asked for
  std::vector<PreventionRow> prevention;  ///< over all scenarios of the store that is fitted to
};

/// What `flinch compare --json` prints but for the timing: the same for the same stores and
/// options, so that reports can be compared. Has the cost model, with which anyone can compute the
/// costs again from the store.
nlohmann::ordered_json report_document(const Report& report);

/// How long the rows took to fit and to choose: differs from run to run.
nlohmann::ordered_json timing_document(const Evaluation& evaluation);

/// One line a tested scenario: number, target, label, and for each row the clip that it chose and
/// what that cost.
std::string scenarios_csv(const TrainTestSplit& split, const Evaluation& evaluation);

/// Writes report.json, timing.json, the page report.html, scenarios.csv and the data behind each
/// chart into a folder, which is made if missing. Throws Error.
void write_report(const Report& report, const TrainTestSplit& split, const std::string& folder);

}  // namespace flinch::train
