// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "train/sqlite.h"
#include "train/store.h"

namespace flinch::train {

/// How the tables of a store look; docs/store.md describes them for people.

/// Says in the file's header that it is a Flinch store: "FLCH".
inline constexpr int kStoreApplicationId = 0x464C4348;

/// Makes the tables and fills in all but the observations.
void write_header(Database& database, const StoreHeader& header);

/// Throws Error when the file is no store or of another version.
StoreHeader read_header(Database& database);

/// A statement that takes one observation after the other.
Statement prepare_insert(Database& database);
void insert(Statement& statement, const Observation& observation);

/// A statement that yields all observations by number.
Statement prepare_select(Database& database);
/// The observation of the row that the statement stands on. Throws Error for a damaged row.
Observation observation_of(const Statement& row, const StoreHeader& header,
                           const std::string& path);

/// One trial after the other, little-endian: the clip as u16, work and 17 impulses as f32.
inline constexpr std::size_t kTrialBytes = 2 + 4 + 4 * motion::kBodyCount;
std::vector<std::byte> encode_trials(std::span<const Trial> trials);
std::vector<Trial> decode_trials(std::span<const std::byte> bytes);

}  // namespace flinch::train
