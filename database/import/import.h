// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/import/foot_drift.h"
#include "database/import/source_motion.h"
#include "database/library/library.h"

namespace flinch::database {

/// What the command line may fix for a whole import; a manifest's [source] tables win over
/// `source`.
struct ImportOptions {
  std::optional<float> rate_hz;         ///< none: the manifest's, else 60
  std::optional<std::string> skeleton;  ///< without a manifest: the file whose skeleton to use
  SourceOptions source;
};

/// How one clip came out.
struct ClipReport {
  std::string name;
  motion::Purpose purpose = motion::Purpose::anticipation;
  std::string source;
  float duration_s = 0;
  bool is_annotated = false;
  FootDrift drift;
};

/// A file that was left out, and why.
struct SkippedFile {
  std::string path;
  std::string reason;
};

/// What an import has to tell. Mirrored clips are not listed: they are as their originals.
struct ImportReport {
  std::vector<SourceReport> sources;  ///< every file used, in the order of first use
  std::vector<ClipReport> clips;
  std::vector<SkippedFile> skipped;
  std::vector<std::string> warnings;
};

struct ImportResult {
  ClipLibrary library;
  ImportReport report;
};

/// Makes a library of motion capture.
///
/// With a manifest, its entries become the clips; their files are looked for in the folders of
/// `paths`, then in the manifest's own. Annotated clips come a second time, mirrored. The first
/// [[idle]] is the library's idle clip.
///
/// Without one, every BVH file of `paths` (files, and folders with all below them, in alphabetical
/// order) becomes one unannotated clip, named after its file. The first whose name contains "idle"
/// is the idle clip, else the first; its skeleton is the library's unless the options name another.
/// Files found in folders that cannot be used are skipped and reported; a file that was named
/// itself is an error.
///
/// Files with the same skeleton share the reference pose of the one that stands best. Throws Error.
ImportResult import_library(const std::vector<std::string>& paths,
                            const std::optional<std::string>& manifest_path,
                            const ImportOptions& options = {});

/// What import would make of a BVH file: units, up axis, roles. Throws Error.
SourceReport inspect_bvh(const std::string& path, const SourceOptions& options = {});

}  // namespace flinch::database
