// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "train/report/report.h"

namespace flinch::train::program {

/// What `flinch compare` prints for people.
std::string comparison_text(const Report& report);

}  // namespace flinch::train::program
