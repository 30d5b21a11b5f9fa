// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "database/library/library_file.h"
#include "models/selector.h"
#include "runtime/response/footwork.h"

namespace flinch::runtime {

/// What a selector file holds.
struct SelectorFile {
  models::Selector selector;
  /// Of the selector's `library_hash`; none where the file was written without clips.
  std::optional<database::ClipLibrary> library;
  std::vector<Footwork> footwork;  ///< of each of its clips; none where the file has none
};

/// Reads a selector file's bytes: verified against the content hash, the schemas, the features
/// that this build computes, is_sound() and, where it has clips, the library's invariants
/// and is_compatible() before anything is used. On failure `file` is left as it was. Throws
/// nothing.
database::LoadStatus read_selector_file(std::span<const std::byte> bytes,
                                        SelectorFile& file) noexcept;

/// The same, of which only the selector is kept.
database::LoadStatus read_selector(std::span<const std::byte> bytes,
                                   models::Selector& selector) noexcept;
database::LoadStatus read_selector(const std::string& path, models::Selector& selector) noexcept;

/// Whether the library's clips could have this footwork (runtime/response/footwork.h).
bool is_sound(const std::vector<Footwork>& footwork, const database::ClipLibrary& library);

/// Whether classification can rely on it: clips, with the idle one among them, and known targets
/// and degrees; scaling and model of as many features as the layout has; vectors of the sizes that
/// go together; labels that are clips; finite numbers throughout.
bool is_sound(const models::Selector& selector);

/// Whether what the selector chooses can be played from the library: the hash that the selector
/// names, the same clips by name, the same idle clip, all clips annotated that it takes for so, and
/// all stances from which it has the work of responses.
bool is_compatible(const models::Selector& selector, const database::ClipLibrary& library);

}  // namespace flinch::runtime
