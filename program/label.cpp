// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "database/export/gltf_writer.h"
#include "database/files/library_writer.h"
#include "motion/error.h"
#include "program/command.h"
#include "program/command_line.h"
#include "program/printable.h"
#include "program/table.h"
#include "runtime/character.h"
#include "runtime/response/prepared_library.h"
#include "train/realism/labelling.h"
#include "train/realism/proxy_judge.h"

namespace flinch::program {

namespace {

constexpr const char* kQuestions = "questions.flinchlabels";

struct LabelOptions {
  std::string library;
  std::optional<std::string> out;
  std::optional<std::uint64_t> proxy;
  std::uint64_t seed = 1;
  std::optional<std::string> ask;
  std::uint64_t motions = 20;
  std::vector<std::string> merge;
  std::optional<std::string> study;
  bool json = false;
};

/// The responses of a library, with what they refer to.
struct LabelLibrary {
  explicit LabelLibrary(const std::string& path)
      : clips(database::load_library(path)),
        prepared(runtime::prepare(clips)),
        responses(runtime::prepare_push_responses(prepared)) {
    if (responses.responses.empty()) throw Error(path, message_of(runtime::Status::without_pushes));
  }
  database::ClipLibrary clips;
  runtime::PreparedLibrary prepared;
  runtime::PushResponses responses;
};

void label_by_proxy(const LabelOptions& options, const LabelLibrary& library) {
  constexpr std::uint64_t kLabels = 1500;
  const train::ProxyJudge judge(library.responses);
  const std::vector<train::Label> labels =
      train::proxy_labels(library.responses, judge, options.proxy.value_or(kLabels), options.seed);
  const auto good = std::ranges::count_if(
      labels, [](const train::Label& label) { return label.quality > runtime::kGoodRealism; });
  train::append_labels(*options.out, library.clips, labels);
  if (options.json) {
    print({{"kind", "labels"},
           {"file", *options.out},
           {"judge", train::kProxyJudge},
           {"labels", labels.size()},
           {"good", good}});
    return;
  }
  std::cout << printable(*options.out) << ": " << labels.size() << " labels more, " << good
            << " of them good, by " << train::kProxyJudge << '\n';
}

/// Writes motions to judge, with estimates from the labels that there are.
void ask(const LabelOptions& options, const LabelLibrary& library) {
  const std::filesystem::path folder = *options.ask;
  const std::filesystem::path file = folder / kQuestions;
  database::check_output_folder(folder.string(), {{kQuestions, database::FileKind::text, ""}}, {},
                                database::Overwrite::refuse);
  if (std::filesystem::exists(file))
    throw Error(file.string(), "is there already; --merge its answers and name another folder");
  train::Labelling labelling(library.responses, options.seed);
  if (std::filesystem::exists(*options.out))
    labelling.add(train::read_labels(*options.out, library.clips, library.responses).labels);
  create_folder(folder.string());
  std::vector<train::Question> questions;
  for (std::uint64_t k = 0; k < options.motions; ++k) {
    labelling.next();
    const std::string name = std::to_string(k + 1) + ".glb";
    database::write_glb((folder / name).string(), library.clips.character,
                        train::played(library.responses, labelling.example()));
    questions.push_back({labelling.example(), labelling.estimate(), name});
  }
  train::write_questions(file.string(), library.clips, questions);
  if (options.json) {
    print({{"kind", "questions"}, {"file", file.string()}, {"motions", questions.size()}});
    return;
  }
  std::cout << printable(file.string()) << ": " << questions.size()
            << " motions; fill in judge, sitting and realism, then --merge it\n";
}

void merge(const LabelOptions& options, const LabelLibrary& library) {
  const train::MergedLabels merged =
      train::merge_labels(*options.out, library.clips, library.responses, options.merge);
  if (options.json) {
    print({{"kind", "merged"},
           {"file", *options.out},
           {"added", merged.added},
           {"known", merged.known},
           {"unanswered", merged.unanswered}});
    return;
  }
  std::cout << printable(*options.out) << ": " << merged.added << " labels more; " << merged.known
            << " were there, " << merged.unanswered << " motions are without an answer\n";
}

std::string shown_text(train::Shown shown) {
  return shown == train::Shown::recording ? "recordings as they are"
         : shown == train::Shown::good    ? "realism above 0.5"
                                          : "realism below";
}

Json row_of(train::Shown shown, const train::Verdicts& verdicts) {
  const auto share = train::share_of_yes(verdicts);
  return {{"shown", train::name_of(shown)},
          {"yes", verdicts.yes},
          {"unsure", verdicts.unsure},
          {"no", verdicts.no},
          {"share_of_yes", share ? Json(share->share) : Json()},
          {"share_of_yes_ci", share ? Json{share->low, share->high} : Json()}};
}

std::vector<std::string> cells_of(train::Shown shown, const train::Verdicts& verdicts) {
  const auto share = train::share_of_yes(verdicts);
  return {shown_text(shown),
          std::to_string(verdicts.yes),
          std::to_string(verdicts.unsure),
          std::to_string(verdicts.no),
          share ? fixed(share->share, 2) : "-",
          share ? fixed(share->low, 2) + " to " + fixed(share->high, 2) : "-"};
}

/// The paper's test: is it a recording?
void print_study(const LabelOptions& options, const LabelLibrary& library) {
  const train::StudyFile study = train::read_study(*options.study, library.clips);
  const auto ratio = train::good_against_recordings(study.table);
  const auto agreement = train::agreement_without_unsure(study.table);
  using enum Table::Align;
  Table table({{"of"},
               {"yes", right},
               {"unsure", right},
               {"no", right},
               {"share of yes", right},
               {"95 %", right}});
  Json rows = Json::array();
  for (const train::Shown shown : train::kShown) {
    const train::Verdicts& verdicts = study.table[static_cast<std::size_t>(shown)];
    table.add(cells_of(shown, verdicts));
    rows.push_back(row_of(shown, verdicts));
  }
  if (options.json) {
    print({{"kind", "study"},
           {"file", *options.study},
           {"judges", study.judges},
           {"rows", rows},
           {"good_against_recordings", ratio ? Json(*ratio) : Json()},
           {"agreement", agreement ? Json(*agreement) : Json()}});
    return;
  }
  std::cout << printable(*options.study) << ": " << study.judges
            << " judges were asked: is it a recording?\n\n"
            << table.text();
  if (ratio)
    std::cout << "good motions pass " << fixed(*ratio, 2) << " times as often as recordings\n";
  if (agreement)
    std::cout << "judges agree with the estimate on " << fixed(*agreement, 2)
              << " of the pushed motions, without \"unsure\"\n";
}

void run_label(const LabelOptions& options) {
  const int ways = (options.proxy ? 1 : 0) + (options.ask ? 1 : 0) +
                   (options.merge.empty() ? 0 : 1) + (options.study ? 1 : 0);
  if (ways > 1) throw UsageError("label takes one of --proxy, --ask, --merge and --study");
  if (!options.study && !options.out) throw UsageError("label needs --out, a label file");
  const LabelLibrary library(options.library);
  if (options.study) {
    print_study(options, library);
  } else if (options.ask) {
    ask(options, library);
  } else if (!options.merge.empty()) {
    merge(options, library);
  } else {
    label_by_proxy(options, library);
  }
}

}  // namespace

Command label_command() {
  auto options = std::make_shared<LabelOptions>();
  return {
      .name = "label",
      .summary = "Collect labels of how real pushed motions look, from people or measures",
      .required = {{"LIBRARY", "library with pushes", &options->library}},
      .optional = {{"--out", "label file to append to", &options->out},
                   {"--proxy", "number of motions that the proxy judges", &options->proxy,
                    Range{1, double{models::kMaxRealismExamples}}},
                   {"--ask", "write motions to judge into this folder instead", &options->ask},
                   {"--motions", "number of motions to judge", &options->motions, Range{1, 1000}},
                   {"--merge", "add the labels of these files instead", &options->merge},
                   {"--study", "print what judges said on the page under Recording?",
                    &options->study},
                   {"--seed", "of the motions that are drawn", &options->seed},
                   json_option(options->json)},
      .notes =
          "People judge on the page of flinch view, under Label; --merge adds what it saves, and\n"
          "the answers to what --ask writes. Without either a proxy judges 1,500 motions.\n"
          "The proxy measures joints, feet, speeds and balance (docs/pushing.md); it proves\n"
          "nothing about what people see, and every file and report names it.\n\n"
          "Example:\n  flinch label real.flinchlib --out real.flinchlabels",
      .run = [options] { run_label(*options); }};
}

}  // namespace flinch::program
