// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <memory>

#include "database/files/library_writer.h"
#include "motion/error.h"
#include "program/command.h"
#include "program/printable.h"
#include "program/table.h"
#include "runtime/character.h"
#include "runtime/response/prepared_library.h"
#include "train/realism/proxy_judge.h"

namespace flinch::program {

namespace {

struct LabelOptions {
  std::string library;
  std::string out;
  std::uint64_t proxy = 1500;
  std::uint64_t seed = 1;
  bool json = false;
};

void run_label(const LabelOptions& options) {
  const database::ClipLibrary library = database::load_library(options.library);
  const runtime::PreparedLibrary prepared = runtime::prepare(library);
  const runtime::PushResponses responses = runtime::prepare_push_responses(prepared);
  if (responses.responses.empty())
    throw Error(options.library, message_of(runtime::Status::without_pushes));
  const train::ProxyJudge judge(responses);
  const std::vector<train::Label> labels =
      train::proxy_labels(responses, judge, options.proxy, options.seed);
  const auto good = std::ranges::count_if(
      labels, [](const train::Label& label) { return label.quality > runtime::kGoodRealism; });
  train::append_labels(options.out, library, labels);
  if (options.json) {
    print({{"kind", "labels"},
           {"file", options.out},
           {"judge", train::kProxyJudge},
           {"labels", options.proxy},
           {"good", good}});
    return;
  }
  std::cout << printable(options.out) << ": " << options.proxy << " labels more, " << good
            << " of them good, by " << train::kProxyJudge << '\n';
}

}  // namespace

Command label_command() {
  auto options = std::make_shared<LabelOptions>();
  return {.name = "label",
          .summary = "Judge pushed motions by measures, until people do",
          .required = {{"LIBRARY", "library with pushes", &options->library},
                       {"--out", "label file to append to", &options->out}},
          .optional = {{"--proxy", "number of motions that the proxy judges", &options->proxy,
                        Range{1, double{models::kMaxRealismExamples}}},
                       {"--seed", "of the motions that are drawn", &options->seed},
                       json_option(options->json)},
          .notes =
              "The proxy measures joints, feet, speeds and balance (docs/pushing.md); it proves\n"
              "nothing about what people see, and every file and report names it.\n\n"
              "Example:\n  flinch label real.flinchlib --out real.flinchlabels",
          .run = [options] { run_label(*options); }};
}

}  // namespace flinch::program
