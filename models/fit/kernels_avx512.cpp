// SPDX-License-Identifier: MIT
#include "models/fit/kernels_clone.h"

namespace flinch::models {

extern const Kernels kAvx512Kernels;
const Kernels kAvx512Kernels = make_kernels<16>("AVX-512");

}  // namespace flinch::models
