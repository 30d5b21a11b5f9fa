// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "database/authored_library.h"
#include "database/stance.h"
#include "database/static_balance.h"
#include "motion/default_character.h"

namespace flinch::database {
namespace {

void author_library(benchmark::State& state) {
  std::size_t clips = 0;
  for (auto unused : state) {
    (void)unused;
    clips = authored_library(motion::default_character()).clips.size();
  }
  state.counters["clips"] = static_cast<double>(clips);
}
BENCHMARK(author_library)->Unit(benchmark::kMillisecond);

void balance_pose(benchmark::State& state) {
  const Figure figure = make_figure(motion::default_character());
  const motion::Pose start = standing_pose(figure);
  const motion::JointFrames frames = motion::forward_kinematics(figure.skeleton(), start);
  Danger danger;
  danger.target_point = motion::target_centre(figure.bodies, frames, motion::Target::head);
  danger.position = danger.target_point + Eigen::Vector3f(4, 2, 1);
  danger.speed_mps = 25;
  float error = 0;
  for (auto unused : state) {
    (void)unused;
    error = balanced_pose(figure, start, danger, rule_controls(danger)).error.total();
  }
  state.counters["error"] = double{error};  // that what is timed is right
}
BENCHMARK(balance_pose)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flinch::database
