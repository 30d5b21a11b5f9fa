// SPDX-License-Identifier: MIT
#include "models/fit/kernels_clone.h"

namespace flinch::models {

extern const Kernels kAvx2Kernels;
const Kernels kAvx2Kernels = make_kernels<8>("AVX2");

}  // namespace flinch::models
