// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace flinch::train {

/// A double with every digit, as "%.17g" writes it, whatever the locale.
std::string exact_text(double value);

/// A cell of comma-separated values, quoted where it needs to be (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace flinch::train
