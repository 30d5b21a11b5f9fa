// SPDX-License-Identifier: MIT
// Simulations a second on one core: figures that track a second of motion while a ball flies at
// them, the same mix each time.
#include <benchmark/benchmark.h>

#include "tests/sim/random_hits.h"

namespace flinch {
namespace {

void simulate_a_second(benchmark::State& state) {
  const motion::Character character = motion::default_character();
  const auto motions = scenes::motions_by_rule(character.skeleton);
  const auto hits = scenes::random_hits(character, motions, 96, 1);
  const sim::Simulator simulator(character, {});
  std::size_t next = 0;
  double steps = 0;
  double impulse = 0;
  for (auto _ : state) {
    const scenes::Hit& hit = hits[next++ % hits.size()];
    const auto result = simulator.simulate(motions[hit.motion].motion, &hit.ball, 1);
    steps += result.steps;
    for (double of_body : result.impulse) impulse += of_body;
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["simulations_per_second"] = benchmark::Counter(runs, benchmark::Counter::kIsRate);
  state.counters["steps"] = steps / runs;
  state.counters["per_step"] =
      benchmark::Counter(steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["mean_impulse_Ns"] = impulse / runs;
}
BENCHMARK(simulate_a_second)->Unit(benchmark::kMillisecond)->MinTime(2);

void simulate_without_a_ball(benchmark::State& state) {
  const motion::Character character = motion::default_character();
  const auto motions = scenes::motions_by_rule(character.skeleton);
  const sim::Simulator simulator(character, {});
  std::size_t next = 0;
  for (auto _ : state) {
    const motion::Motion& motion = motions[next++ % motions.size()].motion;
    benchmark::DoNotOptimize(simulator.simulate(motion, nullptr, 1));
  }
}
BENCHMARK(simulate_without_a_ball)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flinch
