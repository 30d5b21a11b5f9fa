// SPDX-License-Identifier: MIT
#pragma once

#include "bindings/js/exports.h"
#include "runtime/character.h"
#include "runtime/library.h"

namespace flinch::js {

/// The character of a scenario, and what it perceives.
struct PlacedScenario {
  runtime::Character character;
  runtime::Perception perception;
};

/// Returns FLINCH_OK for a scenario that can be answered; FLINCH_BAD_INDEX for an unknown target,
/// FLINCH_BAD_THREAT for a ball or a time that cannot be answered.
flinch_status check(const flinch_scenario& scenario);

/// Places the character of a scenario that was checked.
PlacedScenario placed(const runtime::Library& library, const flinch_scenario& scenario);

}  // namespace flinch::js
