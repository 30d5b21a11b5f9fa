// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "database/files/provenance.h"

namespace flinch::train {

/// How a user labels scenarios, as options of the program.
struct CostChoice {
  double brawn = 0;
  std::string vulnerability;          ///< name or file
  std::optional<std::string> pain{};  ///< name or file
};

/// Adds what is not at its default, and the files that it names. Throws Error where one cannot be
/// read.
void add_cost_options(const CostChoice& choice, database::Provenance& provenance);

}  // namespace flinch::train
