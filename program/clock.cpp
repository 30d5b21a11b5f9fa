// SPDX-License-Identifier: MIT
#include "program/clock.h"

#include <ctime>

namespace flinch::program {

double thread_cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace flinch::program
