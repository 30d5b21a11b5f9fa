// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "tests/scenes/synthetic_library.h"
#include "train/simulate/simulate.h"

namespace flinch::train {
namespace {

/// Whole trials as `flinch simulate` runs them on one thread: response, simulation and work.
void try_clips(benchmark::State& state) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const SimulationSetup setup(library, {});
  std::int64_t trials = 0;
  double impulse = 0;  // shows that the work is the same everywhere
  for (auto _ : state) {
    const Observation posed = make_observation(setup, static_cast<std::uint64_t>(trials % 64));
    const Trial trial =
        try_clip(setup, posed.scenario,
                 posed.trials[static_cast<std::size_t>(trials) % posed.trials.size()].clip);
    if (trials++ < 64)
      for (const float i : trial.impulse) impulse += double{i};
  }
  state.SetItemsProcessed(trials);
  state.counters["impulse_of_first_64_ns"] = impulse;
}
BENCHMARK(try_clips)->Name("unabridged_simulations")->Unit(benchmark::kMillisecond)->MinTime(3);

void sample_scenarios(benchmark::State& state) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const SimulationSetup setup(library, {});
  std::uint64_t number = 0;
  for (auto _ : state) benchmark::DoNotOptimize(make_observation(setup, number++));
  state.SetItemsProcessed(static_cast<std::int64_t>(number));
}
BENCHMARK(sample_scenarios)->Name("scenarios")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace flinch::train
