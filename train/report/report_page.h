// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "train/report/report.h"

namespace flinch::train {

/// Returns a report as one self-contained HTML page with inline SVG: the rows, their charts and the
/// timing.
std::string report_page(const Report& report);

}  // namespace flinch::train
