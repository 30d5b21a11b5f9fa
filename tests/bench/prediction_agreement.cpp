// SPDX-License-Identifier: MIT
// Agreement of the predicted impact with the trainer's aim: the tables of docs/perception.md.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "database/files/library_writer.h"
#include "features/impact_prediction.h"
#include "runtime/perception.h"
#include "tests/bench/measures.h"
#include "tests/bench/study.h"
#include "train/scenario/scenario_sampling.h"

namespace flinch {
namespace {

using features::Outcome;
using features::PredictedImpact;

struct Row {
  int misses = 0;
  motion::PerTarget<int> aimed_at{};
  motion::PerTarget<int> struck{};
};

struct Agreement {
  motion::PerTarget<Row> row;
  std::vector<double> error_ms;  ///< of the time to impact
  std::vector<double> lead_ms;   ///< time by which the touch precedes the trainer's time
};

/// Perceives every threat within `limits` from between the eyes.
Agreement agreement_of(const database::ClipLibrary& library,
                       const runtime::PerceptionLimits& limits, std::uint64_t count,
                       std::uint64_t seed) {
  const motion::BodyModel model = make_body_model(library.character);
  const motion::Skeleton& skeleton = library.character.skeleton;
  const motion::Motion& idle = library.idle_clip().motion;
  const features::CollisionFigure figure = features::make_collision_figure(skeleton, model);
  const features::MotionBounds motion_bounds = features::motion_bounds_of(skeleton, model, idle);
  Agreement agreement;
  for (std::uint64_t number = 0; number < count; ++number) {
    const auto scenario = train::sample_scenario(library, model, {}, seed, number);
    const motion::JointFrames frames =
        forward_kinematics(skeleton, features::idle_pose(idle, scenario.state, 0));
    const Eigen::Vector3f eye = target_centre(model, frames, motion::Target::head);
    const runtime::Perceived perceived =
        runtime::perceive(scenario.threat, eye, limits, seed, number);
    const PredictedImpact impact =
        features::predict_impact(perceived.threat, figure, idle, motion_bounds, scenario.state);
    Row& row = agreement.row[scenario.target];
    if (impact.outcome != Outcome::impact) {
      ++row.misses;
      continue;
    }
    ++row.aimed_at[impact.aimed_at];
    ++row.struck[impact.struck];
    const double time_ms = 1000 * static_cast<double>(scenario.time_to_impact_s);
    agreement.error_ms.push_back(
        std::abs(1000 * static_cast<double>(impact.time_to_impact_s) - time_ms));
    agreement.lead_ms.push_back(time_ms - 1000 * static_cast<double>(impact.touch_s));
  }
  return agreement;
}

void print(const char* name, const std::vector<double>& values) {
  if (values.empty()) return;
  std::printf("| %s | %.1f | %.1f | %.1f |\n", name, bench::quantile(values, 0.5),
              bench::quantile(values, 0.99), bench::quantile(values, 1));
}

void print(const Agreement& agreement, std::uint64_t count) {
  std::printf(
      "| trainer aims at | `aimed_at` agrees | `struck` agrees | struck: head, trunk, pelvis, "
      "legs | missed |\n| --- | ---: | ---: | --- | ---: |\n");
  int aimed = 0;
  int struck = 0;
  for (const motion::Target target : motion::kTargets) {
    const Row& row = agreement.row[target];
    const int hits = sum(row.struck);
    const double percent = 100.0 / std::max(hits, 1);
    std::printf("| %s | %.2f %% | %.1f %% | %d, %d, %d, %d | %d |\n",
                std::string(name_of(target)).c_str(), row.aimed_at[target] * percent,
                row.struck[target] * percent, row.struck[motion::Target::head],
                row.struck[motion::Target::trunk], row.struck[motion::Target::pelvis],
                row.struck[motion::Target::legs], row.misses);
    aimed += row.aimed_at[target];
    struck += row.struck[target];
  }
  std::printf("\nOf %llu scenarios, `aimed_at` agrees in %d and `struck` in %d.\n\n",
              static_cast<unsigned long long>(count), aimed, struck);
  std::printf("| ms | median | 99 %% | most |\n| --- | ---: | ---: | ---: |\n");
  print("`time_to_impact_s`, off the trainer's by", agreement.error_ms);
  print("`touch_s`, before the trainer's by", agreement.lead_ms);
}

void run(const bench::StudyArguments& arguments) {
  const database::ClipLibrary library = database::load_library(arguments.text(0));
  const auto count = arguments.number_or<std::uint64_t>(1, 20000);
  const auto seed = arguments.number_or<std::uint64_t>(2, 1);
  print(agreement_of(library, {}, count, seed), count);
  std::printf("\nAs a human perceives them:\n\n");
  print(agreement_of(library, runtime::human_limits(), count, seed), count);
}

}  // namespace
}  // namespace flinch

int main(int count, char** arguments) {
  return flinch::bench::study_main(
      count, arguments, {"prediction_agreement LIBRARY [SCENARIOS [SEED]]", 1, 3}, flinch::run);
}
