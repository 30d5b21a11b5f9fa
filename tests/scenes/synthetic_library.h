// SPDX-License-Identifier: MIT
#pragma once

#include "database/library/library.h"

namespace flinch::scenes {

/// Makes a small library whose clips are posed by rule, for tests of any room: the default
/// character raises its hands, ducks, turns its shoulder, steps aside and lifts a leg; clips with a
/// side are also mirrored.
database::ClipLibrary synthetic_library();

}  // namespace flinch::scenes
