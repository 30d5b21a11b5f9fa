// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/import/foot_drift.h"
#include "database/import/source_motion.h"
#include "database/library/library.h"

namespace flinch::database {

/// Options for a whole import. A manifest's [source] tables override `source`.
struct ImportOptions {
  std::optional<float> rate_hz;         ///< none: the manifest's, or 60 without one
  std::optional<std::string> skeleton;  ///< without a manifest: the file whose skeleton to use
  SourceOptions source;
};

/// Result of importing one clip.
struct ClipReport {
  std::string name;
  motion::Purpose purpose = motion::Purpose::anticipation;
  std::string source;
  float duration_s = 0;
  bool is_annotated = false;
  FootDrift drift;
  std::vector<std::string> warnings;  ///< of judge_motion
};

/// A file that was skipped, with the reason.
struct SkippedFile {
  std::string path;
  std::string reason;      ///< one line
  std::string suggestion;  ///< RoleError::suggestion; may be empty
};

/// Thrown where an import finds BVH files and can use none of them. what() is one line;
/// `suggestion` is that of the first file that has one.
class UnusableFiles : public RoleError {
 public:
  /// `where` is the folder that was searched; `files` holds at least one.
  UnusableFiles(const std::string& where, std::vector<SkippedFile> files);
  std::vector<SkippedFile> skipped;
};

/// Results of an import. Mirrored clips are not listed: their results equal their originals'.
struct ImportReport {
  std::vector<SourceReport> sources;  ///< every file used, in the order of first use
  std::vector<ClipReport> clips;
  std::vector<SkippedFile> skipped;
  std::vector<std::string> warnings;
  float default_rate_hz = 60;  ///< without ImportOptions::rate_hz
};

struct ImportResult {
  ClipLibrary library;
  ImportReport report;
};

/// Makes a library from motion capture.
///
/// With a manifest, its entries become the clips; their files are searched in the folders of
/// `paths`, then in the manifest's own folder. For each annotated clip, a mirrored one is added.
/// The first [[idle]] is the library's idle clip.
///
/// Without a manifest, every BVH, FBX or glTF file of `paths` (files, and folders searched
/// recursively, in alphabetical order) becomes one unannotated clip, named after its file. The idle
/// clip is the first whose name contains "idle", or the first clip if there is none; its skeleton
/// is the library's unless the options name another. Unusable files found in folders are skipped
/// and reported; an unusable file in `paths` itself is an error. UnusableFiles is
/// thrown where none is left.
///
/// Files with the same skeleton share the reference pose of the file that stands best. Throws
/// Error.
ImportResult import_library(const std::vector<std::string>& paths,
                            const std::optional<std::string>& manifest_path,
                            const ImportOptions& options = {});

/// Returns every path at which import_library may look for a file that the manifest names. Throws
/// Error as it does.
std::vector<std::string> manifest_files(const std::vector<std::string>& paths,
                                        const std::string& manifest_path);

/// Returns what an import would detect in a file: units, up axis, roles, and in its warnings
/// all that is odd in the motion of the whole file. Throws Error.
SourceReport inspect_source(const std::string& path, const SourceOptions& options = {});

}  // namespace flinch::database
