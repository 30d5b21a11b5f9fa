// SPDX-License-Identifier: MIT
#pragma once

namespace flinch::program {

/// CPU time of the calling thread, s.
double thread_cpu_s();

}  // namespace flinch::program
