// SPDX-License-Identifier: MIT
#include "train/evaluate/brawn.h"

#include <array>

#include "database/library/library_file.h"

namespace flinch::train {
namespace {

constexpr std::array kShownBrawns{0.0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0};

std::string kind_of(const database::ClipLibrary& library, int clip) {
  return clip == library.idle ? "idle" : library.clip(clip).kind;
}

}  // namespace

std::vector<BrawnRow> brawn_rows(const TrainTestSplit& split, const CostModel& cost_model) {
  database::ClipLibrary library;
  if (split.tested.empty() || database::read_embedded_library(split.header.library_file, library) !=
                                  database::LoadStatus::ok)
    return {};
  std::map<std::string, double> no_kinds{{"idle", 0}};
  for (const motion::Clip& clip : library.clips)
    if (clip.purpose == motion::Purpose::anticipation) no_kinds[clip.kind] = 0;
  const double share = 1 / static_cast<double>(split.tested.size());
  std::vector<BrawnRow> rows;
  for (const double brawn : kShownBrawns) {
    CostModel model = cost_model;
    model.brawn = brawn;
    BrawnRow row;
    row.brawn = brawn;
    row.kind = no_kinds;
    std::vector<int> clips;
    for (const Observation& observation : split.tested) {
      const std::vector<double> costs =
          costs_of(observation.trials, observation.scenario.threat.kind, model);
      const Trial& chosen = observation.trials[best_trial(observation.trials, costs)];
      row.mean_damage_ns +=
          share *
          damage_ns(chosen.impulse, vulnerability_to(model, observation.scenario.threat.kind));
      row.mean_work_j += share * double{chosen.work_j};
      row.kind[kind_of(library, chosen.clip)] += share;
      clips.push_back(chosen.clip);
    }
    row.use = intended_use(split.header, split.tested, clips);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace flinch::train
