// SPDX-License-Identifier: MIT
#pragma once

#include "motion/clip.h"

namespace flinch::motion {

/// `times` repetitions of a move; negative ones go back.
PlanarMove repeated(const PlanarMove& move, int times);

/// A motion that repeats without end. Refers to the motion, which must outlive it and have at least
/// one pose.
class Loop {
 public:
  /// Refers to nothing.
  Loop() = default;
  /// Plays forwards and backwards in turn, so that it never jumps.
  Loop(const Motion& motion) : motion_(&motion) {}
  /// Plays in cycles: where the motion ends it begins anew, moved along the ground by travel().
  static Loop in_cycles(const Motion& motion);

  const Motion& motion() const { return *motion_; }
  /// Whether it repeats in cycles, not back and forth.
  bool has_cycles() const { return has_cycles_; }
  /// Time after which it repeats, s; 0 for a single pose.
  float period_s() const;
  /// By how much each cycle begins farther along than the one before; none for back and forth.
  const PlanarMove& travel() const { return travel_; }
  /// Whether a cycle moves by more than 2 cm or turns by more than 2 degrees.
  bool travels() const;
  /// The number of whole cycles before a time; 0 for back and forth.
  int cycles_before(float time_s) const;

 private:
  const Motion* motion_ = nullptr;
  bool has_cycles_ = false;
  PlanarMove travel_;
};

/// The pose at `time_s`, which may be negative. Sets the rotations of `roles` only.
Pose sample(const Loop& loop, float time_s, std::span<const Role> roles = kRoles);

/// The stored pose at or before the time, without travel(): for the signs of sample()'s rotations.
const Pose& pose_before(const Loop& loop, float time_s);

/// How far a motion is from repeating in cycles: what remains between its last pose, moved back to
/// the first, and the first pose.
struct LoopGap {
  float height_m = 0;         ///< of the pelvis
  float angle = 0;            ///< of the joint that differs most, radians
  Role joint = Role::pelvis;  ///< which that is
};
LoopGap loop_gap(const Motion& motion);

/// Gaps that are not seen: a motion with no more than these loops.
inline constexpr float kMaxLoopGap_m = 1e-3F;
inline constexpr float kMaxLoopGap = 5e-3F;  ///< radians

}  // namespace flinch::motion
