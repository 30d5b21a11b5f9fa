// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/import/source_character.h"
#include "database/import/source_motion.h"
#include "motion/clip.h"

namespace flinch::database {

/// Frame rates that a library may have, Hz.
inline constexpr double kMinRate_hz = 10;
inline constexpr double kMaxRate_hz = 1000;

/// One [[idle]], [[clip]] or [[push]]. Times are seconds from the start of its file.
struct ManifestEntry {
  std::string name;
  std::string file;  ///< relative to one of the folders given to import, or to the manifest's
  motion::Purpose purpose = motion::Purpose::anticipation;
  std::string kind;
  std::optional<double> start_s;  ///< none: the file's
  std::optional<double> end_s;    ///< none: the file's
  double heading = 0;             ///< see Segment, radians
  /// Onset and peak are relative to the file's start; `end_s` is not set. None: unannotated.
  std::optional<motion::Annotation> annotation;
  std::string where;  ///< "FILE:LINE" of the manifest, for messages
};

/// Whether the entry's clip is added a second time, mirrored, as NAME_mirrored: annotated clips and
/// pushes, which come from either side.
bool is_mirrored(const ManifestEntry& entry);

/// [source."folder or file"]: options for the files that it names.
struct ManifestSource {
  std::string path;  ///< a file, or a folder that holds it, as entries write it
  SourceOptions options;
};

/// Content of a manifest. Its format is documented in docs/importing.md.
struct Manifest {
  std::string path;
  std::string name;
  std::optional<float> rate_hz;
  std::string skeleton;        ///< file whose skeleton the library uses
  std::string skeleton_where;  ///< "FILE:LINE"
  CharacterOptions character;
  std::vector<ManifestEntry> entries;  ///< idles first, then clips, then pushes
  std::vector<ManifestSource> sources;
};

/// Reads and checks a manifest, but not the files that it names. Throws Error "FILE:LINE: …" for
/// anything unknown, missing, repeated, of the wrong type or out of range.
Manifest read_manifest(const std::string& path);

/// Returns the manifest's options for a file. Where several [source] tables name it or a folder
/// above it, the longest path wins.
SourceOptions options_for(const Manifest& manifest, const std::string& file);

}  // namespace flinch::database
