// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "train/realism/realism_evaluation.h"

namespace flinch::program {

/// What a report of realism tells beside its figures.
struct RealismOrigin {
  std::string library;  ///< its name
  std::uint64_t library_hash = 0;
  std::string judge;
  train::RealismKind kind = train::RealismKind::ours;  ///< of the model in the selector
};

/// Whether a report can be written to `folder`, over an earlier one with `overwrites`. Throws Error
/// if not. `inputs` are not overwritten.
void check_realism_report(const std::string& folder, const std::vector<std::string>& inputs,
                          bool overwrites);

/// Compares models, fitted to all and to fewer labels, with labels of held-out sittings, and writes
/// report.json, learning_curve.csv and, where the program was built with its pages, report.html.
/// There are two sittings. Takes about a minute for 1,500 labels, and tells on stderr how far it is
/// unless it is quiet.
void write_realism_report(const train::LabelledConfigurations& all, const RealismOrigin& origin,
                          const std::string& folder, bool is_quiet);

}  // namespace flinch::program
