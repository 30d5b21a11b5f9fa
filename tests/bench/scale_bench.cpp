// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "tests/bench/measures.h"
#include "tests/scenes/temporary_folder.h"
#include "train/simulate/simulate.h"
#include "train/simulate/worker_messages.h"
#include "train/store/store_trials.h"

namespace flinch::train {
namespace {

/// The default library and everything that is prepared once.
struct Scene {
  database::ClipLibrary library = database::authored_library(motion::default_character());
  SimulationSetup setup{library, {}};
};
Scene& scene() {
  static Scene scene;
  return scene;
}

/// All of `flinch simulate` except reading the library: scenarios, rehearsals, simulations, the
/// store. SSE2 has 2 lanes, AVX2 4, AVX-512 8.
void simulate_scenarios(benchmark::State& state) {
  const auto lanes = static_cast<std::size_t>(state.range(2));
  if (lanes > sim::widest_lanes()) return state.SkipWithError("not on this processor");
  const SimulationSetup& setup = scene().setup;
  SimulationRun run;
  run.wanted = {0, static_cast<std::uint64_t>(state.range(0))};
  run.batch.threads = static_cast<int>(state.range(1));
  run.batch.lanes = lanes;
  run.batch.cpu_s = bench::thread_cpu_s;
  run.memory = plan_memory(setup, std::uint64_t{1} << 30, run.batch.threads);
  SimulationProgress last;
  run.report = [&last](const SimulationProgress& progress) { last = progress; };
  for (auto _ : state) {
    const tests::TemporaryFolder folder;
    simulate_store(setup, folder / "store", run);
  }
  const double cpu_s = last.cpu.total_s();
  const auto simulations = static_cast<double>(last.counts.simulations);
  state.counters["cpu_s"] = cpu_s;
  state.counters["cpu_ms_per_scenario"] = 1e3 * cpu_s / static_cast<double>(state.range(0));
  state.counters["rehearsing_share"] = last.cpu.rehearsing_s / cpu_s;
  state.counters["simulations_per_cpu_s"] = simulations / cpu_s;
  state.counters["hit_rate"] = static_cast<double>(last.counts.hits) / simulations;
  state.counters["peak_megabytes"] = bench::peak_memory_mib();
}
BENCHMARK(simulate_scenarios)
    ->ArgNames({"scenarios", "threads", "lanes"})
    ->Args({1000, 1, 2})
    ->Args({1000, 2, 2})
    ->Args({8200, 1, 2})
    ->Args({8200, 1, 4})
    ->Args({8200, 1, 8})
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

void rehearse_responses(benchmark::State& state) {
  const SimulationSetup& setup = scene().setup;
  const int last = time_to_impact_count(setup.plan.distribution) - 1;
  int clip = 0;
  std::size_t bytes = 0;
  for (auto _ : state) {
    clip = (clip + 1) % static_cast<int>(setup.library.clips.size());
    if (!setup.library.clip(clip).annotation) continue;
    bytes = rehearse(setup, setup.responses.key_of(clip, {0, last})).byte_count();
  }
  state.counters["kilobytes"] = static_cast<double>(bytes) / 1e3;
  state.counters["responses_of_library"] = static_cast<double>(setup.responses.count());
}
BENCHMARK(rehearse_responses)->Unit(benchmark::kMillisecond);

/// Typical observations, without the time that simulating them takes.
std::vector<Observation> posed(const SimulationSetup& setup, ScenarioRange range) {
  std::vector<Observation> observations;
  for (std::uint64_t number = range.first; number < range.end(); ++number) {
    observations.push_back(make_observation(setup, number));
    for (Trial& trial : observations.back().trials) {
      trial.work_j = 100;
      trial.impulse[motion::Body::chest] = 3;
    }
  }
  return observations;
}

/// The writer's work for a worker's range: decodes the message and commits it.
void write_ranges(benchmark::State& state) {
  const SimulationSetup& setup = scene().setup;
  const auto size = static_cast<std::uint64_t>(state.range(0));
  RangeResult done{{0, size}, {}, {}, {}, {}};
  for (const Observation& observation : posed(setup, done.range))
    done.trials.push_back(encode_trials(observation.trials));
  done.places.resize(done.trials.size());
  const std::vector<std::byte> message = encode(done);
  const tests::TemporaryFolder folder;
  StoreWriter writer(folder / "store", make_store_header(setup), {0, std::uint64_t{1} << 40});
  std::uint64_t first = 0;
  for (auto _ : state) {
    const RangeResult arrived = std::get<RangeResult>(decode(message));
    std::vector<Observation> observations;
    for (std::uint64_t i = 0; i < size; ++i) {
      observations.push_back(make_observation(setup, first + i));
      observations.back().trials = decode_trials(arrived.trials[i]);
    }
    writer.append(observations);
    first += size;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(first));
  state.counters["message_bytes_per_scenario"] =
      static_cast<double>(message.size()) / static_cast<double>(size);
}
BENCHMARK(write_ranges)
    ->ArgName("scenarios")
    ->Arg(1)
    ->Arg(128)
    ->Arg(4096)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace flinch::train
