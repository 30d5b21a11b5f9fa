// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "train/report/report.h"

namespace flinch::program {

/// What `flinch compare` prints for people.
std::string comparison_text(const train::Report& report);

}  // namespace flinch::program
