// SPDX-License-Identifier: MIT
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "runtime/library.h"
#include "tests/bench/measures.h"

// What loading a selector file costs a process that has loaded nothing before.
namespace flinch::bench {

struct LoadCost {
  double cpu_s = -1;  // negative if the file was refused
  long page_faults = 0;
};

inline LoadCost cost_so_far() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return {process_cpu_s(), usage.ru_minflt};
}

inline LoadCost cost_of_loading(const std::string& path) {
  const LoadCost before = cost_so_far();
  runtime::Library library;
  if (library.load(path) != database::LoadStatus::ok) return {};
  const LoadCost after = cost_so_far();
  return {after.cpu_s - before.cpu_s, after.page_faults - before.page_faults};
}

/// Measures in a new process, which has loaded nothing before.
inline LoadCost cost_in_new_process(const std::string& path) {
  LoadCost cost;
  int ends[2];
  if (pipe(ends) != 0) return cost;
  const pid_t child = fork();
  if (child == 0) {
    const LoadCost found = cost_of_loading(path);
    const bool written = write(ends[1], &found, sizeof found) == sizeof found;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  if (child < 0 || read(ends[0], &cost, sizeof cost) != sizeof cost) cost = {};
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return cost;
}

}  // namespace flinch::bench
