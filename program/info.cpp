// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <memory>

#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "database/import/import.h"
#include "evolve/pain/pain_drawing.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "program/bvh_options.h"
#include "program/command.h"
#include "program/printable.h"
#include "program/provenance_view.h"
#include "program/quality.h"
#include "program/selector_view.h"
#include "program/table.h"
#include "train/store/file_opening.h"
#include "train/store/store.h"
#include "train/store/store_schema.h"

namespace flinch::program {

namespace {

using enum Table::Align;

struct InfoOptions {
  std::string file;
  BvhOptions bvh;
  bool quality = false;
  std::optional<std::string> pain;
  bool force = false;
  bool json = false;
};

Json push_document(const motion::Push& push) {
  const Eigen::Vector3f& v = push.velocity;
  return {{"place", motion::push_place_name(push.place)},
          {"direction_degrees", shortest(motion::degrees(push.direction))},
          {"velocity_mps", {shortest(v.x()), shortest(v.y()), shortest(v.z())}},
          {"contact_s", shortest(push.contact_s)},
          {"peak_s", shortest(push.peak_s)}};
}

Json clip_document(const motion::Clip& clip) {
  Json document{{"name", clip.name},
                {"purpose", motion::name_of(clip.purpose)},
                {"kind", clip.kind},
                {"duration_s", shortest(clip.motion.duration_s())},
                {"source", clip.source}};
  if (!clip.mirrored_from.empty()) document["mirrored_from"] = clip.mirrored_from;
  document["annotation"] = to_json(models::ClipSummary{clip.name, clip.annotation});
  if (clip.push) document["push"] = push_document(*clip.push);
  return document;
}

struct LibraryView {
  std::string path;
  database::ClipLibrary library;

  explicit LibraryView(const std::string& file)
      : path(file), library(database::load_library(file)) {}
};

Json library_document(const LibraryView& view) {
  const database::ClipLibrary& library = view.library;
  Json clips = Json::array();
  for (const motion::Clip& clip : library.clips) clips.push_back(clip_document(clip));
  Json joints = Json::array();
  for (const motion::Role role : motion::kRoles) joints.push_back(motion::name_of(role));
  return {{"kind", "library"},
          {"name", library.name},
          {"hash", database::hash_text(library.hash)},
          {"provenance", provenance_document(library.provenance, view.path)},
          {"rate_hz", shortest(library.rate_hz)},
          {"mass_kg", shortest(library.character.mass_kg)},
          {"sex", motion::name_of(library.character.sex)},
          {"idle", library.idle_clip().name},
          {"joints", joints},
          {"clips", clips}};
}

/// Of a push: place, direction, speed, contact and peak.
std::vector<std::string> push_cells(const motion::Push& push) {
  return {std::string(motion::push_place_name(push.place)),
          fixed(motion::degrees(double{push.direction}), 0),
          fixed(double{push.velocity.norm()}, 2) + " m/s",
          fixed(double{push.contact_s}, 2),
          fixed(double{push.peak_s}, 2),
          "-"};
}

std::vector<std::string> annotation_cells(const std::optional<motion::Annotation>& annotation) {
  if (!annotation) return {"-", "-", "-", "-", "-", "-"};
  return {std::string(motion::name_of(annotation->target)),
          fixed(motion::degrees(double{annotation->direction}), 0),
          std::string(motion::name_of(annotation->degree)),
          fixed(double{annotation->onset_s}, 2),
          fixed(double{annotation->peak_s}, 2),
          fixed(double{annotation->end_s}, 2)};
}

/// Of what a clip answers.
std::vector<std::string> answer_cells(const motion::Clip& clip) {
  return clip.push ? push_cells(*clip.push) : annotation_cells(clip.annotation);
}

void print_library(const LibraryView& view) {
  const database::ClipLibrary& library = view.library;
  Table table({{"clip"},
               {"purpose"},
               {"length, s", right},
               {"target"},
               {"direction", right},
               {"degree"},
               {"onset, s", right},
               {"peak, s", right},
               {"end, s", right}});
  for (const motion::Clip& clip : library.clips) {
    std::vector<std::string> cells{clip.name, std::string(motion::name_of(clip.purpose)),
                                   fixed(double{clip.motion.duration_s()}, 2)};
    const std::vector<std::string> annotation = answer_cells(clip);
    cells.insert(cells.end(), annotation.begin(), annotation.end());
    table.add(cells);
  }
  const std::string made_by = provenance_lines(library.provenance, view.path);
  std::cout << "library " << printable(library.name) << ", " << database::hash_text(library.hash)
            << '\n'
            << library.clips.size() << " clips at " << library.rate_hz << " Hz, idle "
            << printable(library.idle_clip().name) << ", " << motion::name_of(library.character.sex)
            << " of " << library.character.mass_kg << " kg\n"
            << made_by << '\n'
            << table.text();
}

/// Statistics of a store, for both JSON and text.
struct StoreView {
  explicit StoreView(const std::string& store)
      : path(store),
        summary(train::summarise_store(store)),
        contents(train::count_contents(store)) {}

  /// Size without the library.
  double bytes_per_scenario() const {
    return static_cast<double>(contents.bytes - summary.header.library_file.size()) /
           static_cast<double>(std::max<std::uint64_t>(summary.observation_count, 1));
  }
  double non_zero_share() const {
    return static_cast<double>(contents.impulses) /
           static_cast<double>(motion::kBodyCount * std::max<std::uint64_t>(contents.trials, 1));
  }

  std::string path;
  train::StoreSummary summary;
  train::StoreContents contents;
};

Json store_document(const StoreView& view) {
  const train::StoreSummary& store = view.summary;
  const train::StoreHeader& header = store.header;
  Json clips = Json::array();
  for (std::size_t i = 0; i < header.clips.size(); ++i) {
    clips.push_back({{"name", header.clips[i].name},
                     {"work_j", header.clip_work_j[i]},
                     {"annotation", to_json(header.clips[i])}});
  }
  return {{"kind", "store"},
          {"hash", database::hash_text(view.contents.hash)},
          {"provenance", provenance_document(header.provenance, view.path)},
          {"first", store.range.first},
          {"scenarios", store.observation_count},
          {"trials", view.contents.trials},
          {"non_zero_impulse_share", view.non_zero_share()},
          {"keeps_places", header.keeps_places},
          {"places", view.contents.places},
          {"bytes", view.contents.bytes},
          {"bytes_per_scenario", view.bytes_per_scenario()},
          {"seed", header.seed},
          {"library", header.library_name},
          {"library_hash", database::hash_text(header.library_hash)},
          {"distribution", description(header.distribution, view.path, train::kDamagedStore)},
          {"simulation", description(header.simulation, view.path, train::kDamagedStore)},
          {"reference_impulse_ns", header.reference_impulse_ns},
          {"reference_work_j", header.reference_work_j},
          {"idle", header.clips[static_cast<std::size_t>(header.idle)].name},
          {"clips", clips}};
}

void print_store(const StoreView& view) {
  const train::StoreSummary& store = view.summary;
  const train::StoreHeader& header = store.header;
  Table table({{"clip"}, {"work, J", right}, {"target"}, {"direction", right}, {"degree"}});
  for (std::size_t i = 0; i < header.clips.size(); ++i) {
    const std::vector<std::string> annotation = annotation_cells(header.clips[i].annotation);
    table.add({header.clips[i].name, fixed(header.clip_work_j[i], 1), annotation[0], annotation[1],
               annotation[2]});
  }
  const std::string made_by = provenance_lines(header.provenance, view.path);
  std::cout << "store of " << store.observation_count << " scenarios from number "
            << store.range.first << ", seed " << header.seed << ", of library "
            << printable(header.library_name) << ", " << database::hash_text(header.library_hash)
            << '\n'
            << view.contents.trials << " trials, " << fixed(100 * view.non_zero_share(), 1)
            << " % of their impulses are not zero"
            << (header.keeps_places ? ", at " + std::to_string(view.contents.places) + " places"
                                    : "")
            << "; " << fixed(static_cast<double>(view.contents.bytes) / 1e6, 1) << " MB, "
            << fixed(view.bytes_per_scenario(), 0)
            << " bytes per scenario without the library\nhash "
            << database::hash_text(view.contents.hash) << '\n'
            << made_by << "distribution " << printable(header.distribution) << "\nsimulation "
            << printable(header.simulation) << "\n\n"
            << table.text();
}

void print_source(const database::SourceReport& source) {
  std::cout << source_text(source);
}

template <class Content, class Document, class Print>
void show(const InfoOptions& options, const Content& content, Document document, Print print_text) {
  if (options.json) {
    print(document(content));
  } else {
    print_text(content);
  }
}

Json document_with_quality(const LibraryView& view) {
  Json document = library_document(view);
  document["quality"] = quality_document(view.library);
  return document;
}

void draw_pain(const InfoOptions& options) {
  const motion::Physique character = database::load_library(options.file).character;
  database::write_file_atomically(
      *options.pain, evolve::pain_svg(motion::make_figure(character), evolve::thesis_pain()));
}

void run_info(const InfoOptions& options) {
  using database::FileKind;
  if (options.pain)
    database::check_outputs({{*options.pain, FileKind::text, evolve::kPainDrawingMark}},
                            {options.file}, overwrite_of(options.force));
  const FileKind kind = train::file_kind_at(options.file);
  if (options.bvh.given() && !database::holds_motion(kind))
    throw Error(options.file,
                "is " + std::string(database::name_of(kind)) +
                    ", and the options for motion capture are not for it; leave them out");
  if (options.quality && kind != FileKind::library)
    throw Error(options.file, "is " + std::string(database::name_of(kind)) +
                                  ", and --quality is for libraries; leave it out");
  if (options.pain && kind != FileKind::library)
    throw Error(options.file, "is " + std::string(database::name_of(kind)) +
                                  ", and --pain is for libraries; leave it out");
  switch (kind) {
    case FileKind::library:
      if (options.pain) draw_pain(options);
      if (options.quality)
        return show(options, LibraryView(options.file), document_with_quality,
                    [](const LibraryView& view) { std::cout << quality_text(view.library); });
      return show(options, LibraryView(options.file), library_document, print_library);
    case FileKind::store:
      return show(options, StoreView(options.file), store_document, print_store);
    case FileKind::selector:
      return show(options, SelectorView(options.file), selector_document, print_selector);
    case FileKind::bvh:
    case FileKind::fbx:
    case FileKind::gltf:
      return show(options, database::inspect_source(options.file, source_options(options.bvh)),
                  source_document, print_source);
    default:
      throw Error(options.file,
                  "is " + std::string(database::name_of(kind)) +
                      "; info reads libraries, stores, selectors and BVH, FBX and glTF files");
  }
}

}  // namespace

Command info_command() {
  auto options = std::make_shared<InfoOptions>();
  return {
      .name = "info",
      .summary =
          "Show what a library, store or selector holds, or how a motion capture file's joints are "
          "mapped",
      .required = {{"FILE", "a library, store, selector, or a BVH, FBX or glTF file",
                    &options->file}},
      .optional = join(
          {bvh_options(options->bvh),
           {{"--quality", "measure how human-like each clip of a library is", &options->quality},
            {"--pain", "SVG file to draw where a blow hurts how much, on the figure of a library",
             &options->pain},
            force_option(options->force),
            json_option(options->json)}}),
      .notes = "Example:\n  flinch info real.flinchlib\n  flinch info default.flinchlib --quality",
      .run = [options] { run_info(*options); }};
}

}  // namespace flinch::program
