// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "database/library_file.h"
#include "models/selector.h"

namespace flinch::runtime {

/// Reads a selector from a file's bytes: verified against the content hash, the schema, the feature
/// layout that this build computes and is_sound() before anything is used. On failure `selector` is
/// left as it was. Throws nothing.
database::LoadStatus read_selector(std::span<const std::byte> bytes,
                                   models::Selector& selector) noexcept;
database::LoadStatus read_selector(const std::string& path, models::Selector& selector) noexcept;

/// Whether classification can rely on it: clips, with the idle one among them, and known targets
/// and degrees; scaling and model of kFeatureCount features; vectors of the sizes that go together;
/// labels that are clips; finite numbers throughout.
bool is_sound(const models::Selector& selector);

}  // namespace flinch::runtime
