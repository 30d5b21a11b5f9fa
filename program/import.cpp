// SPDX-License-Identifier: MIT
#include "database/import/import.h"

#include <iostream>
#include <memory>
#include <optional>

#include "database/files/library_writer.h"
#include "database/import/manifest.h"
#include "database/library/library_bounds.h"
#include "program/bvh_options.h"
#include "program/command.h"
#include "program/log.h"
#include "program/printable.h"
#include "program/table.h"

namespace flinch::program {

namespace {

using enum Table::Align;

struct ImportOptions {
  std::vector<std::string> paths;
  std::string library;
  std::optional<std::string> manifest;
  std::optional<double> rate_hz;
  std::optional<std::string> skeleton;
  BvhOptions bvh;
  bool verbose = false;
  bool force = false;
  bool json = false;
};

std::size_t mirrored_count(const database::ClipLibrary& library) {
  std::size_t count = 0;
  for (const motion::Clip& clip : library.clips) count += clip.mirrored_from.empty() ? 0U : 1U;
  return count;
}

Json document_of(const ImportOptions& options, const database::ImportResult& result) {
  Json clips = Json::array();
  for (const database::ClipReport& clip : result.report.clips) {
    clips.push_back({{"name", clip.name},
                     {"purpose", motion::name_of(clip.purpose)},
                     {"source", clip.source},
                     {"duration_s", shortest(clip.duration_s)},
                     {"annotated", clip.is_annotated},
                     {"added_foot_drift_m", shortest(clip.drift.added_m)},
                     {"warnings", clip.warnings}});
  }
  Json sources = Json::array();
  for (const database::SourceReport& source : result.report.sources)
    sources.push_back(source_document(source));
  Json skipped = Json::array();
  for (const database::SkippedFile& file : result.report.skipped)
    skipped.push_back({{"file", file.path}, {"reason", file.reason}});
  return {{"kind", "library"},
          {"file", options.library},
          {"name", result.library.name},
          {"hash", database::hash_text(result.library.hash)},
          {"clip_count", result.library.clips.size()},
          {"mirrored_count", mirrored_count(result.library)},
          {"clips", clips},
          {"sources", sources},
          {"skipped", skipped},
          {"warnings", result.report.warnings}};
}

std::string clip_table(const database::ImportReport& report) {
  Table table(
      {{"clip"}, {"purpose"}, {"length, s", right}, {"added foot drift, mm", right}, {"source"}});
  for (const database::ClipReport& clip : report.clips) {
    const bool left_out = clip.purpose == motion::Purpose::anticipation && !clip.is_annotated;
    table.add({clip.name,
               std::string(motion::name_of(clip.purpose)) + (left_out ? " (unannotated)" : ""),
               fixed(double{clip.duration_s}, 2), fixed(1000 * double{clip.drift.added_m}, 1),
               clip.source});
  }
  return table.text();
}

// "FILE: what"; some messages say themselves which file they are about, and in which line.
std::string located(const std::string& file, const std::string& what) {
  return what.starts_with(file + ":") ? what : file + ": " + what;
}

std::string skipped_text(const database::SkippedFile& file) {
  return "skipped " + located(file.path, file.reason);
}

// The details of files hold their notes already.
void print_notes(const database::ImportReport& report, bool with_details) {
  for (const database::SourceReport& source : report.sources) {
    if (with_details) break;
    for (const std::string& warning : source.warnings) log_note(located(source.path, warning));
  }
  for (const database::ClipReport& clip : report.clips) {
    for (const std::string& warning : clip.warnings)
      log_note(clip.source + ": clip " + clip.name + ": " + warning);
  }
}

void print_text(const ImportOptions& options, const database::ImportResult& result) {
  if (options.verbose) {
    for (const database::SourceReport& source : result.report.sources)
      std::cout << source_text(source) << '\n';
    std::cout << clip_table(result.report) << '\n';
  }
  std::size_t unannotated = 0;
  for (const database::ClipReport& clip : result.report.clips) {
    unannotated += clip.purpose == motion::Purpose::anticipation && !clip.is_annotated ? 1U : 0U;
  }
  for (const database::SkippedFile& file : result.report.skipped)
    log(LogLevel::warning, skipped_text(file));
  print_notes(result.report, options.verbose);
  for (const std::string& warning : result.report.warnings) log_note(warning);
  const database::ClipLibrary& library = result.library;
  std::cout << printable(options.library) << ": library " << printable(library.name) << ", "
            << database::hash_text(library.hash) << ", " << library.clips.size() << " clips ("
            << mirrored_count(library) << " of them mirrored) at " << library.rate_hz << " Hz from "
            << result.report.sources.size() << " files, idle "
            << printable(library.idle_clip().name) << '\n';
  if (unannotated > 0)
    std::cout << unannotated
              << " clips are unannotated and are never used against a threat; annotate them in "
              << "a manifest\n";
}

/// Returns all files that the import reads; folders stand for what is in them.
std::vector<std::string> inputs_of(const ImportOptions& options) {
  std::vector<std::string> inputs = options.paths;
  inputs.insert(inputs.end(), {options.manifest.value_or(""), options.skeleton.value_or(""),
                               options.bvh.roles, options.bvh.rest});
  if (options.manifest) {
    const std::vector<std::string> files =
        database::manifest_files(options.paths, *options.manifest);
    inputs.insert(inputs.end(), files.begin(), files.end());
  }
  return inputs;
}

database::ImportResult imported(const ImportOptions& options,
                                const database::ImportOptions& import) try {
  return database::import_library(options.paths, options.manifest, import);
} catch (const database::UnusableFiles& error) {
  for (const database::SkippedFile& file : error.skipped)
    log(LogLevel::warning, skipped_text(file));
  throw;
}

void run_import(const ImportOptions& options) {
  database::check_outputs({{options.library, database::FileKind::library, ""}}, inputs_of(options),
                          overwrite_of(options.force));
  database::ImportOptions import;
  import.rate_hz = options.rate_hz;
  import.skeleton = options.skeleton;
  import.source = source_options(options.bvh);
  database::ImportResult result = imported(options, import);
  result.library.hash = database::write_library(result.library, options.library);
  if (options.json) {
    print(document_of(options, result));
  } else {
    print_text(options, result);
  }
}

}  // namespace

Command import_command() {
  auto options = std::make_shared<ImportOptions>();
  return {
      .name = "import",
      .summary = "Make a library from motion capture",
      .required = {{"PATH", "BVH, FBX or glTF files, or folders of them", &options->paths},
                   {"--out", "library file to write", &options->library}},
      .optional = join(
          {{{"--manifest",
             "TOML file that lists the clips to take and what they protect "
             "against",
             &options->manifest},
            {"--rate", "frame rate of the library, Hz (default: the manifest's, else 60)",
             &options->rate_hz, Range{database::kMinImportRate_hz, double{database::kMaxRate_hz}}},
            {"--skeleton", "file whose skeleton to use if there is no manifest",
             &options->skeleton}},
           bvh_options(options->bvh),
           {{"--verbose", "print details of each file and clip", &options->verbose},
            force_option(options->force),
            json_option(options->json)}}),
      .notes =
          "Example:\n  flinch import mocap --manifest mocap/manifest.toml --out "
          "real.flinchlib",
      .run = [options] { run_import(*options); }};
}

}  // namespace flinch::program
