// SPDX-License-Identifier: MIT
#include "program/comparison_table.h"

#include <algorithm>

#include "program/table.h"

namespace flinch::program {

namespace {

using enum Table::Align;

std::string text(const train::Interval& interval, int decimals) {
  return fixed(interval.low, decimals) + " to " + fixed(interval.high, decimals);
}

std::string difference(const train::EvaluationRow& row, const std::string& from) {
  for (const train::Difference& difference : row.differences)
    if (difference.from == from)
      return fixed(difference.cost_ns.value, 4) + " (" + text(difference.cost_ns.interval, 4) + ")";
  return "-";
}

std::string rows_text(const std::vector<train::EvaluationRow>& rows) {
  Table table({{"selector"},
               {"accuracy", right},
               {"top 3", right},
               {"cost, N s", right},
               {"damage, N s", right},
               {"regret, N s", right},
               {"95 %", right},
               {"protection", right},
               {"95 %", right}});
  for (const train::EvaluationRow& row : rows) {
    table.add({row.name, fixed(row.accuracy.value, 3), fixed(row.top_three.value, 3),
               fixed(row.mean_cost_ns.value, 4), fixed(row.mean_damage_ns.value, 4),
               fixed(row.regret_ns.value, 4), text(row.regret_ns.interval, 4),
               fixed(row.protection.value, 3), text(row.protection.interval, 3)});
  }
  return table.text();
}

std::string paired_text(const std::vector<train::EvaluationRow>& rows) {
  Table table({{"mean cost, N s"},
               {"minus mean of svm (95 %)", right},
               {"minus mean of knn (95 %)", right}});
  for (const train::EvaluationRow& row : rows)
    table.add({row.name, difference(row, "svm"), difference(row, "knn")});
  return table.text();
}

std::string timing_text(const train::Report& report) {
  Table table({{"selector"},
               {"median, us", right},
               {"p99, us", right},
               {"fit, s", right},
               {"file, KiB", right},
               {"parameters"}});
  for (std::size_t i = 0; i < report.methods.size(); ++i) {
    const train::RowTiming& timing = report.evaluation.timing[i];
    table.add({timing.name, fixed(timing.median_us, 1), fixed(timing.p99_us, 1),
               fixed(timing.fit_s, 1), fixed(static_cast<double>(timing.file_bytes) / 1024, 0),
               report.methods[i].parameters});
  }
  return table.text();
}

std::string look_ahead_text(const std::vector<train::LookAheadRow>& rows) {
  Table table({{"looking ahead"},
               {"accuracy", right},
               {"cost, N s", right},
               {"damage, N s", right},
               {"regret, N s", right},
               {"protection", right},
               {"95 %", right},
               {"simulated", right},
               {"median, us", right},
               {"p99, us", right}});
  for (const train::LookAheadRow& ahead : rows) {
    const train::EvaluationRow& row = ahead.row;
    table.add({row.name, fixed(row.accuracy.value, 3), fixed(row.mean_cost_ns.value, 4),
               fixed(row.mean_damage_ns.value, 4), fixed(row.regret_ns.value, 4),
               fixed(row.protection.value, 3), text(row.protection.interval, 3),
               fixed(ahead.encounters, 1), fixed(ahead.median_us, 0), fixed(ahead.p99_us, 0)});
  }
  return table.text();
}

/// What the chosen clips are made for.
std::string use_text(const train::Evaluation& evaluation) {
  Table table({{"chosen clips made for"},
               {"a neighbouring target", right},
               {"135 degrees away or more", right},
               {"both", right}});
  const auto add = [&table](const train::EvaluationRow& row) {
    table.add({row.name, fixed(row.use.other_target, 3), fixed(row.use.far_direction, 3),
               fixed(row.use.luck, 3)});
  };
  for (const train::EvaluationRow& row : evaluation.rows) add(row);
  for (const train::LookAheadRow& ahead : evaluation.look_ahead) add(ahead.row);
  return table.text();
}

/// One line per brawn, with the shares of the kinds of clips.
std::string brawn_text(const std::vector<train::BrawnRow>& rows) {
  std::vector<Table::Column> columns{
      {"exhaustive choice, brawn"}, {"damage, N s", right}, {"work, J", right}};
  for (const auto& [kind, share] : rows.front().kind) columns.push_back({kind, right});
  columns.push_back({"other target", right});
  columns.push_back({"135 degrees off", right});
  columns.push_back({"both", right});
  Table table(columns);
  for (const train::BrawnRow& row : rows) {
    std::vector<std::string> cells{fixed(row.brawn, 1), fixed(row.mean_damage_ns, 3),
                                   fixed(row.mean_work_j, 0)};
    for (const auto& [kind, share] : row.kind) cells.push_back(fixed(share, 3));
    for (const double share : {row.use.other_target, row.use.far_direction, row.use.luck})
      cells.push_back(fixed(share, 3));
    table.add(cells);
  }
  return table.text();
}

/// One line per group, with the regret of each row.
std::string groups_text(const train::Report& report) {
  std::vector<Table::Column> columns{{"regret, N s"}, {""}, {"scenarios", right}};
  const std::size_t rows = report.evaluation.rows.size();
  for (std::size_t i = 0; i + 1 < rows; ++i)
    columns.push_back({report.evaluation.rows[i].name, right});
  Table table(columns);
  for (std::size_t first = 0; first < report.groups.size(); first += rows) {
    const train::GroupRow& group = report.groups[first];
    std::vector<std::string> cells{group.group, group.value, std::to_string(group.scenarios)};
    for (std::size_t i = 0; i + 1 < rows; ++i)
      cells.push_back(fixed(report.groups[first + i].regret_ns.value, 3));
    table.add(cells);
  }
  return table.text();
}

/// One line per kind of threat, with the protection of each row.
std::string kinds_text(const std::vector<train::KindRow>& rows) {
  std::vector<Table::Column> columns{
      {"protection"}, {"scenarios", right}, {"idle, N s", right}, {"oracle, N s", right}};
  for (const train::KindRow& row : rows)
    if (row.kind == rows.front().kind) columns.push_back({row.name, right});
  const std::size_t shown = columns.size() - 4;
  Table table(columns);
  for (std::size_t first = 0; first < rows.size(); first += shown) {
    const train::KindRow& kind = rows[first];
    std::vector<std::string> cells{kind.kind, std::to_string(kind.scenarios),
                                   fixed(kind.idle_cost_ns, 2), fixed(kind.oracle_cost_ns, 2)};
    for (std::size_t i = 0; i < shown; ++i) {
      const train::Estimate& protection = rows[first + i].protection;
      cells.push_back(fixed(protection.value, 3) + " (" + text(protection.interval, 2) + ")");
    }
    table.add(cells);
  }
  return table.text();
}

/// Results by method against a parameter: one line per method, one column per value of the
/// parameter.
template <class Row, class Parameter>
std::string sweep_text(const std::string& title, const std::vector<Row>& rows,
                       const Parameter& parameter) {
  std::vector<Table::Column> columns{{title}};
  for (const Row& row : rows)
    if (row.name == rows.front().name) columns.push_back({parameter(row), right});
  Table table(columns);
  for (std::size_t first = 0; first < rows.size(); first += columns.size() - 1) {
    std::vector<std::string> cells{rows[first].name};
    for (std::size_t i = 0; i + 1 < columns.size(); ++i)
      cells.push_back(fixed(rows[first + i].protection, 3));
    table.add(cells);
  }
  return table.text();
}

std::string transfer_text(const std::vector<train::TransferRow>& rows) {
  Table table({{"transfer"},
               {"fitted brawn", right},
               {"evaluated brawn", right},
               {"regret, N s", right},
               {"protection", right}});
  for (const train::TransferRow& row : rows) {
    table.add({row.name, fixed(row.fitted_brawn, 1), fixed(row.judged_brawn, 1),
               fixed(row.regret_ns, 4), fixed(row.protection, 3)});
  }
  return table.text();
}

std::string ablation_text(const std::vector<train::AblationRow>& rows) {
  Table table({{"features"},
               {"count", right},
               {"selector"},
               {"cross-validated, N s", right},
               {"regret, N s", right},
               {"protection", right}});
  for (const train::AblationRow& row : rows) {
    table.add({row.features, std::to_string(row.feature_count), row.name,
               fixed(row.cross_validated_regret_ns, 4), fixed(row.regret_ns, 4),
               fixed(row.protection, 3)});
  }
  return table.text();
}

std::string prevention_text(const std::vector<train::PreventionRow>& rows) {
  Table table({{"exhaustive choice"},
               {""},
               {"scenarios", right},
               {"idle, N s", right},
               {"choice, N s", right},
               {"prevented", right}});
  for (const train::PreventionRow& row : rows) {
    table.add({row.group, row.value, std::to_string(row.scenarios), fixed(row.idle_cost_ns, 3),
               fixed(row.oracle_cost_ns, 3), fixed(row.prevented(), 3)});
  }
  return "\nShare of the cost of staying idle that the library can prevent, over all scenarios of "
         "the "
         "store; by target and\ndirection (degrees) for those with at least " +
         fixed(double{train::kMinAnswerTime_s}, 1) + " s to impact:\n\n" + table.text();
}

}  // namespace

std::string comparison_text(const train::Report& report) {
  std::string text = std::string(report.has_test_store ? "tested on " : "held out: ") +
                     std::to_string(report.tested_count) +
                     " scenarios; fitted to: " + std::to_string(report.fitted_count) + "; brawn " +
                     fixed(report.evaluation.cost_model.brawn, 2) + "; " +
                     std::to_string(report.features.size()) + " features\n\n";
  text += rows_text(report.evaluation.rows) + '\n' + paired_text(report.evaluation.rows) + '\n' +
          timing_text(report) + '\n';
  if (!report.evaluation.look_ahead.empty())
    text += look_ahead_text(report.evaluation.look_ahead) + '\n';
  text += use_text(report.evaluation) + '\n';
  if (!report.brawn.empty()) text += brawn_text(report.brawn) + '\n';
  text += groups_text(report) + '\n';
  if (!report.kinds.empty()) text += kinds_text(report.kinds) + '\n';
  if (!report.noise.empty())
    text += sweep_text("protection with noise on the features", report.noise,
                       [](const train::NoiseRow& row) { return fixed(row.noise, 2); });
  if (!report.curves.empty())
    text += '\n' + sweep_text("protection by number of training scenarios", report.curves,
                              [](const train::LearningCurveRow& row) {
                                return std::to_string(row.fitted_count);
                              });
  if (!report.transfer.empty()) text += '\n' + transfer_text(report.transfer);
  if (!report.ablation.empty()) text += '\n' + ablation_text(report.ablation);
  return text + prevention_text(report.prevention);
}

}  // namespace flinch::program
