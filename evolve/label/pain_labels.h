// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "evolve/pain/pain.h"
#include "train/objective/vulnerability.h"
#include "train/store/store.h"

namespace flinch::evolve {

/// How much an impulse on each body hurts where it hurts most, relative to the region that hurts
/// most of all. What a selector that is fitted to pain looks ahead by, since a game's simulation
/// tells bodies and no places.
train::VulnerabilityProfile largest_pain(const PainMap& map, const std::string& name);

/// Makes the damage of a store's trials their pain (equation 4.2), relative to that of the region
/// that hurts most: damage = sum_i P(p_i) |J_i| / max P, N·s. Each impulse becomes the one that
/// hurts as much where its body hurts most, so that damage_ns() by largest_pain() is that sum.
/// Throws Error if the store does not keep places. `path` is for messages.
void relabel_by_pain(const PainMap& map, train::Store& store, const std::string& path);

}  // namespace flinch::evolve
