// SPDX-License-Identifier: MIT
#pragma once

namespace flinch::program {

/// CPU time that the calling thread has had, s.
double thread_cpu_s();

}  // namespace flinch::program
