// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace flinch::program {

/// From this call on, the first Ctrl-C or SIGTERM sets the returned flag instead of ending the
/// program; a second one ends it.
const std::atomic<bool>& catch_interrupts();

}  // namespace flinch::program
