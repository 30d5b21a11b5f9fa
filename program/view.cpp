// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <memory>

#include "database/files/file_io.h"
#include "motion/error.h"
#include "program/command.h"
#include "program/command_line.h"
#include "program/page.h"
#include "program/printable.h"
#include "train/fit/selector_reader.h"

namespace flinch::program {

namespace {

constexpr std::size_t kMaxSelectors = 3;  // as many as the page compares (viewer/src/chooser.ts)
constexpr const char* kPageName = "index.html";

struct ViewOptions {
  std::vector<std::string> selectors;
  std::string out = "flinch_page";
  bool force = false;
  bool json = false;
};

void run_view(const ViewOptions& options) {
  if (options.selectors.size() > kMaxSelectors)
    throw UsageError("view takes at most " + std::to_string(kMaxSelectors) + " selectors, " +
                     std::to_string(options.selectors.size()) + " are given");
  database::check_output_folder(options.out, {{kPageName, database::FileKind::text, kPageMark}},
                                options.selectors, overwrite_of(options.force));
  std::vector<PageFile> files;
  for (const std::string& selector : options.selectors) {
    if (!train::load_selector_file(selector).library)
      throw Error(selector,
                  "the selector has no clips, which a page needs; run `flinch train` without "
                  "--without-clips");
    files.push_back(
        {std::filesystem::path(selector).filename().string(), database::read_file(selector)});
  }
  const std::string page = find_page(kThrowPage);
  if (page.empty())
    throw Error("",
                "there is no page beside this program; scripts/page builds it, and "
                "build/release/flinch finds it");
  const std::string filled = page_with(page, files);
  create_folder(options.out);
  const std::filesystem::path file = std::filesystem::path(options.out) / kPageName;
  database::write_file_atomically(file.string(), filled);

  std::error_code error;
  const std::filesystem::path place = std::filesystem::canonical(file, error);
  if (options.json) {
    print({{"kind", "page"}, {"file", file.string()}, {"selectors", options.selectors}});
  } else {
    std::cout << printable(file.string()) << ": open file://" << printable(place.string())
              << " in a browser\n";
  }
}

}  // namespace

Command view_command() {
  auto options = std::make_shared<ViewOptions>();
  return {.name = "view",
          .summary = "Write a page on which to throw balls at a character, in any browser",
          .required = {{"SELECTOR", "selectors made by flinch train, at most three",
                        &options->selectors}},
          .optional = {{"--out", "folder for the page, created if missing", &options->out},
                       force_option(options->force),
                       json_option(options->json)},
          .notes =
              "The page is one file, FOLDER/index.html, which holds all that it needs. Open "
              "it from the\ndisk, or put it onto a web server. scripts/page builds the page "
              "that selectors are put into.\n\n"
              "Example:\n  flinch view default.flinch --out page",
          .run = [options] { run_view(*options); }};
}

}  // namespace flinch::program
