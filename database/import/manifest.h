// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/import/source_character.h"
#include "database/import/source_motion.h"
#include "motion/clip.h"

namespace flinch::database {

/// The lowest frame rate that a library of motion capture may have, Hz; the highest is kMaxRate_hz.
inline constexpr double kMinImportRate_hz = 10;

/// What a [[push]] says of its push. What it leaves out is measured.
struct PushEntry {
  std::optional<double> contact_s;  ///< from the start of the file
  std::optional<float> direction;   ///< see motion::Push
  motion::Role place = motion::Role::chest;
};

/// One [[idle]], [[clip]], [[push]] or [[stance]]. Times are seconds from the start of its file.
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
  std::optional<PushEntry> push;  ///< of a [[push]]
  std::string where;              ///< "FILE:LINE" of the manifest, for messages
};

/// Whether the entry's clip is added a second time, mirrored, as NAME_mirrored: annotated clips and
/// pushes, which come from either side.
bool is_mirrored(const ManifestEntry& entry);

/// [source."folder or file"]: options for the files that it names.
struct ManifestSource {
  std::string path;  ///< a file, or a folder that holds it, as entries write it
  SourceOptions options;
  std::string where;  ///< "FILE:LINE" of the manifest, for messages
};

/// Content of a manifest. Its format is documented in docs/importing.md.
struct Manifest {
  std::string path;
  std::string name;
  std::optional<float> rate_hz;
  std::string skeleton;        ///< file whose skeleton the library uses
  std::string skeleton_where;  ///< "FILE:LINE"
  CharacterOptions character;
  std::vector<ManifestEntry> entries;  ///< idles first, then clips, pushes and stances
  std::vector<ManifestSource> sources;
};

/// Reads and checks a manifest, but not the files that it names. Throws Error "FILE:LINE: …" for
/// anything unknown, missing, repeated, of the wrong type or out of range.
Manifest read_manifest(const std::string& path);

/// Whether the options are for this file: it is the one that they name, or in that folder.
bool covers(const ManifestSource& source, const std::string& file);

/// Returns the manifest's options for a file. Where several [source] tables name it or a folder
/// above it, the longest path wins.
SourceOptions options_for(const Manifest& manifest, const std::string& file);

}  // namespace flinch::database
