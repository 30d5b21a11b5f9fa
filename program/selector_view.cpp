// SPDX-License-Identifier: MIT
#include "program/selector_view.h"

#include <cmath>
#include <iostream>
#include <span>

#include "database/files/file_io.h"
#include "program/printable.h"
#include "program/provenance_view.h"
#include "program/table.h"
#include "train/fit/selector_reader.h"
#include "train/objective/vulnerability.h"

namespace flinch::program {
namespace {

std::size_t pose_count(const database::ClipLibrary& library) {
  std::size_t count = 0;
  for (const motion::Clip& clip : library.clips) count += clip.motion.poses.size();
  return count;
}

Json model_document(const models::SvmModel& svm) {
  return {{"model", svm.kernel == models::SvmKernel::rbf ? "svm_rbf" : "svm"},
          {"classes", svm.class_count()},
          {"support_vectors", svm.vector_count()}};
}

Json model_document(const models::KnnModel& knn) {
  return {{"model", knn.vote == models::KnnVote::cost ? "knn_cost" : "knn"},
          {"k", knn.k},
          {"observations", knn.label.size()}};
}

Json model_document(const models::NetworkModel& network) {
  return {{"model", "network"},
          {"members", network.member_count},
          {"hidden", network.hidden_count},
          {"classes", network.clip.size()}};
}

Json model_document(const models::PairwiseModel& pairwise) {
  return {{"model", "pairwise_cost"},
          {"classes", pairwise.clip.size()},
          {"machines", pairwise.weights.size() / pairwise.row_size()}};
}

/// The name of a selector's vulnerability table. Files written before it was stored have none.
std::string vulnerability_name(const models::ResponseCosts& costs) {
  if (!costs.vulnerability_name.empty()) return costs.vulnerability_name;
  const std::string_view shipped = train::shipped_name_of(costs.vulnerability);
  return shipped.empty() ? "unnamed" : std::string(shipped);
}

Json vulnerability_document(const motion::PerBody<double>& vulnerability) {
  Json document;
  for (const motion::Body body : motion::kBodies)
    document[std::string(name_of(body))] = vulnerability[body];
  return document;
}

Json kinds_document(std::span<const features::KnownKind> kinds) {
  const auto range = [](const features::ValueRange& of) { return Json::array({of.min, of.max}); };
  Json list = Json::array();
  for (const features::KnownKind& kind : kinds) {
    list.push_back({{"name", kind.name},
                    {"radius_m", range(kind.radius_m)},
                    {"mass_kg", range(kind.mass_kg)},
                    {"speed_mps", range(kind.speed_mps)},
                    {"elevation_degrees",
                     {rounded_degrees(kind.elevation.min), rounded_degrees(kind.elevation.max)}},
                    {"time_to_impact_s", range(kind.time_to_impact_s)},
                    {"restitution", kind.bounce.restitution},
                    {"friction", kind.bounce.friction},
                    {"flight", kind.falls ? "falling" : "straight"},
                    {"shape", name_of(kind.shape)}});
    if (kind.is_driven()) list.back()["reach_m"] = range(kind.reach_m);
    if (kind.shape == features::ThreatShape::rod)
      list.back()["length_m"] = range(kind.rod.length_m);
  }
  return list;
}

/// What a selector was trained on, and how well.
Json training_document(const train::SelectorRecord& record, const std::string& path) {
  const std::optional<double> protection = record.cross_validated_protection();
  return {{"scenarios", record.scenarios},
          {"parameters", description(record.parameters, path, train::kDamagedRecord)},
          {"cross_validated_regret_ns", record.cross_validated_regret_ns},
          {"idle_regret_ns", record.idle_regret_ns},
          {"cross_validated_protection", protection ? Json(*protection) : Json()},
          {"distribution", description(record.distribution, path, train::kDamagedRecord)},
          {"simulation", description(record.simulation, path, train::kDamagedRecord)}};
}

/// A line for a value of the document, if it has one of that name.
void print_value(const Json& document, const std::string& name) {
  if (!document.contains(name)) return;
  const Json& value = document[name];
  std::cout << '\n'
            << printable(name) << ": "
            << printable(value.is_string() ? value.get<std::string>() : value.dump());
}

void print_training(const train::SelectorRecord& record) {
  std::cout << "\ntrained on " << record.scenarios << " scenarios"
            << "\nmean regret in cross-validation: " << fixed(record.cross_validated_regret_ns, 3)
            << " N s, of standing still " << fixed(record.idle_regret_ns, 3) << " N s: protection "
            << fixed(record.cross_validated_protection().value_or(std::nan("")), 3)
            << "\ntrained for distribution " << printable(record.distribution);
}

}  // namespace

SelectorView::SelectorView(const std::string& selector)
    : path(selector), file(train::load_selector_file(selector)) {
  const std::string bytes = database::read_file(selector);
  record = train::read_selector_record(std::as_bytes(std::span(bytes)), selector);
}

Json selector_document(const SelectorView& view) {
  const runtime::SelectorFile& file = view.file;
  const models::Selector& selector = file.selector;
  Json clips = Json::array();
  for (const models::ClipSummary& clip : selector.clips)
    clips.push_back({{"name", clip.name}, {"annotation", to_json(clip)}});
  Json document{
      {"kind", "selector"},
      {"library_hash", database::hash_text(selector.library_hash)},
      {"provenance", provenance_document(view.record ? view.record->provenance : "", view.path)},
      {"training", view.record ? training_document(*view.record, view.path) : Json()},
      {"brawn", selector.brawn},
      {"features", selector.layout.names()},
      {"threats", kinds_document(selector.kinds)}};
  if (selector.costs) {
    document["vulnerability_name"] = vulnerability_name(*selector.costs);
    document["vulnerability"] = vulnerability_document(selector.costs->vulnerability);
    for (const features::KindVulnerability& own : selector.costs->of_kind) {
      const std::string& kind = selector.kinds[static_cast<std::size_t>(own.kind)].name;
      document["vulnerability_to"][kind] = vulnerability_document(own.vulnerability);
    }
  }
  document.update(
      std::visit([](const auto& model) { return model_document(model); }, selector.model));
  document["idle"] = selector.clips[static_cast<std::size_t>(selector.idle)].name;
  document["clips"] = clips;
  document["has_clips"] = file.library.has_value();
  if (file.library) {
    document["library"] = file.library->name;
    document["poses"] = pose_count(*file.library);
  }
  return document;
}

void print_selector(const SelectorView& view) {
  const runtime::SelectorFile& file = view.file;
  const Json document = selector_document(view);
  const std::string made_by =
      provenance_lines(view.record ? view.record->provenance : "", view.path);
  std::cout << "selector for library " << document["library_hash"].get<std::string>();
  for (const char* key : {"model", "classes", "support_vectors", "k", "observations", "members",
                          "hidden", "machines"})
    print_value(document, key);
  if (view.record)
    for (const auto& [name, value] : document["training"]["parameters"].items())
      if (!document.contains(name)) print_value(document["training"]["parameters"], name);
  for (const char* key : {"brawn", "vulnerability_name"}) print_value(document, key);
  if (view.record) print_training(*view.record);
  std::cout << "\nthreats: ";
  for (const features::KnownKind& kind : file.selector.kinds)
    std::cout << (&kind == &file.selector.kinds.front() ? "" : ", ") << printable(kind.name);
  std::cout << "\nclips: " << file.selector.clips.size();
  if (file.library) {
    std::cout << ", in this file: " << pose_count(*file.library) << " poses at "
              << file.library->rate_hz << " Hz of library " << printable(file.library->name)
              << '\n';
  } else {
    std::cout << ", without motion in this file: it plays that of its library, a .flinchlib file "
                 "beside it\n";
  }
  std::cout << made_by;
}

}  // namespace flinch::program
