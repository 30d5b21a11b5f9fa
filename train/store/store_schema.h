// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "train/store/sqlite.h"
#include "train/store/store.h"

namespace flinch::train {

/// How the tables of a store look, but for the observations; docs/store.md describes them for
/// people.

/// Says in the file's header that it is a Flinch store: "FLCH".
inline constexpr int kStoreApplicationId = 0x464C4348;

inline constexpr const char* kDamagedStore =
    "the store is damaged; delete it and run `flinch simulate` again";

/// Makes the tables and fills in all but the observations.
void write_header(Database& database, const StoreHeader& header);

/// Throws Error when the file is no store or of another version.
StoreHeader read_header(Database& database);

/// A finished store is sealed: the range that it holds, and a checksum of that and of all but the
/// library and the observations.
void write_seal(Database& database, const ScenarioRange& range);
/// Takes the seal away, if there is one.
void break_seal(Database& database);
/// The range that was sealed; nothing while the store is being made. Throws Error when the checksum
/// says otherwise.
std::optional<ScenarioRange> read_seal(Database& database);

}  // namespace flinch::train
