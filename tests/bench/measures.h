// SPDX-License-Identifier: MIT
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

// What benchmarks and studies measure by.
namespace flinch::bench {

/// A clock of clock_gettime, s.
inline double clock_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
/// CPU time that this thread has had, s: other programs do not count.
inline double thread_cpu_s() {
  return clock_s(CLOCK_THREAD_CPUTIME_ID);
}
/// CPU time that all threads of the process have had, s.
inline double process_cpu_s() {
  return clock_s(CLOCK_PROCESS_CPUTIME_ID);
}

/// The most memory that the process has had so far, MiB.
inline double peak_memory_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Index in `count` sorted values, at least one, of the quantile: the order statistic at or below.
inline std::size_t quantile_index(std::size_t count, double fraction) {
  return static_cast<std::size_t>(fraction * static_cast<double>(count - 1));
}

/// The quantile of values in any order; 0 of none.
inline double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[quantile_index(values.size(), fraction)];
}

}  // namespace flinch::bench
