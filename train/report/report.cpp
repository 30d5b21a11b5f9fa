// SPDX-License-Identifier: MIT
#include "train/report/report.h"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "database/files/file_io.h"
#include "motion/error.h"
#include "train/report/csv.h"

namespace flinch::train {

namespace {

using Json = nlohmann::ordered_json;

void put(Json& document, const std::string& key, const Estimate& estimate) {
  document[key] = estimate.value;
  document[key + "_ci"] = Json::array({estimate.interval.low, estimate.interval.high});
}

void put(Json& document, const IntendedUse& use) {
  document["other_target"] = use.other_target;
  document["far_direction"] = use.far_direction;
  document["luck"] = use.luck;
}

Json document_of(const Vulnerability& vulnerability) {
  Json document;
  for (const motion::Body body : motion::kBodies)
    document[std::string(name_of(body))] = vulnerability[body];
  return document;
}

Json cost_model_document(const CostModel& model) {
  Json document{{"brawn", model.brawn},
                {"reference_damage_ns", model.reference_damage_ns},
                {"reference_work_j", model.reference_work_j},
                {"vulnerability_name", model.vulnerability_name},
                {"vulnerability", document_of(model.vulnerability)}};
  for (const features::KindVulnerability& own : model.of_kind)
    document["vulnerability_to"].push_back(
        {{"kind", own.kind}, {"bodies", document_of(own.vulnerability)}});
  return document;
}

/// One object per element; an empty array if there are none.
template <class Element, class ToDocument>
Json list(const std::vector<Element>& elements, const ToDocument& to_document) {
  Json documents = Json::array();
  for (const Element& element : elements) documents.push_back(to_document(element));
  return documents;
}

Json document_of(const EvaluationRow& row) {
  Json document{{"name", row.name}};
  put(document, "accuracy", row.accuracy);
  put(document, "top_three", row.top_three);
  put(document, "mean_cost", row.mean_cost_ns);
  put(document, "mean_damage", row.mean_damage_ns);
  put(document, "regret", row.regret_ns);
  put(document, "protection", row.protection);
  put(document, row.use);
  for (const Difference& difference : row.differences)
    put(document, "minus_" + difference.from, difference.cost_ns);
  return document;
}

Json document_of(const LookAheadRow& ahead) {
  Json document = document_of(ahead.row);
  document["candidates"] = ahead.candidates;
  document["encounters"] = ahead.encounters;
  return document;
}

Json document_of(const BrawnRow& row) {
  Json document{
      {"brawn", row.brawn}, {"mean_damage", row.mean_damage_ns}, {"mean_work", row.mean_work_j}};
  for (const auto& [kind, share] : row.kind) document[kind] = share;
  put(document, row.use);
  return document;
}

Json document_of(const KindRow& row) {
  Json document{{"kind", row.kind},
                {"scenarios", row.scenarios},
                {"idle_cost_ns", row.idle_cost_ns},
                {"oracle_cost_ns", row.oracle_cost_ns},
                {"name", row.name}};
  put(document, "protection", row.protection);
  return document;
}

Json document_of(const GroupRow& row) {
  Json document{
      {"group", row.group}, {"value", row.value}, {"scenarios", row.scenarios}, {"name", row.name}};
  put(document, "mean_cost", row.mean_cost_ns);
  put(document, "regret", row.regret_ns);
  put(document, "protection", row.protection);
  return document;
}

Json document_of(const DirectionRow& row) {
  return {{"target", row.target},          {"azimuth_degrees", row.azimuth_degrees},
          {"scenarios", row.scenarios},    {"name", row.name},
          {"mean_cost", row.mean_cost_ns}, {"regret", row.regret_ns},
          {"protection", row.protection}};
}

Json document_of(const ConfusionRow& row) {
  return {{"name", row.name},
          {"label", row.label},
          {"chosen", row.chosen},
          {"scenarios", row.scenarios},
          {"mean_regret", row.mean_regret_ns}};
}

Json document_of(const ReliabilityBin& bin) {
  return {{"name", bin.name},
          {"said", bin.said},
          {"mean_said", bin.mean_said},
          {"scenarios", bin.scenarios},
          {"accuracy", bin.accuracy},
          {"mean_cost", bin.mean_cost_ns},
          {"mean_regret", bin.mean_regret_ns}};
}

Json document_of(const NoiseRow& row) {
  return {{"name", row.name},
          {"noise", row.noise},
          {"regret", row.regret_ns},
          {"protection", row.protection}};
}

Json document_of(const LearningCurveRow& row) {
  return {{"name", row.name},
          {"scenarios_fitted", row.fitted_count},
          {"regret", row.regret_ns},
          {"protection", row.protection}};
}

Json document_of(const TransferRow& row) {
  return {{"name", row.name},
          {"fitted_brawn", row.fitted_brawn},
          {"judged_brawn", row.judged_brawn},
          {"regret", row.regret_ns},
          {"protection", row.protection}};
}

Json document_of(const AblationRow& row) {
  return {{"name", row.name},
          {"features", row.features},
          {"feature_count", row.feature_count},
          {"cross_validated_regret", row.cross_validated_regret_ns},
          {"regret", row.regret_ns},
          {"protection", row.protection}};
}

Json document_of(const PreventionRow& row) {
  return {{"group", row.group},
          {"value", row.value},
          {"scenarios", row.scenarios},
          {"idle_cost_ns", row.idle_cost_ns},
          {"oracle_cost_ns", row.oracle_cost_ns},
          {"prevented", row.prevented()}};
}

Json document_of(const MethodSummary& method) {
  return {{"name", method.name},
          {"parameters", parameters_document(method.parameter_values)},
          {"cross_validated_regret", method.cross_validated_regret_ns}};
}

Json document_of(const RowTiming& timing) {
  return {{"name", timing.name},
          {"median_us", timing.median_us},
          {"p99_us", timing.p99_us},
          {"fit_s", timing.fit_s}};
}

Json document_of(const ReportOptions& options) {
  return {{"feature_set", options.feature_set},
          {"curves", options.curves},
          {"transfer", options.transfer},
          {"ablation", options.ablation}};
}

Json store_document(const StoreOrigin& origin, std::size_t scenarios) {
  return {{"seed", origin.seed},
          {"scenarios", scenarios},
          {"distribution", Json::parse(origin.distribution)},
          {"simulation", Json::parse(origin.simulation)}};
}

/// The difference of SVM and KNN; nothing if one of them is not a row.
Json paired_document(const Evaluation& evaluation) {
  const EvaluationRow* svm = row_named(evaluation, "svm");
  if (svm == nullptr || svm->differences.empty()) return nullptr;
  Json document{{"names", {"svm", "knn"}}};
  const Estimate& difference = svm->differences.front().cost_ns;
  document["difference"] = difference.value;
  document["ci"] = Json::array({difference.interval.low, difference.interval.high});
  return document;
}

/// Parts of the document that are also written as files.
constexpr std::array kCharts{"look_ahead",  "groups", "directions", "confusions",
                             "reliability", "noise",  "curves",     "transfer",
                             "ablation",    "brawn",  "prevention"};

std::string cell(const Json& value) {
  if (value.is_number_float()) return exact_text(value.get<double>());
  if (value.is_string()) return csv_cell(value.get<std::string>());
  return value.is_null() ? "" : value.dump();
}

/// Converts flat objects with the same keys to comma-separated values; a `…_ci` becomes two
/// columns.
std::string csv_of(const Json& objects) {
  std::string text;
  for (const auto& [key, value] : objects.front().items()) {
    const std::string separator = text.empty() ? "" : ",";
    text += value.is_array() ? separator + key + "_low," + key + "_high" : separator + key;
  }
  text += '\n';
  for (const Json& object : objects) {
    std::string line;
    for (const auto& [key, value] : object.items()) {
      if (!line.empty()) line += ',';
      line += value.is_array() ? cell(value[0]) + ',' + cell(value[1]) : cell(value);
    }
    text += line + '\n';
  }
  return text;
}

}  // namespace

Json report_document(const Report& report) {
  const auto to_document = [](const auto& element) { return document_of(element); };
  Json sizes = Json::array();
  for (const RowTiming& row : report.evaluation.timing)
    sizes.push_back({{"name", row.name}, {"file_bytes", row.file_bytes}});
  return {{"version", report.version},
          {"provenance", Json::parse(report.provenance)},
          {"library", report.library},
          {"library_hash", database::hash_text(report.library_hash)},
          {"seed", report.seed},
          {"scenarios_fitted", report.fitted_count},
          {"scenarios_tested", report.tested_count},
          {"test_store", report.has_test_store},
          {"options", document_of(report.options)},
          {"stores",
           {{"fitted", store_document(report.fitted_store, report.fitted_count)},
            {"tested", store_document(report.tested_store, report.tested_count)}}},
          {"features", report.features},
          {"clips", report.clips},
          {"cost_model", cost_model_document(report.evaluation.cost_model)},
          {"rows", list(report.evaluation.rows, to_document)},
          {"look_ahead", list(report.evaluation.look_ahead, to_document)},
          {"paired", paired_document(report.evaluation)},
          {"kinds", list(report.kinds, to_document)},
          {"methods", list(report.methods, to_document)},
          {"sizes", sizes},
          {"groups", list(report.groups, to_document)},
          {"directions", list(report.directions, to_document)},
          {"confusions", list(report.confusions, to_document)},
          {"reliability", list(report.reliability, to_document)},
          {"noise", list(report.noise, to_document)},
          {"curves", list(report.curves, to_document)},
          {"transfer", list(report.transfer, to_document)},
          {"ablation", list(report.ablation, to_document)},
          {"brawn", list(report.brawn, to_document)},
          {"prevention", list(report.prevention, to_document)}};
}

Json parameters_document(std::span<const NamedValue> parameters) {
  Json document = Json::object();
  for (const NamedValue& parameter : parameters)
    std::visit([&](const auto& value) { document[parameter.name] = value; }, parameter.value);
  return document;
}

Json timing_document(const Evaluation& evaluation) {
  std::vector<RowTiming> timing = evaluation.timing;
  for (const LookAheadRow& ahead : evaluation.look_ahead)
    timing.push_back({ahead.row.name, ahead.median_us, ahead.p99_us, 0, 0});
  return list(timing, [](const RowTiming& row) { return document_of(row); });
}

std::string scenarios_csv(const TrainTestSplit& split, const Evaluation& evaluation) {
  std::string text = "number,target,label";
  for (const EvaluationRow& row : evaluation.rows)
    text += ',' + row.name + "_clip," + row.name + "_cost_ns";
  text += '\n';
  for (std::size_t i = 0; i < split.tested.size(); ++i) {
    const Observation& observation = split.tested[i];
    text += std::to_string(observation.number) + ',' +
            std::string(motion::name_of(observation.scenario.target)) + ',' +
            std::to_string(evaluation.labels.clip[i]);
    for (const EvaluationRow& row : evaluation.rows)
      text += ',' + std::to_string(row.chosen[i]) + ',' + exact_text(row.cost_ns[i]);
    text += '\n';
  }
  return text;
}

std::vector<std::string> report_file_names() {
  std::vector<std::string> names{"report.json", "timing.json", "scenarios.csv"};
  for (const char* chart : kCharts) names.push_back(std::string(chart) + ".csv");
  return names;
}

void write_report(const Report& report, const TrainTestSplit& split, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(folder, "cannot create the folder: " + error.message());
  const auto write = [&](const std::string& name, const std::string& text) {
    database::write_file_atomically((std::filesystem::path(folder) / name).string(), text);
  };
  const Json document = report_document(report);
  write("report.json", document.dump(2) + '\n');
  write("timing.json", timing_document(report.evaluation).dump(2) + '\n');
  write("scenarios.csv", scenarios_csv(split, report.evaluation));
  for (const char* chart : kCharts)
    if (!document[chart].empty()) write(std::string(chart) + ".csv", csv_of(document[chart]));
}

}  // namespace flinch::train
