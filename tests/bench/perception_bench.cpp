// SPDX-License-Identifier: MIT
// Cost of predicting the impact of a threat on an idling figure, for the same mix of threats each
// time.
#include <benchmark/benchmark.h>

#include "features/feature_layout.h"
#include "runtime/perception.h"
#include "tests/features/moving_figure.h"
#include "tests/motion/random_motion.h"

namespace flinch {
namespace {

/// Threats at 8 to 30 m/s in 0.25 to 1.2 s, whose centre passes `aside` from the pelvis' axis.
std::vector<features::Threat> threats_passing(float least_aside, float most_aside) {
  std::mt19937 random(1);
  std::vector<features::Threat> threats;
  for (int i = 0; i < 512; ++i) {
    features::ThreatDescription approach;
    approach.azimuth = tests::uniform(random, -3.1F, 3.1F);
    approach.elevation = tests::uniform(random, 0.1F, 0.7F);
    approach.speed_mps = tests::uniform(random, 8, 30);
    approach.time_to_impact_s = tests::uniform(random, 0.25F, 1.2F);
    const float aside = tests::uniform(random, least_aside, most_aside);
    const Eigen::Vector3f goal(-std::sin(approach.azimuth) * aside,
                               std::cos(approach.azimuth) * aside,
                               tests::uniform(random, 0.3F, 1.7F));
    threats.push_back(features::threat_from_description(approach, goal, 0));
  }
  return threats;
}

template <class Predict>
void predict_all(benchmark::State& state, const std::vector<features::Threat>& threats,
                 const Predict& predict) {
  std::size_t next = 0;
  double impacts = 0;
  for (auto _ : state) {
    const features::PredictedImpact impact = predict(threats[next++ % threats.size()]);
    impacts += impact.outcome == features::Outcome::impact ? 1 : 0;
  }
  state.counters["impacts"] = impacts / static_cast<double>(state.iterations());
}

const tests::SwayingFigure& figure() {
  static const tests::SwayingFigure figure;
  return figure;
}

features::PredictedImpact of_idle(const features::Threat& threat) {
  return features::predict_impact(threat, figure().collision_figure, figure().idle,
                                  figure().motion_bounds, {});
}

void predict_hits(benchmark::State& state) {
  predict_all(state, threats_passing(-0.05F, 0.05F), of_idle);
}
BENCHMARK(predict_hits);

void predict_hits_on_a_held_pose(benchmark::State& state) {
  predict_all(state, threats_passing(-0.05F, 0.05F), [](const features::Threat& threat) {
    return features::predict_impact(threat, figure().collision_figure, figure().standing);
  });
}
BENCHMARK(predict_hits_on_a_held_pose);

void predict_near_misses(benchmark::State& state) {
  predict_all(state, threats_passing(0.6F, 1.2F), of_idle);
}
BENCHMARK(predict_near_misses);

void predict_misses(benchmark::State& state) {
  predict_all(state, threats_passing(2, 10), of_idle);
}
BENCHMARK(predict_misses);

/// The features of a selector, for one layout.
void feature_vectors(benchmark::State& state, const char* set) {
  const features::Layout& layout = features::feature_set_named(set)->layout;
  const features::IdlingFigure idling{&figure().character.skeleton, &figure().model, figure().idle};
  const std::vector<features::Threat> threats = threats_passing(-0.05F, 0.05F);
  features::Scenario scenario;
  std::size_t next = 0;
  float sum = 0;
  for (auto _ : state) {
    scenario.threat = threats[next++ % threats.size()];
    scenario.state.idle_time_s = 0.01F * static_cast<float>(next % 100);
    sum += features::feature_vector(layout, scenario, idling)[0];
  }
  state.counters["mean_first"] = static_cast<double>(sum) / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(feature_vectors, paper, "paper");
BENCHMARK_CAPTURE(feature_vectors, geometry, "geometry");

void sway_of_the_idle(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        features::motion_bounds_of(figure().character.skeleton, figure().model, figure().idle));
  }
}
BENCHMARK(sway_of_the_idle)->Unit(benchmark::kMicrosecond);

void perceive_as_a_human(benchmark::State& state) {
  const std::vector<features::Threat> threats = threats_passing(-1, 1);
  const runtime::PerceptionLimits limits = runtime::human_limits();
  std::uint64_t number = 0;
  float sum = 0;
  for (auto _ : state) {
    const features::Threat& threat = threats[number % threats.size()];
    sum += runtime::perceive(threat, {0, 0, 1.7F}, limits, 1, number++).threat.velocity.x();
  }
  state.counters["mean_velocity_x_mps"] =
      static_cast<double>(sum) / static_cast<double>(state.iterations());
}
BENCHMARK(perceive_as_a_human);

}  // namespace
}  // namespace flinch
