// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "train/report/report.h"

namespace flinch::program {

/// Returns the tables that `flinch compare` prints.
std::string comparison_text(const train::Report& report);

}  // namespace flinch::program
