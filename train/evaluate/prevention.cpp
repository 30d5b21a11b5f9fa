// SPDX-License-Identifier: MIT
#include "train/evaluate/prevention.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "train/evaluate/bins.h"

namespace flinch::train {

namespace {

using ObservationFilter = std::function<bool(const Observation&)>;

/// Directions as in annotations: eight sectors about the facing, in (-180, 180] degrees.
int sector_of(const Observation& observation) {
  const double turns = double{azimuth_of(observation.scenario)} / (2 * std::numbers::pi);
  const int sector = static_cast<int>(std::lround(8 * turns));
  return sector == -4 ? 4 : sector;
}

bool has_time_to_answer(const Observation& observation) {
  return observation.scenario.time_to_impact_s >= kMinAnswerTime_s;
}

void add_row(const Store& store, const Labels& labels, const std::string& group,
             const std::string& value, const ObservationFilter& is_in,
             std::vector<PreventionRow>& rows) {
  PreventionRow row{group, value};
  for (std::size_t i = 0; i < store.observations.size(); ++i) {
    if (!is_in(store.observations[i])) continue;
    ++row.scenarios;
    row.idle_cost_ns += cost_of_choice(store.observations, labels, i, store.header.idle);
    row.oracle_cost_ns += cost_of_choice(store.observations, labels, i, labels.clip[i]);
  }
  if (row.scenarios == 0) return;
  row.idle_cost_ns /= static_cast<double>(row.scenarios);
  row.oracle_cost_ns /= static_cast<double>(row.scenarios);
  rows.push_back(row);
}

}  // namespace

std::vector<PreventionRow> prevention_rows(const Store& store, const Labels& labels) {
  std::vector<PreventionRow> rows;
  const auto add = [&](const char* group, const std::string& value,
                       const ObservationFilter& is_in) {
    add_row(store, labels, group, value, is_in, rows);
  };
  add("all", "0.50 s or more", has_time_to_answer);
  for (const motion::Target target : {motion::Target::head, motion::Target::trunk,
                                      motion::Target::pelvis, motion::Target::legs}) {
    add("target", std::string(motion::name_of(target)), [target](const Observation& observation) {
      return has_time_to_answer(observation) && observation.scenario.target == target;
    });
  }
  for (int sector = -3; sector <= 4; ++sector) {
    add("direction", std::to_string(45 * sector), [sector](const Observation& observation) {
      return has_time_to_answer(observation) && sector_of(observation) == sector;
    });
  }
  for (const Bin& bin : kTimeBins) {
    add("time_to_impact", bin.name, [bin](const Observation& observation) {
      return bin.holds(observation.scenario.time_to_impact_s);
    });
  }
  return rows;
}

}  // namespace flinch::train
