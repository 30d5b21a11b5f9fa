// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace flinch::tests {

/// Returns how often this thread has called operator new, which allocation_count.cpp replaces.
std::size_t allocation_count();

/// Returns how many bytes this thread has got from operator new so far, whether freed or not: an
/// upper bound on what it held at any moment since an earlier call, when their difference is taken.
std::size_t allocated_bytes();

}  // namespace flinch::tests
