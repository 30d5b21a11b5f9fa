// SPDX-License-Identifier: MIT
#include "models/fit/kernels_clone.h"

namespace flinch::models {

extern const Kernels kBaselineKernels;
const Kernels kBaselineKernels = make_kernels<4>("baseline");

}  // namespace flinch::models
