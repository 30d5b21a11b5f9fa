// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "models/selector.h"

namespace flinch::train::program {

/// Reads a selector. Throws Error that says what is wrong, and what the file is instead where that
/// can be told.
models::Selector load_selector(const std::string& path);

}  // namespace flinch::train::program
