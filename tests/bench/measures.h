// SPDX-License-Identifier: MIT
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

// Clocks, memory and quantiles for benchmarks and studies.
namespace flinch::bench {

/// Reads a clock of clock_gettime, s.
inline double clock_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
/// CPU time of this thread, s, which other programs do not affect.
inline double thread_cpu_s() {
  return clock_s(CLOCK_THREAD_CPUTIME_ID);
}
/// CPU time of all threads of the process, s.
inline double process_cpu_s() {
  return clock_s(CLOCK_PROCESS_CPUTIME_ID);
}

/// Peak memory of the process so far, MiB.
inline double peak_memory_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Returns the index of a quantile in `count` sorted values, at least one: the order statistic at
/// or below it.
inline std::size_t quantile_index(std::size_t count, double fraction) {
  return static_cast<std::size_t>(fraction * static_cast<double>(count - 1));
}

/// Returns the quantile of values in any order; 0 if there are none.
inline double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[quantile_index(values.size(), fraction)];
}

}  // namespace flinch::bench
