// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "database/library/library.h"
#include "features/geometry.h"
#include "features/impact_prediction.h"
#include "motion/joint_limits.h"
#include "runtime/response/footwork.h"
#include "runtime/response/prepared_stance.h"

namespace flinch::runtime {

/// A library with precomputed data for responses. Refers to the library, which must outlive it and
/// not change. Immutable: any number of characters and threads share one.
struct PreparedLibrary {
  const database::ClipLibrary* library = nullptr;
  motion::BodyModel body_model;
  motion::PerSide<Sole> soles;
  std::vector<Footwork> footwork;       ///< one per clip
  std::vector<PreparedStance> stances;  ///< database::stance_clips; empty if the idle has no poses
  float reach_m = 0;                    ///< see features::CollisionFigure
  motion::PerBody<float> body_reach_m{};
  std::span<const motion::JointLimits> joint_limits;  ///< human ones
  struct LegLimits {
    const motion::JointLimits* hip = nullptr;
    const motion::JointLimits* ankle = nullptr;
  };
  motion::PerSide<LegLimits> leg_limits;  ///< those among joint_limits that feet may strain

  /// Of both hands; null for other roles.
  motion::PerRole<const motion::JointLimits*> wrist_limits{};

  const motion::Skeleton& skeleton() const { return library->character.skeleton; }
  const motion::Clip& clip(int index) const { return library->clip(index); }
  const motion::Motion& idle() const { return library->idle_clip().motion; }
  /// The idle clip for a stance that the library does not have.
  const PreparedStance& stance_of(const features::CharacterState& state) const {
    return stances[has_stance(state.stance) ? static_cast<std::size_t>(state.stance) : 0];
  }
  /// Where a character of that stance stands still: in it, or in the idle clip if it travels.
  const PreparedStance& rest_of(const features::CharacterState& state) const {
    const PreparedStance& stance = stance_of(state);
    return stance.loop.travels() ? stances.front() : stance;
  }
  bool has_stance(int stance) const {
    return stance >= 0 && static_cast<std::size_t>(stance) < stances.size();
  }
  features::CollisionFigure figure() const {
    return {&skeleton(), &body_model, reach_m, body_reach_m};
  }
  features::IdlingFigure figure_in(const features::CharacterState& state) const {
    return {&skeleton(), &body_model, stance_of(state).loop};
  }
};

/// Prepares a library. Allocates, so do not call it every frame. `footwork` is that of its clips
/// where a file has it, which saves much of the time; none: it is computed, to the same bits.
PreparedLibrary prepare(const database::ClipLibrary& library, std::vector<Footwork> footwork = {});

}  // namespace flinch::runtime
