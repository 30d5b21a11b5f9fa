// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace flinch::tests {

/// How often this program has called operator new, which allocation_count.cpp replaces. Not for
/// programs of several threads.
std::size_t allocation_count();

}  // namespace flinch::tests
