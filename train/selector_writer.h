// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "models/selector.h"

namespace flinch::train {

/// The bytes of a selector's file: the same for the same selector. Throws Error when the run time
/// would refuse to read them (see runtime/selector_file.h), so that nothing is written that cannot
/// be used.
std::string selector_bytes(const models::Selector& selector);

/// Writes the file whole or not at all. Throws Error.
void write_selector(const models::Selector& selector, const std::string& path);

}  // namespace flinch::train
