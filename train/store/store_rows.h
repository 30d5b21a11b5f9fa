// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "train/objective/observation.h"
#include "train/store/sqlite.h"
#include "train/store/store.h"

namespace flinch::train {

/// The table of a store that has one row a scenario; docs/store.md describes it for people.

void create_observation_table(Database& database);

/// A statement that takes one observation after the other.
Statement prepare_insert(Database& database);
void insert(Statement& statement, const Observation& observation);

/// A statement that yields all observations by number.
Statement prepare_select(Database& database);
/// A statement that yields the observation whose number is bound to it.
Statement prepare_select_one(Database& database);

/// The observation of the row that the statement stands on, without its features. Throws Error for
/// a damaged row.
Observation observation_of(const Statement& row, const StoreHeader& header,
                           const std::string& path);

/// From the lowest number to the highest.
ScenarioRange range_of_rows(Database& database);

/// The numbers of `wanted` that have no row.
std::vector<ScenarioRange> missing_rows(Database& database, const ScenarioRange& wanted);

/// Whether two observations have the same row.
bool have_same_row(const Observation& a, const Observation& b);

}  // namespace flinch::train
