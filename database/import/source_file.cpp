// SPDX-License-Identifier: MIT
#include "database/import/source_file.h"

#include "database/files/file_io.h"
#include "database/files/file_kind.h"
#include "database/import/scene_motion.h"

namespace flinch::database {

Bvh read_source_file(const std::string& path) {
  const std::string bytes = read_file(path);
  const FileKind kind = file_kind_of(bytes);
  if (kind == FileKind::fbx || kind == FileKind::gltf) {
    Bvh bvh = scene_motion(read_scene(path));
    bvh.kind = kind;
    return bvh;
  }
  require_not_utf16(bytes, path);
  return parse_bvh(bytes, path);
}

}  // namespace flinch::database
