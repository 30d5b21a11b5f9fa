// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace flinch::program {

/// From now on the first Ctrl-C, or SIGTERM, sets the flag that this returns instead of ending the
/// program; a second one ends it.
const std::atomic<bool>& catch_interrupts();

}  // namespace flinch::program
