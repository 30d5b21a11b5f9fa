// SPDX-License-Identifier: MIT
#include "runtime/prepared_library.h"

namespace flinch::runtime {

PreparedLibrary prepare(const database::Library& library) {
  PreparedLibrary prepared;
  prepared.library = &library;
  prepared.bodies = motion::make_body_model(library.character);
  const motion::Skeleton& skeleton = library.character.skeleton;
  for (motion::Side side : motion::kSides) {
    prepared.soles[motion::index_of(side)] = make_sole(skeleton, side);
  }
  prepared.footwork.reserve(library.clips.size());
  for (const motion::Clip& clip : library.clips) {
    prepared.footwork.push_back(footwork_of(skeleton, prepared.bodies, prepared.soles, clip));
  }
  return prepared;
}

}  // namespace flinch::runtime
