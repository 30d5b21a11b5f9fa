// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "database/library.h"
#include "features/geometry.h"
#include "features/impact_prediction.h"
#include "runtime/footwork.h"

namespace flinch::runtime {

/// A library with what responses need to know of it, worked out once. Refers to the library, which
/// must outlive it and stay as it is. Immutable: any number of characters and threads share one.
struct PreparedLibrary {
  const database::Library* library = nullptr;
  motion::BodyModel bodies;
  motion::PerSide<Sole> soles;
  std::vector<Footwork> footwork;  ///< one a clip
  features::Sway sway;             ///< of the idle clip
  float reach_m = 0;               ///< see features::SweptFigure
  motion::PerBody<float> body_reach_m{};

  const motion::Skeleton& skeleton() const { return library->character.skeleton; }
  const motion::Clip& clip(int index) const {
    return library->clips[static_cast<std::size_t>(index)];
  }
  const motion::Motion& idle() const { return clip(library->idle).motion; }
  features::SweptFigure figure() const { return {&skeleton(), &bodies, reach_m, body_reach_m}; }
  features::IdlingFigure idling() const { return {&skeleton(), &bodies, &idle()}; }
};

/// Prepares a library. Allocates; not for every frame.
PreparedLibrary prepare(const database::Library& library);

}  // namespace flinch::runtime
