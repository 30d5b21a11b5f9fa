// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "database/library_file.h"
#include "models/selector.h"

namespace flinch::runtime {

/// Reads a selector from a file's bytes: verified against the schema, the content hash and the
/// invariants that classification relies on (sizes, indices, finite numbers, the feature layout
/// that this build computes) before anything is used. On failure `selector` is left as it was.
/// Throws nothing.
database::LoadStatus read_selector(std::span<const std::byte> bytes,
                                   models::Selector& selector) noexcept;
database::LoadStatus read_selector(const std::string& path, models::Selector& selector) noexcept;

}  // namespace flinch::runtime
