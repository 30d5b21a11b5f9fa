// SPDX-License-Identifier: MIT
#include "models/fit/kernels.h"

#include <initializer_list>

namespace flinch::models {

// Defined in the file of each instruction set.
extern const Kernels kBaselineKernels;
#ifdef __x86_64__
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;
#endif

const Kernels* kernels_for(InstructionSet set) {
#ifdef __x86_64__
  switch (set) {
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") ? &kAvx2Kernels : nullptr;
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") ? &kAvx512Kernels : nullptr;
    case InstructionSet::baseline:
      break;
  }
#endif
  return set == InstructionSet::baseline ? &kBaselineKernels : nullptr;
}

const Kernels& widest_kernels() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2})
    if (const Kernels* kernels = kernels_for(set)) return *kernels;
  return kBaselineKernels;
}

}  // namespace flinch::models
