// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iostream>
#include <memory>

#include "database/annotate/contact_sheet.h"
#include "database/annotate/draft_toml.h"
#include "database/files/file_io.h"
#include "motion/error.h"
#include "program/bvh_options.h"
#include "program/command.h"
#include "program/log.h"
#include "program/printable.h"
#include "program/table.h"

namespace flinch::program {

namespace {

namespace fs = std::filesystem;

using enum Table::Align;

struct AnnotateOptions {
  std::string take;
  std::string out;
  std::string sheet;
  BvhOptions bvh;
  bool force = false;
  bool json = false;
};

// Options with the paths that are not given: beside the take.
AnnotateOptions completed(AnnotateOptions options) {
  if (options.out.empty()) options.out = fs::path(options.take).replace_extension(".toml").string();
  if (options.sheet.empty()) {
    options.sheet = fs::path(options.out).replace_extension(".svg").string();
  }
  return options;
}

// A draft that was corrected by hand must not be lost.
void expect_new(const std::string& path, const char* option) {
  if (!fs::exists(fs::symlink_status(path))) return;
  throw Error(path,
              std::string("exists already and may hold corrections; give --force to replace it, "
                          "or name another file with ") +
                  option);
}

// The path of a file as seen from another one's folder.
std::string seen_from(const std::string& file, const std::string& path) {
  const fs::path folder = fs::absolute(file).parent_path();
  return fs::absolute(path)
      .lexically_normal()
      .lexically_relative(folder.lexically_normal())
      .string();
}

template <class Value>
Json guess_document(const Json& value, const database::Guess<Value>& guess) {
  return {{"value", value}, {"confidence", shortest(guess.confidence)}, {"reason", guess.reason}};
}

Json clip_document(const database::DraftClip& clip) {
  const database::Protection& protection = clip.protection;
  return {{"name", clip.name},
          {"start_s", clip.start_s},
          {"onset_s", clip.onset_s},
          {"peak_s", clip.peak_s},
          {"end_s", clip.end_s},
          {"kind", guess_document(database::name_of(clip.kind.value), clip.kind)},
          {"target", guess_document(motion::name_of(protection.target.value), protection.target)},
          {"direction", guess_document(database::whole_degrees(protection.direction.value),
                                       protection.direction)},
          {"degree", motion::name_of(protection.degree)},
          {"heading", rounded_degrees(static_cast<double>(clip.heading))}};
}

Json document_of(const AnnotateOptions& options, const database::Take& take,
                 const database::Draft& draft) {
  Json still = Json::array();
  for (const database::TimeSpan& span : draft.still) {
    still.push_back({{"start_s", span.start_s}, {"end_s", span.end_s}});
  }
  Json clips = Json::array();
  for (const database::DraftClip& clip : draft.clips) clips.push_back(clip_document(clip));
  return {{"kind", "draft"},
          {"file", options.out},
          {"sheet", options.sheet},
          {"still_limit_mps", shortest(draft.still_limit_mps)},
          {"still", still},
          {"idle",
           {{"start_s", draft.idle.start_s},
            {"end_s", draft.idle.end_s},
            {"confidence", shortest(draft.idle.confidence)},
            {"reason", draft.idle.reason}}},
          {"clips", clips},
          {"source", source_document(take.source)}};
}

std::string with_confidence(std::string value, float confidence) {
  return value + " " + fixed(double{confidence}, 2);
}

std::string clip_table(const database::Draft& draft) {
  Table table({{"clip"},
               {"onset, s", right},
               {"peak, s", right},
               {"end, s", right},
               {"kind"},
               {"target"},
               {"direction", right}});
  for (const database::DraftClip& clip : draft.clips) {
    const database::Protection& protection = clip.protection;
    table.add(
        {clip.name, fixed(clip.onset_s, 2), fixed(clip.peak_s, 2), fixed(clip.end_s, 2),
         with_confidence(std::string(database::name_of(clip.kind.value)), clip.kind.confidence),
         with_confidence(std::string(motion::name_of(protection.target.value)),
                         protection.target.confidence),
         with_confidence(std::to_string(database::whole_degrees(protection.direction.value)),
                         protection.direction.confidence)});
  }
  return table.text();
}

void print_text(const AnnotateOptions& options, const database::Take& take,
                const database::Draft& draft) {
  for (const std::string& warning : take.source.warnings) log_note(warning);
  if (!draft.clips.empty()) std::cout << clip_table(draft) << '\n';
  std::cout << printable(options.out) << ": draft with the idle from "
            << fixed(draft.idle.start_s, 2) << " to " << fixed(draft.idle.end_s, 2) << " s and "
            << draft.clips.size() << " clips; look at " << printable(options.sheet)
            << " and correct it\n";
  if (draft.clips.empty()) log_note("nothing moves away from stillness in this take");
}

void run_annotate(const AnnotateOptions& given) {
  const AnnotateOptions options = completed(given);
  database::check_outputs(
      {{options.out, database::FileKind::text, ""}, {options.sheet, database::FileKind::text, ""}},
      {options.take, options.bvh.roles, options.bvh.rest}, database::Overwrite::force);
  if (!options.force) {
    expect_new(options.out, "--out");
    expect_new(options.sheet, "--sheet");
  }
  const database::SourceOptions source = source_options(options.bvh);
  const database::Take take = database::read_take(options.take, source);
  const database::Draft draft = database::draft_of(take);
  const database::DraftPaths paths{.take = seen_from(options.out, options.take),
                                   .sheet = seen_from(options.out, options.sheet),
                                   .rest = source.rest ? seen_from(options.out, *source.rest) : ""};
  database::write_file_atomically(options.sheet, database::contact_sheet_svg(take, draft));
  database::write_file_atomically(options.out, database::draft_toml(draft, paths, source));
  if (options.json) {
    print(document_of(options, take, draft));
  } else {
    print_text(options, take, draft);
  }
}

}  // namespace

Command annotate_command() {
  auto options = std::make_shared<AnnotateOptions>();
  return {.name = "annotate",
          .summary = "Draft a manifest for a raw take of motion capture",
          .required = {{"TAKE", "BVH, FBX or glTF file", &options->take}},
          .optional =
              join({{{"--out", "manifest to write (default: TAKE with .toml)", &options->out},
                     {"--sheet", "contact sheet to write, an SVG (default: the manifest with .svg)",
                      &options->sheet}},
                    bvh_options(options->bvh),
                    {force_option(options->force), json_option(options->json)}}),
          .notes =
              "Finds the idle and the movements between returns to stillness, and guesses the "
              "kind, onset,\n"
              "peak, target and direction of each, with a confidence from 0 to 1. Correct the "
              "guesses before\n"
              "you use them.\n\n"
              "Example:\n  flinch annotate take.bvh --out take.toml\n"
              "  flinch import take.bvh --manifest take.toml --out take.flinchlib",
          .run = [options] { run_annotate(*options); }};
}

}  // namespace flinch::program
