// SPDX-License-Identifier: MIT
// Measures what the first load of a selector file costs a process, including page faults.
//
//     first_load SELECTOR [PROCESSES]
//
// Each process loads the file once; prints the median and the extremes of their CPU times.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "runtime/library.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"

namespace flinch {
namespace {

struct Cost {
  double cpu_s = -1;  // negative if the file was refused
  long page_faults = 0;
};

Cost cost_so_far() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return {bench::process_cpu_s(), usage.ru_minflt};
}

Cost cost_of_loading(const std::string& path) {
  const Cost before = cost_so_far();
  runtime::Library library;
  if (library.load(path) != database::LoadStatus::ok) return {};
  const Cost after = cost_so_far();
  return {after.cpu_s - before.cpu_s, after.page_faults - before.page_faults};
}

/// Measures in a new process, which has loaded nothing before.
Cost cost_in_new_process(const std::string& path) {
  Cost cost;
  int ends[2];
  if (pipe(ends) != 0) return cost;
  const pid_t child = fork();
  if (child == 0) {
    const Cost found = cost_of_loading(path);
    const bool written = write(ends[1], &found, sizeof found) == sizeof found;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  if (child < 0 || read(ends[0], &cost, sizeof cost) != sizeof cost) cost = {};
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return cost;
}

void run(const bench::StudyArguments& arguments) {
  const std::string& path = arguments.text(0);
  const int processes = arguments.number_or(1, 21);
  if (processes < 1) throw Error("", "at least one process is needed");
  std::vector<Cost> costs;
  for (int i = 0; i < processes; ++i) {
    costs.push_back(cost_in_new_process(path));
    if (costs.back().cpu_s < 0) throw Error(path, "the file was refused");
  }
  std::sort(costs.begin(), costs.end(),
            [](const Cost& a, const Cost& b) { return a.cpu_s < b.cpu_s; });
  const Cost& median = costs[costs.size() / 2];
  std::printf("first load: %.2f ms of CPU (%.2f to %.2f in %d processes), %ld page faults\n",
              1e3 * median.cpu_s, 1e3 * costs.front().cpu_s, 1e3 * costs.back().cpu_s, processes,
              median.page_faults);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"first_load SELECTOR [PROCESSES]", 1, 2},
                                   flinch::run);
}
