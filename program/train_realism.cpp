// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <set>

#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "database/files/provenance.h"
#include "motion/error.h"
#include "program/command.h"
#include "program/log.h"
#include "program/printable.h"
#include "program/realism_report.h"
#include "program/table.h"
#include "runtime/response/prepared_library.h"
#include "train/fit/selector_reader.h"
#include "train/fit/selector_writer.h"
#include "train/realism/proxy_judge.h"
#include "train/realism/realism_evaluation.h"

namespace flinch::program {

namespace {

struct TrainRealismOptions {
  std::string labels;
  std::string selector;
  std::string report;
  std::string realism{"ours"};
  bool force = false;
  bool json = false;
};

/// The judges of the labels, each once: "proxy: …" where a proxy is among them.
std::string judge_of(const std::vector<train::Label>& labels) {
  const auto is_proxy = [](const train::Label& label) { return label.judge.starts_with("proxy"); };
  if (std::ranges::none_of(labels, is_proxy)) return "people";
  return std::ranges::all_of(labels, is_proxy) ? std::string(train::kProxyJudge)
                                               : "proxy: measured bounds, and people";
}

/// The selector's record, to which the labels are added; none where it has none.
std::optional<train::SelectorRecord> record_with_labels(const TrainRealismOptions& options) {
  const std::string bytes = database::read_file(options.selector);
  std::optional<train::SelectorRecord> record =
      train::read_selector_record(std::as_bytes(std::span(bytes)), options.selector);
  if (!record) return record;
  std::optional<database::Provenance> made = database::provenance_of(record->provenance);
  if (!made) throw Error(options.selector, "its provenance is damaged; run `flinch train` again");
  std::erase_if(made->options, [](const auto& option) { return option.first == "realism"; });
  std::erase_if(made->inputs, [](const auto& input) { return input.role == "labels"; });
  made->options.emplace_back("realism", options.realism);
  add_inputs("labels", {options.labels}, *made);
  record->provenance = database::provenance_text(*made);
  return record;
}

void run_train_realism(const TrainRealismOptions& options) {
  if (!options.report.empty())
    check_realism_report(options.report, {options.labels, options.selector}, options.force);
  runtime::SelectorFile file = train::load_selector_file(options.selector);
  if (!file.library)
    throw Error(options.selector,
                "the selector has no clips; run `flinch train` without --without-clips");
  const runtime::PreparedLibrary prepared = runtime::prepare(*file.library);
  const runtime::PushResponses responses = runtime::prepare_push_responses(prepared);
  train::LabelSet set = train::read_labels(options.labels, *file.library, responses);
  if (set.labels.size() <= models::kRealismNeighbours ||
      set.labels.size() > models::kMaxRealismExamples) {
    throw Error(options.labels, "holds " + std::to_string(set.labels.size()) +
                                    " labels; a realism model takes " +
                                    std::to_string(models::kRealismNeighbours + 1) + " to " +
                                    std::to_string(models::kMaxRealismExamples));
  }
  const std::string judge = judge_of(set.labels);
  const auto kind =
      options.realism == "paper" ? train::RealismKind::paper : train::RealismKind::ours;
  const train::LabelledConfigurations all =
      train::configurations_of(responses, std::move(set.labels));
  std::set<std::string> sittings;
  for (const train::Label& label : all.labels) sittings.insert(label.sitting);
  if (sittings.size() < 2 && !options.report.empty()) {
    throw Error(options.labels,
                "holds one sitting alone, so there is nothing to hold out for a "
                "report; label in a second sitting, or leave out --report");
  }
  train::RealismAgreement held_out;
  if (sittings.size() > 1) held_out = train::held_out_agreement(all, kind);

  std::optional<train::SelectorRecord> record = record_with_labels(options);
  file.selector.realism = train::fit_realism(all, kind, judge);
  const std::string library = database::library_bytes(*file.library);
  train::write_selector(file.selector, std::as_bytes(std::span(library)),
                        record ? &*record : nullptr, options.selector);
  if (!options.report.empty()) {
    write_realism_report(all, {file.library->name, file.library->hash, judge, kind}, options.report,
                         options.json);
  }
  if (options.json) {
    print({{"kind", "realism"},
           {"file", options.selector},
           {"judge", judge},
           {"labels", all.labels.size()},
           {"sittings", sittings.size()},
           {"agreement", held_out.agreement},
           {"chance", held_out.chance},
           {"auc", held_out.auc},
           {"baseline_auc", held_out.baseline_auc}});
    return;
  }
  std::cout << printable(options.selector) << ": realism of " << all.labels.size()
            << " labels, judged by " << printable(judge) << '\n';
  if (held_out.count == 0) {
    log_note("one sitting alone cannot be held out; agreement is not known");
    return;
  }
  std::cout << "held out by sitting: agreement " << fixed(held_out.agreement, 3) << " (chance "
            << fixed(held_out.chance, 3) << "), AUC " << fixed(held_out.auc, 3)
            << " (nearest configuration " << fixed(held_out.baseline_auc, 3) << ")\n";
}

}  // namespace

Command train_realism_command() {
  auto options = std::make_shared<TrainRealismOptions>();
  return {
      .name = "train-realism",
      .summary = "Fit the realism of pushed motions to labels, into a selector",
      .required = {{"LABELS", "label file made by flinch label", &options->labels},
                   {"--into", "selector file that gets the model", &options->selector}},
      .optional = {{"--report",
                    "folder for a page with learning curves and its data, created if missing",
                    &options->report},
                   {"--realism",
                    "model: ours, or the paper's, which averages the deformation of examples and "
                    "whose G does not see the asked push",
                    &options->realism, OneOf{{"ours", "paper"}}},
                   force_option(options->force),
                   json_option(options->json)},
      .notes =
          "Example:\n  flinch train-realism real.flinchlabels --into real.flinch --report report",
      .run = [options] { run_train_realism(*options); }};
}

}  // namespace flinch::program
