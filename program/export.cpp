// SPDX-License-Identifier: MIT
#include "train/report/export.h"

#include <filesystem>
#include <iostream>
#include <memory>

#include "database/export/bvh_writer.h"
#include "database/export/clip_export.h"
#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "motion/error.h"
#include "program/command.h"
#include "program/command_line.h"
#include "program/printable.h"
#include "train/fit/feature_derivation.h"
#include "train/fit/labels.h"
#include "train/store/store.h"

namespace flinch::program {

namespace {

struct ExportOptions {
  std::string source;
  std::string file;
  std::string clips;
  std::string clip_format = "one-glb";
  std::string scaling;
  std::string features;
  CostOptions cost;
  bool force = false;
  bool json = false;
};

/// Returns the scaling of the store itself, or of the training store that is given.
features::Scaling scaling_for(const ExportOptions& options, const train::Store& store) {
  if (options.scaling.empty()) return scaling_of(store.header, store.observations);
  train::Store fitted = train::read_store(options.scaling);
  derive_features(store.header.layout, fitted);
  return scaling_of(fitted.header, fitted.observations);
}

void export_data(const ExportOptions& options) {
  const bool libsvm = options.file.ends_with(".libsvm");
  if (!libsvm && !options.file.ends_with(".csv"))
    throw Error(options.file, "unknown kind of file; use a name that ends in .libsvm or .csv");
  database::check_outputs(
      {{options.file, database::FileKind::text, libsvm ? " 1:" : "number,target,"}},
      {options.source, options.scaling, vulnerability_file(options.cost)},
      overwrite_of(options.force));
  const train::VulnerabilityProfile vulnerability = vulnerability_of(options.cost);
  train::Store store = read_labelled_store(options.source, options.cost);
  derive_features(train::layout_for(options.features, store.header), store);
  const train::CostModel cost_model =
      make_cost_model(store.header, vulnerability, options.cost.brawn);
  const train::Labels labels = train::label(store.observations, cost_model);
  database::write_file_atomically(
      options.file, libsvm ? train::libsvm_text(store, labels, scaling_for(options, store))
                           : train::csv_text(store, labels));
  if (options.json) {
    print({{"kind", libsvm ? "libsvm" : "csv"},
           {"file", options.file},
           {"scenarios", store.observations.size()}});
  } else {
    std::cout << printable(options.file) << ": " << store.observations.size() << " scenarios\n";
  }
}

/// Returns the names of the files that clips are written into.
std::vector<std::string> clip_files(const ExportOptions& options,
                                    const std::vector<database::NamedMotion>& clips) {
  if (options.clip_format == "one-glb") return {"clips.glb"};
  std::vector<std::string> files;
  for (const database::NamedMotion& clip : clips)
    files.push_back(clip.name + "." + options.clip_format);
  return files;
}

void check_folder(const ExportOptions& options, const std::vector<std::string>& files) {
  const bool is_bvh = options.clip_format == "bvh";
  std::vector<database::Output> outputs;
  for (const std::string& file : files) {
    outputs.push_back(is_bvh
                          ? database::Output{file, database::FileKind::bvh, database::kBvhMark}
                          : database::Output{file, database::FileKind::gltf, database::kGlbMark});
  }
  database::check_output_folder(options.clips, outputs, {options.source},
                                overwrite_of(options.force));
}

void write_clips(const motion::Physique& character, const std::vector<database::NamedMotion>& clips,
                 const ExportOptions& options, const std::vector<std::string>& files) {
  const auto path = [&](std::size_t i) {
    return (std::filesystem::path(options.clips) / files[i]).string();
  };
  if (options.clip_format == "one-glb") {
    database::write_glb(path(0), character, clips);
    return;
  }
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (options.clip_format == "bvh")
      database::write_bvh(path(i), character, clips[i].motion);
    else
      database::write_glb(path(i), character, clips[i].motion, std::nullopt, clips[i].facts);
  }
}

void export_clips(const ExportOptions& options) {
  const database::ClipLibrary library = database::load_library(options.source);
  const std::vector<database::NamedMotion> clips = database::exported_clips(library);
  const std::vector<std::string> files = clip_files(options, clips);
  check_folder(options, files);
  create_folder(options.clips);
  write_clips(library.character, clips, options, files);
  if (options.json) {
    print(
        {{"kind", "clips"}, {"folder", options.clips}, {"files", files}, {"clips", clips.size()}});
  } else {
    std::cout << printable(options.clips) << ": " << clips.size() << " clips in " << files.size()
              << (files.size() == 1 ? " file\n" : " files\n");
  }
}

void run_export(const ExportOptions& options) {
  if (options.file.empty() == options.clips.empty())
    throw UsageError(
        "export wants --out FILE for a store's data, or --clips FOLDER for a "
        "library's clips");
  if (options.clips.empty())
    export_data(options);
  else
    export_clips(options);
}

}  // namespace

Command export_command() {
  auto options = std::make_shared<ExportOptions>();
  return {.name = "export",
          .summary = "Write a store's data, or a library's clips, for other tools",
          .required = {{"SOURCE", "store made by flinch simulate, or library", &options->source}},
          .optional = join(
              {{{"--out",
                 "FILE.libsvm (scaled features and labels) or FILE.csv (named columns), "
                 "of a store",
                 &options->file},
                {"--clips", "folder for a library's clips, created if missing", &options->clips},
                {"--clip-format",
                 "one-glb: clips.glb with an animation for each clip; glb or bvh: a file "
                 "for each",
                 &options->clip_format, OneOf{{"one-glb", "glb", "bvh"}}},
                {"--scaled-as",
                 "training store that defines the scaling, for test data "
                 "(default: the store itself)",
                 &options->scaling},
                features_option(options->features)},
               label_options(options->cost),
               {force_option(options->force), json_option(options->json)}}),
          .notes =
              "Examples:\n  flinch export real.flinchobs --out real.libsvm\n"
              "  flinch export real.flinchlib --clips clips",
          .run = [options] { run_export(*options); }};
}

}  // namespace flinch::program
