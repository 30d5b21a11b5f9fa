// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "models/selector.h"
#include "train/fit/selector_record.h"

namespace flinch::train {

/// Returns the bytes of a selector's file, the same for the same selector and library.
/// `library_file` is the library's whole file, so that the run time needs no other file; empty for
/// a selector without clips. `record` is for people, and may be null. Throws Error if the run time
/// would refuse the bytes (see runtime/selector_file.h), so that no unusable file is written.
std::string selector_bytes(const models::Selector& selector,
                           std::span<const std::byte> library_file = {},
                           const SelectorRecord* record = nullptr);

/// Writes the file completely or not at all. Throws Error.
void write_selector(const models::Selector& selector, std::span<const std::byte> library_file,
                    const SelectorRecord* record, const std::string& path);

}  // namespace flinch::train
