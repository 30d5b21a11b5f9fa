// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace flinch::train {

/// Formats a double exactly, as "%.17g" does, in every locale.
std::string exact_text(double value);

/// Returns names of columns that are valid in R, and as attributes in pandas: `prefix` and each
/// text with "_" for what is no letter of ASCII, digit or dot. Those that would be equal get "_2",
/// "_3", …
std::vector<std::string> column_names(const std::string& prefix,
                                      const std::vector<std::string>& texts);

/// Formats a cell of comma-separated values, quoted where necessary (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace flinch::train
