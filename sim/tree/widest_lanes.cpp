// SPDX-License-Identifier: MIT
#include "sim/tree/tree_lanes.h"

namespace flinch::sim {

std::size_t widest_lanes() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f")) return 8;
  if (__builtin_cpu_supports("avx2")) return 4;
#endif
  return 2;
}

}  // namespace flinch::sim
