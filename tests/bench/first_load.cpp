// SPDX-License-Identifier: MIT
// Measures what the first load of a selector file costs a process, including page faults.
//
//     first_load SELECTOR [PROCESSES]
//
// Each process loads the file once; prints the median and the extremes of their CPU times.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/bench/load_cost.h"
#include "tests/bench/study.h"

namespace flinch {
namespace {

void run(const bench::StudyArguments& arguments) {
  const std::string& path = arguments.text(0);
  const int processes = arguments.number_or(1, 21);
  if (processes < 1) throw Error("", "at least one process is needed");
  std::vector<bench::LoadCost> costs;
  for (int i = 0; i < processes; ++i) {
    costs.push_back(bench::cost_in_new_process(path));
    if (costs.back().cpu_s < 0) throw Error(path, "the file was refused");
  }
  std::sort(costs.begin(), costs.end(),
            [](const bench::LoadCost& a, const bench::LoadCost& b) { return a.cpu_s < b.cpu_s; });
  const bench::LoadCost& median = costs[costs.size() / 2];
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
