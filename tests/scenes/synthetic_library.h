// SPDX-License-Identifier: MIT
#pragma once

#include "database/library/library.h"

namespace flinch::scenes {

/// A small library whose clips are posed by rule, for tests that need one anywhere: the default
/// character raises its hands, ducks, turns its shoulder, steps aside and lifts a leg, each also
/// mirrored where it has a side.
database::ClipLibrary synthetic_library();

}  // namespace flinch::scenes
