// SPDX-License-Identifier: MIT
#include "train/report.h"

#include <filesystem>

#include "database/file_io.h"
#include "motion/error.h"
#include "train/export.h"

namespace flinch::train {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Interval& interval) {
  return Json::array({interval.low, interval.high});
}

Json cost_model_document(const CostModel& model) {
  Json vulnerability;
  for (const motion::Body body : motion::kBodies)
    vulnerability[std::string(name_of(body))] = model.vulnerability[body];
  return {{"brawn", model.brawn},
          {"reference_damage_ns", model.reference_damage_ns},
          {"reference_work_j", model.reference_work_j},
          {"vulnerability", vulnerability}};
}

Json prevention_document(const std::vector<PreventionRow>& rows) {
  Json list = Json::array();
  for (const PreventionRow& row : rows) {
    list.push_back({{"group", row.group},
                    {"value", row.value},
                    {"scenarios", row.scenarios},
                    {"idle_cost_ns", row.idle_cost_ns},
                    {"oracle_cost_ns", row.oracle_cost_ns},
                    {"prevented", row.prevented()}});
  }
  return list;
}

}  // namespace

Json report_document(const Evaluation& evaluation, const StoreHeader& header) {
  Json rows = Json::array();
  for (const EvaluationRow& row : evaluation.rows) {
    rows.push_back({{"name", row.name},
                    {"accuracy", row.accuracy},
                    {"mean_cost", row.mean_cost_ns},
                    {"regret", row.regret_ns},
                    {"protection", row.protection},
                    {"protection_ci", to_json(row.protection_interval)}});
  }
  return {{"library", header.library_name},
          {"library_hash", database::hash_text(header.library_hash)},
          {"seed", header.seed},
          {"scenarios_fitted", evaluation.fitted_count},
          {"scenarios_held_out", evaluation.observations.size()},
          {"cost_model", cost_model_document(evaluation.cost_model)},
          {"rows", rows},
          {"paired",
           {{"names", {"svm", "knn"}},
            {"difference", evaluation.svm_minus_knn_ns},
            {"ci", to_json(evaluation.svm_minus_knn_interval)}}},
          {"prevention", prevention_document(evaluation.prevention)}};
}

std::string scenarios_csv(const Evaluation& evaluation) {
  std::string text = "number,target,label";
  for (const EvaluationRow& row : evaluation.rows)
    text += ',' + row.name + "_clip," + row.name + "_cost_ns";
  text += '\n';
  for (std::size_t i = 0; i < evaluation.observations.size(); ++i) {
    const Observation& observation = evaluation.observations[i];
    text += std::to_string(observation.number) + ',' +
            std::string(motion::name_of(observation.scenario.target)) + ',' +
            std::to_string(evaluation.label[i]);
    for (const EvaluationRow& row : evaluation.rows)
      text += ',' + std::to_string(row.chosen[i]) + ',' + exact(row.cost_ns[i]);
    text += '\n';
  }
  return text;
}

void write_report(const Evaluation& evaluation, const StoreHeader& header,
                  const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(folder, "cannot make the folder: " + error.message());
  const std::filesystem::path path(folder);
  database::write_file_atomically((path / "report.json").string(),
                                  report_document(evaluation, header).dump(2) + '\n');
  database::write_file_atomically((path / "scenarios.csv").string(), scenarios_csv(evaluation));
}

}  // namespace flinch::train
