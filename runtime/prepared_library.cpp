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
  const features::SweptFigure figure = features::make_swept_figure(skeleton, prepared.bodies);
  prepared.reach_m = figure.reach_m;
  prepared.body_reach_m = figure.body_reach_m;
  const auto idle = static_cast<std::size_t>(library.idle);
  if (idle < library.clips.size() && !library.clips[idle].motion.poses.empty()) {
    prepared.sway = features::sway_of(skeleton, prepared.bodies, library.clips[idle].motion);
  }
  prepared.footwork.reserve(library.clips.size());
  for (const motion::Clip& clip : library.clips) {
    prepared.footwork.push_back(footwork_of(skeleton, prepared.bodies, prepared.soles, clip));
  }
  return prepared;
}

}  // namespace flinch::runtime
