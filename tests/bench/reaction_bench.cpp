// SPDX-License-Identifier: MIT
// Cost of a reaction per 60 Hz frame, by its phase in that frame.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "tests/bench/measures.h"
#include "tests/reaction/reaction_scenes.h"

namespace flinch {
namespace {

using reaction::ReactionPhase;

void report(benchmark::State& state, const std::vector<double>& frames_us) {
  double sum = 0;
  for (double frame_us : frames_us) sum += frame_us;
  const auto count = static_cast<double>(frames_us.size());
  state.counters["mean_us"] = sum / count;
  state.counters["p99_us"] = bench::quantile(frames_us, 0.99);
  state.counters["max_us"] = bench::quantile(frames_us, 1);
}

/// A second of reaction per iteration; reports the frames whose phase is one of `phases`.
void frames(benchmark::State& state, const std::vector<ReactionPhase>& phases, double mass_kg) {
  const motion::Physique man = motion::default_character();
  const auto motions = scenes::motions_by_rule(man.skeleton);
  const auto cases = scenes::random_reaction_cases(man, motions, 96, 1, mass_kg);
  reaction::Reaction reaction(reaction::make_figure_model(man));
  std::vector<double> frames_us;
  std::size_t next = 0;
  for (auto _ : state) {
    const scenes::ReactionCase& reaction_case = cases[next++ % cases.size()];
    scenes::begin(reaction, reaction_case);
    for (int k = 1; k <= 60; ++k) {
      const motion::Pose wanted =
          scenes::pose_at(*reaction_case.motion, reaction_case.begin_s + k * scenes::kFrame_s);
      const double begin_s = bench::thread_cpu_s();
      reaction.advance(scenes::kFrame_s, wanted, wanted);
      const double frame_us = 1e6 * (bench::thread_cpu_s() - begin_s);
      if (std::count(phases.begin(), phases.end(), reaction.phase()) > 0) {
        frames_us.push_back(frame_us);
      }
    }
  }
  report(state, frames_us);
}
// Each of the 96 once or twice.
BENCHMARK_CAPTURE(frames, struck, {ReactionPhase::waiting, ReactionPhase::struck}, 0.27)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(192);
BENCHMARK_CAPTURE(frames, recovering, {ReactionPhase::recovering}, 0.27)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(192);
BENCHMARK_CAPTURE(frames, returning, {ReactionPhase::returning, ReactionPhase::over}, 0.27)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(192);
BENCHMARK_CAPTURE(frames, knocked_over, {ReactionPhase::knocked_over}, 20.0)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(192);

void begin(benchmark::State& state) {
  const motion::Physique man = motion::default_character();
  const auto motions = scenes::motions_by_rule(man.skeleton);
  const auto cases = scenes::random_reaction_cases(man, motions, 12, 1);
  reaction::Reaction reaction(reaction::make_figure_model(man));
  std::size_t next = 0;
  for (auto _ : state) scenes::begin(reaction, cases[next++ % cases.size()]);
}
BENCHMARK(begin)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace flinch
