// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/skeleton.h"

namespace flinch::motion {

/// The part of the body that a threat aims at and a clip protects, from the top down: neighbours
/// on the body are neighbours here.
enum class Target : std::uint8_t { head, trunk, pelvis, legs };
inline constexpr int kTargetCount = 4;
/// "head", "trunk", "pelvis" or "legs".
std::string_view name_of(Target target);
std::optional<Target> target_named(std::string_view name);

/// How far a clip goes.
enum class Degree : std::uint8_t { mild, exaggerated };
std::string_view name_of(Degree degree);
std::optional<Degree> degree_named(std::string_view name);

/// What a clip protects against and when. Times are seconds from the clip's first pose and obey
/// 0 <= onset < peak <= end <= duration.
struct Annotation {
  Target target = Target::head;
  /// Where the threat comes from, radians counter-clockwise from the character's facing, a multiple
  /// of pi/4 in (-pi, pi].
  float direction = 0;
  Degree degree = Degree::mild;
  float onset_s = 0;  ///< when the protective movement begins
  float peak_s = 0;   ///< when it protects most
  float end_s = 0;    ///< when it is over
};

/// What a clip is to its library.
enum class Purpose : std::uint8_t {
  anticipation,  ///< may answer a threat if annotated
  idle,          ///< standing, from which responses start
  push,          ///< recovery from a push; kept for reactions
};
std::string_view name_of(Purpose purpose);

/// Poses at a fixed rate. Pose k is at k / rate_hz seconds.
struct Motion {
  float rate_hz = 60;
  std::vector<Pose> poses;  ///< at least one

  float duration_s() const { return static_cast<float>(poses.size() - 1) / rate_hz; }
};

/// The pose at `time_s`, interpolated between the two nearest; clamped to the first and last.
/// Where `roles` are not all, the rotations of others are not set.
Pose sample(const Motion& motion, float time_s, std::span<const Role> roles = kRoles);

/// The pose at `time_s` of a motion that goes back and forth for ever: it turns round at either
/// end, so it never jumps. `roles` as in sample().
Pose sample_ping_pong(const Motion& motion, float time_s, std::span<const Role> roles = kRoles);

/// The stored pose at or before the time: sample() and sample_ping_pong() take the signs of its
/// rotations, of the two that quaternions have.
const Pose& pose_before(const Motion& motion, float time_s);
const Pose& pose_before_ping_pong(const Motion& motion, float time_s);

/// A recorded or authored motion with what is known about it.
struct Clip {
  std::string name;
  Purpose purpose = Purpose::anticipation;
  std::string kind;                      ///< "block", "duck", …, free text
  std::string source;                    ///< file that it came from, or how it was authored
  std::optional<Annotation> annotation;  ///< none: unannotated, never in the mask
  std::string mirrored_from;             ///< name of the clip that this one mirrors; empty if none
  Motion motion;
};

}  // namespace flinch::motion
