// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "train/store/sqlite.h"
#include "train/store/store.h"

namespace flinch::train {

/// The tables of a store, except the observations; docs/store.md describes them for users.

/// SQLite application id that marks a Flinch store: "FLCH".
inline constexpr int kStoreApplicationId = 0x464C4348;
/// The same as the bytes in the file's header.
inline constexpr std::string_view kStoreMark = "FLCH";

inline constexpr const char* kDamagedStore =
    "the store is damaged; delete it and run `flinch simulate` again";

/// Creates the tables and fills all but the observations.
void write_header(Database& database, const StoreHeader& header);

/// Throws Error if the file is not a store, is of another version, holds anything but the tables of
/// a store, or has a value out of bounds.
StoreHeader read_header(Database& database);

/// Seals a finished store: writes its range, and a checksum of the range and of everything but the
/// library and the observations.
void write_seal(Database& database, const ScenarioRange& range);
/// Removes the seal, if there is one.
void break_seal(Database& database);
/// Returns the sealed range, or nothing while the store is unfinished. Throws Error if the checksum
/// does not match.
std::optional<ScenarioRange> read_seal(Database& database);

}  // namespace flinch::train
