// SPDX-License-Identifier: MIT
// Simulates, event by event, how busy the writer is in a run on many machines, and prints the table
// of docs/scale.md:
//
//     writer_load SIMULATE_MS WRITE_US MESSAGE_US [SCENARIOS]
//
// The arguments are CPU times that bench_scale measures: to simulate a scenario (ms, on one core)
// and, for the writer, to store one (us) and to answer a message (us). SCENARIOS is 10 million by
// default. The ranges are those that the program would hand out.
#include <cstdio>
#include <queue>

#include "features/random.h"
#include "tests/bench/study.h"
#include "train/simulate/scenario_scheduler.h"

namespace flinch::train {
namespace {

struct Costs {
  double simulate_s = 0;  ///< per scenario, on one core
  double write_s = 0;     ///< per scenario, by the writer
  double message_s = 0;   ///< per message, by the writer
};

struct Cluster {
  int processes = 1;  ///< besides the writer
  int threads = 1;    ///< per process
};

/// When a worker asks for work, and the range that it has done.
struct Request {
  double at_s = 0;
  std::uint64_t scenarios = 0;
  // Puts the earliest on top.
  bool operator<(const Request& other) const { return at_s > other.at_s; }
};

struct Load {
  double took_s = 0;
  double busy_s = 0;    ///< of the writer
  double waited_s = 0;  ///< of all workers, for the writer
  std::uint64_t messages = 0;
};

/// The writer answers requests in their order, one at a time. Machines differ in speed, and
/// scenarios in cost, by up to a tenth either way.
Load load_of(const Cluster& cluster, const Costs& costs, std::uint64_t scenarios) {
  constexpr std::uint64_t kMost = 128;
  ScenarioScheduler ranges({{0, scenarios}}, cluster.processes, {kMost});
  features::Random random(1, features::RandomStream::baseline, 0);
  std::priority_queue<Request> requests;
  for (int i = 0; i < cluster.processes; ++i) requests.push({0.001 * random.uniform(), 0});
  Load load;
  double free_s = 0;  // when the writer has finished all earlier requests
  while (!requests.empty()) {
    const Request request = requests.top();
    requests.pop();
    const double begin_s = std::max(free_s, request.at_s);
    const double cost_s = costs.message_s + static_cast<double>(request.scenarios) * costs.write_s;
    free_s = begin_s + cost_s;
    load.busy_s += cost_s;
    load.waited_s += free_s - request.at_s;
    ++load.messages;
    if (const auto range = ranges.next(cluster.threads)) {
      const double work_s = static_cast<double>(range->count) * costs.simulate_s / cluster.threads;
      requests.push({free_s + work_s * random.uniform(0.9, 1.1), range->count});
    }
  }
  load.took_s = free_s;
  return load;
}

void run(const bench::StudyArguments& arguments) {
  const Costs costs{1e-3 * arguments.number<double>(0), 1e-6 * arguments.number<double>(1),
                    1e-6 * arguments.number<double>(2)};
  const auto scenarios = arguments.number_or<std::uint64_t>(3, 10'000'000);
  std::printf(
      "| cores | processes | threads of each | minutes | writer busy | helpers wait | of the ideal "
      "|\n| --: | --: | --: | --: | --: | --: | --: |\n");
  for (const int cores : {64, 256, 512, 1024, 2048, 4096}) {
    for (const int threads : {1, 32}) {
      if (threads > cores) continue;
      const Cluster cluster{cores / threads, threads};
      const Load load = load_of(cluster, costs, scenarios);
      const double ideal_s = static_cast<double>(scenarios) * costs.simulate_s / cores;
      std::printf("| %d | %d | %d | %.1f | %.0f %% | %.1f %% | %.0f %% |\n", cores,
                  cluster.processes, threads, load.took_s / 60, 100 * load.busy_s / load.took_s,
                  100 * load.waited_s / (load.took_s * cluster.processes),
                  100 * ideal_s / load.took_s);
    }
  }
}

}  // namespace
}  // namespace flinch::train

int main(int count, char** arguments) {
  return flinch::bench::study_main(
      count, arguments, {"writer_load SIMULATE_MS WRITE_US MESSAGE_US [SCENARIOS]", 3, 4},
      flinch::train::run);
}
