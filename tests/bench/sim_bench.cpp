// SPDX-License-Identifier: MIT
// Simulations per second on one core: figures that track a second of motion while a ball flies at
// them, the same mix each time.
#include <benchmark/benchmark.h>

#include "sim/ode/ode_encounter.h"
#include "sim/ode/ode_simulator.h"
#include "sim/rehearsal/simulator.h"
#include "tests/sim/random_hits.h"

namespace flinch {
namespace {

void simulate_a_second(benchmark::State& state) {
  const motion::Physique character = motion::default_character();
  const auto motions = scenes::motions_by_rule(character.skeleton);
  const auto hits = scenes::random_hits(character, motions, 96, 1);
  const sim::OdeSimulator simulator(character, {});
  std::size_t next = 0;
  double steps = 0;
  double impulse = 0;
  for (auto _ : state) {
    const scenes::Hit& hit = hits[next++ % hits.size()];
    const auto result = simulator.simulate(motions[hit.motion].motion, &hit.ball, 1);
    steps += result.steps;
    impulse += sum(result.impulse);
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
  const motion::Physique character = motion::default_character();
  const auto motions = scenes::motions_by_rule(character.skeleton);
  const sim::OdeSimulator simulator(character, {});
  std::size_t next = 0;
  for (auto _ : state) {
    const motion::Motion& motion = motions[next++ % motions.size()].motion;
    benchmark::DoNotOptimize(simulator.simulate(motion, nullptr, 1));
  }
}
BENCHMARK(simulate_without_a_ball)->Unit(benchmark::kMillisecond);

void rehearse_a_second(benchmark::State& state) {
  const motion::Physique character = motion::default_character();
  const auto motions = scenes::motions_by_rule(character.skeleton);
  const sim::Simulator simulator(character, {});
  std::size_t next = 0;
  for (auto _ : state) {
    const motion::Motion& motion = motions[next++ % motions.size()].motion;
    benchmark::DoNotOptimize(simulator.rehearse(motion, 0, 1));
  }
}
BENCHMARK(rehearse_a_second)->Unit(benchmark::kMillisecond);

/// Time per throw, of 96 together.
void simulate_rehearsed(benchmark::State& state) {
  const motion::Physique character = motion::default_character();
  const auto motions = scenes::motions_by_rule(character.skeleton);
  const auto hits = scenes::random_hits(character, motions, 96, 1);
  const sim::Simulator simulator(character, {});
  std::vector<sim::Rehearsal> rehearsals;
  for (const auto& [name, motion] : motions) {
    rehearsals.push_back(simulator.rehearse(motion, 0, 1));
  }
  std::vector<sim::Throw> throws;
  for (const scenes::Hit& hit : hits) throws.push_back({rehearsals[hit.motion], hit.ball});
  double steps = 0;
  double impulse = 0;
  while (state.KeepRunningBatch(std::ssize(throws))) {
    for (const sim::SimulationResult& result : simulator.simulate(throws)) {
      steps += result.steps;
      impulse += sum(result.impulse);
    }
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["simulations_per_second"] = benchmark::Counter(runs, benchmark::Counter::kIsRate);
  state.counters["steps"] = steps / runs;
  state.counters["mean_impulse_Ns"] = impulse / runs;
}
BENCHMARK(simulate_rehearsed)->Unit(benchmark::kMicrosecond)->MinTime(1);

/// A free step of a standing figure, with ODE and with the tree.
template <class Scene>
void step_standing(benchmark::State& state) {
  const sim::FigureModel plan(motion::default_character());
  const sim::ReferenceState stand =
      sim::state_at_rest(plan.skeleton, plan.model, scenes::standing(plan.skeleton));
  constexpr double kStep_s = 1.0 / 60;
  Scene scene(plan, stand, nullptr, 9.81);
  for (auto _ : state) {
    scene.clear_contacts();
    scene.add_supports(stand, kStep_s);
    scene.step(stand, kStep_s);
  }
}
BENCHMARK(step_standing<sim::OdeScene>)->Name("step_by_ode")->Unit(benchmark::kMicrosecond);
BENCHMARK(step_standing<sim::TreeScene>)
    ->Name("step_along_the_tree")
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace flinch
