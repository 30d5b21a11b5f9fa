// SPDX-License-Identifier: MIT
#include "database/import/import.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "database/files/pose_packer.h"
#include "database/files/provenance.h"
#include "database/files/text_encoding.h"
#include "database/files/toml_string.h"
#include "database/import/loop_closing.h"
#include "database/import/manifest.h"
#include "database/import/plausibility.h"
#include "database/import/source_file.h"
#include "database/library/library_check.h"
#include "motion/error.h"
#include "motion/mirror.h"
#include "motion/push_measurement.h"

namespace flinch::database {
namespace {

namespace fs = std::filesystem;

constexpr float kDefaultRate = 60;  // Hz

std::string seconds(double time_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f s", time_s);
  return text;
}

// A file's motion, computed once for all clips that are cut from it.
struct LoadedSource {
  Source source;
  SourceMotion motion;
};

// All files of an import by the path that they were opened with, in the order of first use.
class SourceSet {
 public:
  // Throws Error.
  void add(const std::string& path, const SourceOptions& options) {
    if (index_.contains(path)) return;
    loaded_.push_back({analyse_source(read_source_file(path), options), {}});
    index_[path] = loaded_.size() - 1;
  }

  // Call once all files are added: files with the same skeleton get the same reference pose.
  void finish() {
    for (LoadedSource& one : loaded_) share_reference(one.source);
    for (LoadedSource& one : loaded_) one.motion = source_motion(one.source);
  }

  const LoadedSource& at(const std::string& path) const { return loaded_[index_.at(path)]; }
  const std::vector<LoadedSource>& all() const { return loaded_; }

 private:
  void share_reference(Source& source) const {
    if (source.reference.frame < 0) return;
    for (const LoadedSource& other : loaded_) {
      const ReferencePose& theirs = other.source.reference;
      if (theirs.frame < 0 || theirs.doubt >= source.reference.doubt) continue;
      if (has_same_skeleton(other.source, source)) adopt_reference(source, other.source);
    }
  }

  std::vector<LoadedSource> loaded_;
  std::map<std::string, std::size_t> index_;
};

// Finds an entry's file: searches the folders in order.
std::string resolved(const std::string& file, const std::vector<fs::path>& folders,
                     const std::string& where) {
  if (fs::path(file).is_absolute() && fs::exists(file)) return file;
  std::string tried;
  for (const fs::path& folder : folders) {
    const fs::path path = (folder / file).lexically_normal();
    if (fs::exists(path)) return path.string();
    tried += (tried.empty() ? "" : ", ") + folder.string();
  }
  throw Error(where, "the file \"" + file + "\" is in none of: " + tried);
}

std::vector<fs::path> folders_of(const std::vector<std::string>& paths,
                                 const std::string& manifest_path) {
  std::vector<fs::path> folders;
  for (const std::string& path : paths) {
    if (!fs::exists(path)) throw Error(path, "there is no such file or folder");
    folders.push_back(fs::is_directory(path) ? fs::path(path) : fs::path(path).parent_path());
  }
  folders.push_back(fs::path(manifest_path).parent_path());
  for (fs::path& folder : folders) {
    if (folder.empty()) folder = ".";
  }
  folders.erase(std::unique(folders.begin(), folders.end()), folders.end());
  return folders;
}

// Returns the part of the source between the entry's times, which count from the beginning of the
// file; times less than a frame outside the source are clamped.
Segment segment_of(const ManifestEntry& entry, const SourceMotion& source, float rate_hz) {
  const double duration = source.duration_s();
  const double slack = source.frame_time_s;
  Segment segment{entry.start_s.value_or(source.start_s) - source.start_s,
                  entry.end_s.value_or(source.start_s + duration) - source.start_s, entry.heading};
  if (segment.start_s < -slack || segment.start_s > duration || segment.end_s < 0 ||
      segment.end_s > duration + slack) {
    const std::string whole = "which lasts " + seconds(duration);
    const std::string part = "of which the frames from " + seconds(source.start_s) + " to " +
                             seconds(source.start_s + duration) + " are used";
    throw Error(entry.where, "[" + seconds(source.start_s + segment.start_s) + ", " +
                                 seconds(source.start_s + segment.end_s) + "] is outside \"" +
                                 entry.file + "\", " + (source.start_s > 0 ? part : whole));
  }
  segment.start_s = std::max(segment.start_s, 0.0);
  segment.end_s = std::min(segment.end_s, duration);
  check_frame_count(entry.where, segment, rate_hz);
  return segment;
}

// Converts times in the source to times in the clip.
motion::Annotation annotation_in(const ManifestEntry& entry, double start_s, float duration_s) {
  motion::Annotation annotation = *entry.annotation;
  const auto start = static_cast<float>(start_s);
  annotation.onset_s = std::max(annotation.onset_s - start, 0.0F);
  annotation.peak_s = std::min(annotation.peak_s - start, duration_s);
  annotation.end_s = duration_s;
  if (annotation.onset_s >= annotation.peak_s) {
    throw Error(entry.where, "the peak of \"" + entry.name +
                                 "\" is not after its onset within the file's duration");
  }
  return annotation;
}

// Converts the time in the source to a time in the clip, and measures what the entry leaves open.
std::optional<motion::Push> push_in(const PushEntry& entry, double start_s,
                                    const motion::Skeleton& skeleton,
                                    const motion::Motion& motion) {
  motion::PushNotes notes{.contact_s = {}, .direction = entry.direction, .place = entry.place};
  if (entry.contact_s)
    notes.contact_s = static_cast<float>(std::max(*entry.contact_s - start_s, 0.0));
  return motion::measure_push(skeleton, motion, notes);
}

void add_clip(const ManifestEntry& entry, const LoadedSource& loaded, const motion::Figure& figure,
              ImportResult& result) {
  ClipLibrary& library = result.library;
  const motion::Skeleton& skeleton = library.character.skeleton;
  const Segment segment = segment_of(entry, loaded.motion, library.rate_hz);
  motion::Clip clip;
  clip.name = entry.name;
  clip.purpose = entry.purpose;
  clip.kind = entry.kind;
  clip.source = printable_text(entry.file);
  clip.motion = retarget(loaded.motion, skeleton, segment, library.rate_hz);
  if (entry.annotation) {
    clip.annotation =
        annotation_in(entry, loaded.motion.start_s + segment.start_s, clip.motion.duration_s());
  }
  if (entry.purpose == motion::Purpose::stance) clip.motion = closed_loop(clip.motion, entry.where);
  snap(clip.motion);
  if (entry.push) {
    clip.push =
        push_in(*entry.push, loaded.motion.start_s + segment.start_s, skeleton, clip.motion);
  }
  const JudgedClip judged{loaded.source, loaded.motion, segment, figure, clip};
  require_near(entry.where, judged);
  result.report.clips.push_back(
      {clip.name, clip.purpose, clip.source, clip.motion.duration_s(), clip.annotation.has_value(),
       measure_foot_drift(loaded.motion, skeleton, segment, clip.motion), judge_motion(judged)});
  if (entry.push && !clip.push) {
    result.report.clips.back().warnings.push_back(
        "nothing moves as if pushed, so it answers no push; say when with contact = SECONDS");
  }
  library.clips.push_back(clip);
  if (is_mirrored(entry)) {
    library.clips.push_back(motion::mirrored(clip));
    snap(library.clips.back().motion);
  }
}

void warn_of_unannotated(ImportReport& report) {
  std::string names;
  int count = 0;
  for (const ClipReport& clip : report.clips) {
    if (clip.purpose != motion::Purpose::anticipation || clip.is_annotated) continue;
    names += (count++ == 0 ? "" : ", ") + clip.name;
  }
  if (count == 0) return;
  report.warnings.push_back(std::to_string(count) +
                            " clips are not annotated and will not answer threats: " + names);
}

// Paths in [source] tables are as entries write them; another spelling covers no file.
void warn_of_unused_options(const Manifest& manifest, ImportReport& report) {
  for (const ManifestSource& source : manifest.sources) {
    const auto is_covered = [&](const ManifestEntry& entry) { return covers(source, entry.file); };
    if (covers(source, manifest.skeleton) || std::ranges::any_of(manifest.entries, is_covered)) {
      continue;
    }
    report.warnings.push_back(source.where + ": [source.\"" + printable_text(source.path) +
                              "\"] is for none of the manifest's files; write its path as they do");
  }
}

// The common part of both kinds of import. `paths[i]` is the path of entry i's file.
ImportResult build(const Manifest& manifest, const std::vector<std::string>& paths,
                   const std::string& skeleton_path, const SourceSet& sources, float rate_hz) {
  ImportResult result;
  result.library.name = manifest.name;
  result.library.rate_hz = rate_hz;
  result.library.character = character_of(sources.at(skeleton_path).source, manifest.character);
  if (const char* what = fault_of(result.library.character)) {
    throw Error(skeleton_path, std::string(what) +
                                   "; say the unit with --unit, or correct the roles with --roles");
  }
  const motion::Figure figure = motion::make_figure(result.library.character);
  for (std::size_t i = 0; i < manifest.entries.size(); ++i) {
    add_clip(manifest.entries[i], sources.at(paths[i]), figure, result);
  }
  for (const LoadedSource& one : sources.all()) {
    result.report.sources.push_back(one.source.report);
  }
  warn_of_unused_options(manifest, result.report);
  warn_of_unannotated(result.report);
  return result;
}

ImportResult import_with_manifest(const std::vector<std::string>& paths,
                                  const std::string& manifest_path, const ImportOptions& options) {
  Manifest manifest = read_manifest(manifest_path);
  if (manifest.name.empty()) manifest.name = fs::path(manifest_path).stem().string();
  const std::vector<fs::path> folders = folders_of(paths, manifest_path);
  SourceSet sources;
  const auto add = [&](const std::string& file, const std::string& where) {
    const std::string path = resolved(file, folders, where);
    SourceOptions own = options_for(manifest, file);
    if (own.rest) own.rest = resolved(*own.rest, folders, where);
    sources.add(path, merged(options.source, own));
    return path;
  };
  const std::string skeleton = add(manifest.skeleton, manifest.skeleton_where);
  std::vector<std::string> entry_paths;
  for (const ManifestEntry& entry : manifest.entries) {
    entry_paths.push_back(add(entry.file, entry.where));
  }
  sources.finish();
  const float default_rate = manifest.rate_hz.value_or(kDefaultRate);
  ImportResult result =
      build(manifest, entry_paths, skeleton, sources, options.rate_hz.value_or(default_rate));
  result.report.default_rate_hz = default_rate;
  return result;
}

bool is_source_file(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".bvh" || extension == ".fbx" || extension == ".glb" || extension == ".gltf";
}

struct FoundFile {
  std::string path;
  std::string source;     // within the folder in which it was found, so that libraries of the same
                          // files are the same wherever they are
  std::string name;       // of its clip
  bool was_named = true;  // false: found in a folder
};

// Files of the same name get another one.
void rename_twins(std::vector<FoundFile>& files, std::string FoundFile::*other) {
  std::map<std::string, int> count;
  for (const FoundFile& file : files) ++count[file.name];
  for (FoundFile& file : files) {
    if (count[file.name] > 1)
      file.name = fs::path(file.*other).replace_extension().generic_string();
  }
}

std::vector<FoundFile> find_files(const std::vector<std::string>& paths) {
  std::vector<FoundFile> files;
  for (const std::string& path : paths) {
    if (!fs::exists(path)) throw Error(path, "there is no such file or folder");
    if (!fs::is_directory(path)) {
      const fs::path file(path);
      files.push_back({path, file.filename().string(), file.stem().string(), true});
      continue;
    }
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
      if (entry.is_regular_file() && is_source_file(entry.path())) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    for (const fs::path& one : found) {
      const std::string source = one.lexically_relative(path).generic_string();
      files.push_back({one.string(), source, one.stem().string(), false});
    }
  }
  rename_twins(files, &FoundFile::source);
  rename_twins(files, &FoundFile::path);
  return files;
}

ManifestEntry whole_file(const FoundFile& file) {
  ManifestEntry entry;
  entry.name = printable_text(file.name);
  entry.file = file.source;
  entry.where = file.path;
  return entry;
}

ManifestEntry& idle_of(std::vector<ManifestEntry>& entries) {
  const auto is_idle = [](const ManifestEntry& entry) {
    return entry.name.find("idle") != std::string::npos;
  };
  const auto found = std::find_if(entries.begin(), entries.end(), is_idle);
  return found == entries.end() ? entries.front() : *found;
}

// The last part of a path, however it is spelled.
std::string name_of_path(const std::string& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  const fs::path last = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
  return printable_text(fs::path(last).replace_extension().string());
}

ImportResult import_without_manifest(const std::vector<std::string>& paths,
                                     const ImportOptions& options) {
  const std::vector<FoundFile> files = find_files(paths);
  if (files.empty()) {
    throw Error(paths.empty() ? "" : paths.front(),
                "there are no BVH, FBX or glTF files to import");
  }
  SourceSet sources;
  Manifest manifest;
  manifest.name = name_of_path(paths.front());
  if (manifest.name.empty()) manifest.name = "library";
  std::vector<std::string> entry_paths;
  std::vector<SkippedFile> skipped;
  for (const FoundFile& file : files) {
    try {
      sources.add(file.path, options.source);
    } catch (const RoleError& error) {
      if (file.was_named || files.size() == 1) throw;
      skipped.push_back({file.path, error.what(), error.suggestion});
      continue;
    } catch (const Error& error) {
      if (file.was_named || files.size() == 1) throw;
      skipped.push_back({file.path, error.what(), ""});
      continue;
    }
    manifest.entries.push_back(whole_file(file));
    entry_paths.push_back(file.path);
  }
  if (manifest.entries.empty()) throw UnusableFiles(paths.front(), std::move(skipped));

  ManifestEntry& idle = idle_of(manifest.entries);
  idle.purpose = motion::Purpose::idle;
  idle.kind = "idle";
  const std::string skeleton = options.skeleton.value_or(idle.where);
  sources.add(skeleton, options.source);
  sources.finish();
  ImportResult result =
      build(manifest, entry_paths, skeleton, sources, options.rate_hz.value_or(kDefaultRate));
  result.report.skipped = std::move(skipped);
  result.report.warnings.push_back("without a manifest, \"" + idle.name +
                                   "\" is taken for the idle clip");
  const auto is_idle = [](const motion::Clip& clip) {
    return clip.purpose == motion::Purpose::idle;
  };
  const std::vector<motion::Clip>& clips = result.library.clips;
  result.library.idle =
      static_cast<int>(std::find_if(clips.begin(), clips.end(), is_idle) - clips.begin());
  return result;
}

// Returns the first of the files with a suggestion; the end where none has one.
std::vector<SkippedFile>::const_iterator first_suggestion(const std::vector<SkippedFile>& files) {
  return std::ranges::find_if(files,
                              [](const SkippedFile& file) { return !file.suggestion.empty(); });
}

std::string none_is_usable(const std::vector<SkippedFile>& files) {
  const auto suggested = first_suggestion(files);
  return "none of its " + std::to_string(files.size()) + " motion files can be used" +
         (suggested == files.end() ? "" : "; these roles are suggested for " + suggested->path);
}

std::string suggestion_of(const std::vector<SkippedFile>& files) {
  const auto suggested = first_suggestion(files);
  return suggested == files.end() ? "" : suggested->suggestion;
}

/// The roles as a manifest has them: head="Bip01 Head".
std::string text_of(const RoleOverrides& roles) {
  std::string text;
  for (const auto& [role, joint] : roles)
    text +=
        (text.empty() ? "" : ", ") + std::string(motion::name_of(role)) + '=' + toml_string(joint);
  return text;
}

template <class Name>
std::optional<std::string_view> name_of_given(const std::optional<Name>& given) {
  return given ? std::optional(name_of(*given)) : std::nullopt;
}

std::string imported_provenance(const std::optional<std::string>& manifest,
                                const ImportOptions& options, const ImportReport& report) {
  const SourceOptions& source = options.source;
  Provenance made{.command = "import"};
  const float default_rate = report.default_rate_hz;
  add_option("rate", options.rate_hz.value_or(default_rate), default_rate, made);
  add_option("unit", name_of_given(source.unit), made);
  add_option("up", name_of_given(source.up), made);
  add_option("roles", text_of(source.roles), std::string(), made);
  add_option("rate-of-file", source.frames.rate_hz, made);
  if (source.frames.range) made.options.emplace_back("frames", text_of(*source.frames.range));
  add_option("skip-first", source.frames.skip_first, made);
  if (manifest) add_inputs("manifest", {*manifest}, made);
  if (options.skeleton) add_inputs("skeleton", {*options.skeleton}, made);
  if (source.rest) add_inputs("rest", {*source.rest}, made);
  std::vector<std::string> files;
  for (const SourceReport& used : report.sources) files.push_back(used.path);
  add_inputs("motion", files, made);
  return provenance_text(made);
}

}  // namespace

UnusableFiles::UnusableFiles(const std::string& where, std::vector<SkippedFile> files)
    : RoleError(where, none_is_usable(files), suggestion_of(files)), skipped(std::move(files)) {}

ImportResult import_library(const std::vector<std::string>& paths,
                            const std::optional<std::string>& manifest_path,
                            const ImportOptions& options) {
  ImportResult result = manifest_path ? import_with_manifest(paths, *manifest_path, options)
                                      : import_without_manifest(paths, options);
  result.library.provenance = imported_provenance(manifest_path, options, result.report);
  return result;
}

std::vector<std::string> manifest_files(const std::vector<std::string>& paths,
                                        const std::string& manifest_path) {
  const Manifest manifest = read_manifest(manifest_path);
  std::vector<std::string> names{manifest.skeleton};
  for (const ManifestEntry& entry : manifest.entries) names.push_back(entry.file);
  for (const ManifestSource& source : manifest.sources) {
    if (source.options.rest) names.push_back(*source.options.rest);
  }
  std::vector<std::string> files;
  for (const fs::path& folder : folders_of(paths, manifest_path)) {
    for (const std::string& name : names) files.push_back((folder / name).string());
  }
  return files;
}

SourceReport inspect_source(const std::string& path, const SourceOptions& options) {
  LoadedSource loaded{analyse_source(read_source_file(path), options), {}};
  loaded.motion = source_motion(loaded.source);
  const motion::Figure figure = motion::make_figure(character_of(loaded.source));
  const Segment whole{0, loaded.motion.duration_s(), 0};
  motion::Clip clip;
  // No more poses than the file has frames.
  const auto own_rate_hz = static_cast<float>(1 / loaded.motion.frame_time_s);
  clip.motion =
      retarget(loaded.motion, figure.skeleton(), whole, std::min(own_rate_hz, kDefaultRate));
  SourceReport report = loaded.source.report;
  std::ranges::move(judge_motion({loaded.source, loaded.motion, whole, figure, clip}),
                    std::back_inserter(report.warnings));
  return report;
}

}  // namespace flinch::database
