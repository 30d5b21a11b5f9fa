// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "models/selector.h"

namespace flinch::train::program {

/// What a file holds, told by its first bytes.
enum class FileKind : std::uint8_t { library, store, selector, bvh, empty, other };

/// Throws Error when the file cannot be read.
FileKind kind_of(const std::string& path);

/// "a library", "a store", …: for messages.
std::string describe(FileKind kind);

/// Reads a selector. Throws Error that says what is wrong, and what the file is instead where that
/// can be told.
models::Selector load_selector(const std::string& path);

}  // namespace flinch::train::program
