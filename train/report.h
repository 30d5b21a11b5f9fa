// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "train/evaluation.h"
#include "train/store.h"

namespace flinch::train {

/// What `flinch compare --json` prints: the rows, the paired difference, and the cost model with
/// which anyone can compute the costs again from the store.
nlohmann::ordered_json report_document(const Evaluation& evaluation, const StoreHeader& header);

/// One line a held-out scenario: number, target, label, and for each row the clip that it chose and
/// what that cost.
std::string scenarios_csv(const Evaluation& evaluation);

/// Writes report.json and scenarios.csv into a folder, which is made if missing. Throws Error.
void write_report(const Evaluation& evaluation, const StoreHeader& header,
                  const std::string& folder);

}  // namespace flinch::train
