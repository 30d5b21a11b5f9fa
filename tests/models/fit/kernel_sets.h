// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "models/fit/kernels.h"

namespace flinch::models {

/// Returns the kernels for every instruction set that this processor has, narrowest first.
inline std::vector<const Kernels*> kernel_sets() {
  std::vector<const Kernels*> sets;
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
    if (const Kernels* kernels = kernels_for(set)) sets.push_back(kernels);
  return sets;
}

}  // namespace flinch::models
