// SPDX-License-Identifier: MIT
#include "train/evaluate/confusions.h"

#include <map>
#include <utility>

namespace flinch::train {
namespace {

struct Cell {
  std::size_t scenarios = 0;
  double regret_ns = 0;  ///< sum
};

bool looks_at_threat(const EvaluationRow& row) {
  return row.name != "idle" && row.name != "random" && row.name != "rules" && row.name != "oracle";
}

}  // namespace

std::vector<ConfusionRow> confusion_rows(const TrainTestSplit& split,
                                         const Evaluation& evaluation) {
  const auto name_of_clip = [&split](int clip) {
    return split.header.clips[static_cast<std::size_t>(clip)].name;
  };
  const std::vector<double>& oracle = evaluation.rows.back().cost_ns;
  std::vector<ConfusionRow> rows;
  for (const EvaluationRow& row : evaluation.rows) {
    if (!looks_at_threat(row)) continue;
    std::map<std::pair<int, int>, Cell> cells;  // by label and choice
    for (std::size_t i = 0; i < row.chosen.size(); ++i) {
      Cell& cell = cells[{evaluation.labels.clip[i], row.chosen[i]}];
      ++cell.scenarios;
      cell.regret_ns += row.cost_ns[i] - oracle[i];
    }
    for (const auto& [clips, cell] : cells) {
      rows.push_back({row.name, name_of_clip(clips.first), name_of_clip(clips.second),
                      cell.scenarios, cell.regret_ns / static_cast<double>(cell.scenarios)});
    }
  }
  return rows;
}

}  // namespace flinch::train
