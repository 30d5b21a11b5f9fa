// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "database/author/authored_library.h"
#include "database/author/stance.h"
#include "database/author/static_balance.h"
#include "motion/default_character.h"
#include "motion/rotation.h"

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

// The mean over three targets and eight directions.
void balance_pose(benchmark::State& state) {
  const motion::Figure figure = motion::make_figure(motion::default_character());
  const motion::Pose start = standing_pose(figure);
  const motion::JointFrames frames = motion::forward_kinematics(figure.skeleton(), start);
  std::vector<AimedThreat> dangers;
  for (const motion::Target target :
       {motion::Target::head, motion::Target::trunk, motion::Target::pelvis}) {
    for (int sector = 0; sector < 8; ++sector) {
      const float azimuth = motion::radians(45) * static_cast<float>(sector);
      AimedThreat threat;
      threat.target_point = motion::target_centre(figure.bodies, frames, target);
      const Eigen::Vector3f from(4 * std::cos(azimuth), 4 * std::sin(azimuth), 1);
      threat.threat.position = threat.target_point + from;
      threat.threat.velocity = -25 * from.normalized();
      dangers.push_back(threat);
    }
  }
  float worst = 0;
  std::size_t next = 0;
  for (auto unused : state) {
    (void)unused;
    const AimedThreat& threat = dangers[next++ % dangers.size()];
    const BalancedPose pose = balanced_pose(figure, start, threat, rule_controls(threat));
    worst = std::max(worst, pose.error.total());
  }
  state.counters["worst_error"] = double{worst};  // shows that the timed poses are right
}
BENCHMARK(balance_pose)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flinch::database
