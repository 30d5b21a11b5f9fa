// SPDX-License-Identifier: MIT
#include "train/evaluate/groups.h"

#include <functional>

#include "train/evaluate/bins.h"

namespace flinch::train {
namespace {

struct ScenarioGroup {
  std::string group;
  std::string value;
  std::function<bool(const features::Scenario&)> has;
};

constexpr Bin kSpeedBins[] = {{"less than 14", 0, 14},
                              {"14 to 19", 14, 19},
                              {"19 to 24", 19, 24},
                              {"24 or more", 24, kUnbounded}};

float speed_at_impact(const features::Scenario& scenario) {
  return features::velocity_at(scenario.threat, scenario.time_to_impact_s).norm();
}

std::vector<ScenarioGroup> all_groups(const StoreHeader& header) {
  std::vector<ScenarioGroup> groups;
  for (std::size_t i = 0; header.kinds.size() > 1 && i < header.kinds.size(); ++i) {
    groups.push_back({"kind", header.kinds[i].name, [i](const auto& scenario) {
                        return scenario.threat.kind == static_cast<int>(i);
                      }});
  }
  for (std::size_t i = 0; i < header.stances.size(); ++i) {
    groups.push_back({"stance", header.stances[i], [i](const auto& scenario) {
                        return scenario.state.stance == static_cast<int>(i);
                      }});
  }
  for (const motion::Target target : motion::kTargets) {
    groups.push_back({"target", std::string(motion::name_of(target)),
                      [target](const auto& scenario) { return scenario.target == target; }});
  }
  for (const Bin& bin : kSpeedBins) {
    groups.push_back({"speed_mps", bin.name, [bin](const auto& scenario) {
                        return bin.holds(speed_at_impact(scenario));
                      }});
  }
  for (const Bin& bin : kTimeBins) {
    groups.push_back({"time_to_impact_s", bin.name, [bin](const auto& scenario) {
                        return bin.holds(scenario.time_to_impact_s);
                      }});
  }
  return groups;
}

std::vector<double> chosen_from(const std::vector<double>& values,
                                const std::vector<std::size_t>& members) {
  std::vector<double> chosen;
  for (const std::size_t member : members) chosen.push_back(values[member]);
  return chosen;
}

void add_rows(const ScenarioGroup& group, const std::vector<std::size_t>& members,
              const Evaluation& evaluation, std::uint64_t seed, std::vector<GroupRow>& rows) {
  const Resamples resamples = draw_resamples(members.size(), kResampleCount, seed);
  std::vector<ResampledMean> cost;
  for (const EvaluationRow& row : evaluation.rows)
    cost.push_back(resampled_mean(chosen_from(row.cost_ns, members), resamples));
  const auto itself = [](double mean) { return mean; };
  for (std::size_t i = 0; i < cost.size(); ++i) {
    rows.push_back({group.group, group.value, members.size(), evaluation.rows[i].name,
                    estimate(itself, cost[i]), estimate(std::minus{}, cost[i], cost.back()),
                    estimate(protection_of, cost.front(), cost[i], cost.back())});
  }
}

}  // namespace

std::vector<KindRow> kind_rows(const TrainTestSplit& split, const Evaluation& evaluation,
                               std::uint64_t seed) {
  std::vector<const EvaluationRow*> shown;
  for (const RowTiming& method : evaluation.timing) {
    shown.push_back(row_named(evaluation, method.name));
    for (const LookAheadRow& ahead : evaluation.look_ahead)
      if (ahead.row.name.starts_with(method.name + '+')) shown.push_back(&ahead.row);
  }
  std::vector<KindRow> rows;
  const std::vector<features::KnownKind>& kinds = split.header.kinds;
  for (std::size_t kind = 0; kinds.size() > 1 && kind < kinds.size(); ++kind) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < split.tested.size(); ++i)
      if (split.tested[i].scenario.threat.kind == static_cast<int>(kind)) members.push_back(i);
    if (members.empty()) continue;
    const Resamples resamples = draw_resamples(members.size(), kResampleCount, seed);
    const auto mean_of = [&](const EvaluationRow& row) {
      return resampled_mean(chosen_from(row.cost_ns, members), resamples);
    };
    const ResampledMean idle = mean_of(evaluation.rows.front());
    const ResampledMean oracle = mean_of(evaluation.rows.back());
    for (const EvaluationRow* row : shown)
      rows.push_back({kinds[kind].name, members.size(), idle.mean, oracle.mean, row->name,
                      estimate(protection_of, idle, mean_of(*row), oracle)});
  }
  return rows;
}

std::vector<GroupRow> group_rows(const TrainTestSplit& split, const Evaluation& evaluation,
                                 std::uint64_t seed) {
  std::vector<GroupRow> rows;
  for (const ScenarioGroup& group : all_groups(split.header)) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < split.tested.size(); ++i)
      if (group.has(split.tested[i].scenario)) members.push_back(i);
    if (!members.empty()) add_rows(group, members, evaluation, seed, rows);
  }
  return rows;
}

}  // namespace flinch::train
