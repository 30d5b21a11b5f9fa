// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "train/report/report.h"

namespace flinch::train {

/// A report as one HTML page with inline SVG that needs nothing else: the rows, their charts, and
/// the timing.
std::string report_page(const Report& report);

}  // namespace flinch::train
