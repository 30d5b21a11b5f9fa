// SPDX-License-Identifier: MIT
// Simulations per second on one core: figures that track a second of motion while a ball flies at
// them, the same mix each time.
#include <benchmark/benchmark.h>

#include <memory>

#include "sim/ode/ode_encounter.h"
#include "sim/ode/ode_simulator.h"
#include "sim/rehearsal/simulator.h"
#include "sim/rehearsal/throw_simulator.h"
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

/// Time per throw, of 96 together, with some number of lanes.
void simulate_rehearsed(benchmark::State& state) {
  const auto lanes = static_cast<std::size_t>(state.range());
  if (lanes > sim::widest_lanes()) return state.SkipWithError("not on this processor");
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
  sim::ThrowSimulator throw_simulator(simulator, lanes);
  double steps = 0;
  double impulse = 0;
  while (state.KeepRunningBatch(std::ssize(throws))) {
    for (const sim::SimulationResult& result : throw_simulator.simulate(throws)) {
      steps += result.steps;
      impulse += sum(result.impulse);
    }
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["simulations_per_second"] = benchmark::Counter(runs, benchmark::Counter::kIsRate);
  state.counters["steps"] = steps / runs;
  state.counters["mean_impulse_Ns"] = impulse / runs;
}
BENCHMARK(simulate_rehearsed)
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Arg(8)
    ->Unit(benchmark::kMicrosecond)
    ->MinTime(1);

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

/// The equations of a free step of standing figures in lanes, without their contacts; time per
/// figure.
template <std::size_t kLanes>
void step_in_lanes(benchmark::State& state) {
  if (kLanes > sim::widest_lanes()) return state.SkipWithError("not on this processor");
  const sim::FigureModel plan(motion::default_character());
  const sim::ReferenceState stand =
      sim::state_at_rest(plan.skeleton, plan.model, scenes::standing(plan.skeleton));
  const sim::JointTree tree(plan);
  const auto lanes = std::make_unique<sim::TreeLanes<kLanes>>();
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    tree.put_step({stand.body, stand, 1.0 / 60, 0, {}, 0, {}}, *lanes, lane);
  }
  while (state.KeepRunningBatch(kLanes)) {
    factor_trees(plan.tree, *lanes);
    move_figures(plan.tree, *lanes);
  }
}
BENCHMARK(step_in_lanes<1>)->Unit(benchmark::kMicrosecond);
BENCHMARK(step_in_lanes<2>)->Unit(benchmark::kMicrosecond);
#ifdef __x86_64__
BENCHMARK(step_in_lanes<4>)->Unit(benchmark::kMicrosecond);
BENCHMARK(step_in_lanes<8>)->Unit(benchmark::kMicrosecond);
#endif

}  // namespace
}  // namespace flinch
