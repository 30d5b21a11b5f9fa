// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/objective/observation.h"
#include "train/store/sqlite.h"
#include "train/store/store.h"

namespace flinch::train {

/// The table of a store with one row per scenario; docs/store.md describes it for users.

/// Returns the statement that creates the table of this version of the format.
std::string observation_table_sql(int version);

/// Prepares a statement that inserts one observation per run.
Statement prepare_insert(Database& database, const StoreHeader& header);
void insert(Statement& statement, const Observation& observation, const StoreHeader& header);

/// Prepares a statement that yields all observations by number.
Statement prepare_select(Database& database, const StoreHeader& header);
/// Prepares a statement that yields the observation whose number is bound to it.
Statement prepare_select_one(Database& database, const StoreHeader& header);

/// Returns the observation in the statement's current row, without its features. Throws Error for a
/// damaged row.
Observation observation_of(const Statement& row, const StoreHeader& header,
                           const std::string& path);

/// Returns the range from the lowest number to the highest.
ScenarioRange range_of_rows(Database& database);

/// Returns how many rows there are.
std::uint64_t count_rows(Database& database);

/// Returns the numbers of `wanted` that have no row.
std::vector<ScenarioRange> missing_rows(Database& database, const ScenarioRange& wanted);

/// Whether the rows of two observations are the same.
bool have_same_row(const Observation& a, const Observation& b);

}  // namespace flinch::train
