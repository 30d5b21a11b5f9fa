// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace flinch::tests {

/// Returns how often this thread has called operator new, which allocation_count.cpp replaces.
std::size_t allocation_count();

}  // namespace flinch::tests
