// SPDX-License-Identifier: MIT
#include "program/realism_report.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "database/files/file_io.h"
#include "database/library/library.h"
#include "program/command.h"
#include "program/log.h"
#include "program/page.h"
#include "train/report/csv.h"

namespace flinch::program {
namespace {

constexpr std::array<const char*, 3> kFiles{"report.json", "learning_curve.csv", "report.html"};
constexpr std::array<std::size_t, 6> kSizes{50, 100, 200, 400, 800, 1500};

struct NamedKind {
  const char* name;
  train::RealismKind kind;
};
constexpr std::array kKinds{NamedKind{"ours", train::RealismKind::ours},
                            NamedKind{"paper", train::RealismKind::paper}};

Json row_of(const NamedKind& model, std::size_t labels, const train::RealismAgreement& result) {
  return {{"name", model.name},
          {"labels", labels},
          {"agreement", result.agreement},
          {"auc", result.auc}};
}

/// Every model fitted to fewer labels than there are.
Json curve_of(const train::LabelledConfigurations& all, bool is_quiet) {
  Json curve = Json::array();
  for (const NamedKind& model : kKinds) {
    for (const std::size_t size : kSizes) {
      if (size > all.labels.size()) break;
      if (!is_quiet)
        log(LogLevel::info,
            std::string("fitting ") + model.name + " to " + std::to_string(size) + " labels");
      curve.push_back(row_of(model, size, train::held_out_agreement(all, model.kind, size)));
    }
  }
  return curve;
}

Json document_of(const train::LabelledConfigurations& all, const RealismOrigin& origin,
                 bool is_quiet) {
  std::set<std::string> sittings;
  std::size_t good = 0;
  for (const train::Label& label : all.labels) {
    sittings.insert(label.sitting);
    good += label.quality > runtime::kGoodRealism ? 1 : 0;
  }
  Json rows = Json::array();
  train::RealismAgreement last;
  for (const NamedKind& model : kKinds) {
    last = train::held_out_agreement(all, model.kind);
    rows.push_back(row_of(model, all.labels.size(), last));
  }
  const auto in_selector = std::ranges::find(kKinds, origin.kind, &NamedKind::kind);
  return {{"kind", "realism"},
          {"version", FLINCH_VERSION},
          {"library", origin.library},
          {"library_hash", database::hash_text(origin.library_hash)},
          {"judge", origin.judge},
          {"is_proxy", origin.judge.starts_with("proxy")},
          {"realism", in_selector->name},
          {"labels", all.labels.size()},
          {"good", good},
          {"sittings", sittings.size()},
          {"chance", last.chance},
          {"baseline_auc", last.baseline_auc},
          {"rows", rows},
          {"curve", curve_of(all, is_quiet)}};
}

std::string csv_of(const Json& curve) {
  std::string text = "name,labels,agreement,auc\n";
  for (const Json& row : curve) {
    text += row["name"].get<std::string>() + ',' + std::to_string(row["labels"].get<int>());
    for (const char* number : {"agreement", "auc"})
      text += ',' + train::exact_text(row[number].get<double>());
    text += '\n';
  }
  return text;
}

}  // namespace

void check_realism_report(const std::string& folder, const std::vector<std::string>& inputs,
                          bool overwrites) {
  std::vector<database::Output> files;
  for (const char* name : kFiles) files.push_back({name, database::FileKind::text, ""});
  database::check_output_folder(folder, files, inputs, overwrite_of(overwrites));
}

void write_realism_report(const train::LabelledConfigurations& all, const RealismOrigin& origin,
                          const std::string& folder, bool is_quiet) {
  const std::string page = find_report_page();
  const Json document = document_of(all, origin, is_quiet);
  create_folder(folder);
  const auto write = [&](const char* name, const std::string& text) {
    database::write_file_atomically((std::filesystem::path(folder) / name).string(), text);
  };
  write(kFiles[0], document.dump(2) + '\n');
  write(kFiles[1], csv_of(document["curve"]));
  if (!page.empty()) write(kFiles[2], page_with_report(page, document.dump()));
}

}  // namespace flinch::program
