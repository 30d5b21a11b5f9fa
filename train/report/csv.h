// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace flinch::train {

/// Formats a double exactly, as "%.17g" does, in every locale.
std::string exact_text(double value);

/// Formats a cell of comma-separated values, quoted where necessary (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace flinch::train
