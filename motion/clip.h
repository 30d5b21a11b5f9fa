// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/enum_array.h"
#include "motion/skeleton.h"

namespace flinch::motion {

/// The part of the body that a threat will hit and a clip protects, from the top down: neighbours
/// on the body are neighbours here.
enum class Target : std::uint8_t { head, trunk, pelvis, legs };
/// The number of targets.
inline constexpr int kTargetCount = 4;
/// All targets, from the top down, for range-based loops.
inline constexpr auto kTargets = all_enumerators<Target, kTargetCount>();
/// One value per target.
template <class T>
using PerTarget = EnumArray<Target, T, kTargetCount>;
/// The name in files and messages: "head", "trunk", "pelvis" or "legs".
std::string_view name_of(Target target);
/// The target with this name, if there is one.
std::optional<Target> target_named(std::string_view name);

/// How large the movement of a clip is.
enum class Degree : std::uint8_t { mild, exaggerated };
/// The name in files and messages: "mild" or "exaggerated".
std::string_view name_of(Degree degree);
/// The degree with this name, if there is one.
std::optional<Degree> degree_named(std::string_view name);

/// What a clip protects against, and when. Times are seconds from the clip's first pose, with
/// 0 <= onset < peak <= end <= duration.
struct Annotation {
  Target target = Target::head;
  /// Where the threat comes from, radians counter-clockwise from the character's facing, a multiple
  /// of pi/4 in (-pi, pi].
  float direction = 0;
  Degree degree = Degree::mild;
  float onset_s = 0;  ///< when the protective movement begins
  float peak_s = 0;   ///< when it protects most
  float end_s = 0;    ///< when the movement has ended
};

/// What pushed the character of a recovery from a push, and how hard. Times are seconds from the
/// clip's first pose, with 0 <= contact < peak <= duration.
struct Push {
  float contact_s = 0;       ///< when the push begins
  float peak_s = 0;          ///< when the pushed joint moves fastest along the push
  Role place = Role::chest;  ///< the pushed joint; is_push_place()
  /// Where the push comes from, radians counter-clockwise from the facing at contact, (-pi, pi].
  float direction = 0;
  /// Of the pushed joint at the peak, m/s: how strong the push is. In the frame of the character's
  /// facing at contact: X forward, Y left, Z up.
  Eigen::Vector3f velocity = Eigen::Vector3f::Zero();
};

/// The joints at which a character can be pushed.
inline constexpr std::array<Role, 5> kPushPlaces{Role::chest, Role::neck, Role::head,
                                                 Role::left_upper_arm, Role::right_upper_arm};
/// Whether a character can be pushed at this joint: one of kPushPlaces.
bool is_push_place(Role role);
/// The name in files, options and messages: "chest", "neck", "head", "left_shoulder" or
/// "right_shoulder"; empty for other joints.
std::string_view push_place_name(Role place);
/// The place with this name, if there is one.
std::optional<Role> push_place_named(std::string_view name);

/// The role of a clip in its library.
enum class Purpose : std::uint8_t {
  anticipation,  ///< answers threats, if it is annotated
  idle,          ///< standing; responses start from it
  push,          ///< recovery from a push; continues a motion after a hit
  stance,        ///< repeats in cycles; a character may be in it when it perceives (motion/loop.h)
};
/// The name in files and messages: "anticipation", "idle", "push" or "stance".
std::string_view name_of(Purpose purpose);

/// Poses at a fixed rate. Pose k is that at time k / rate_hz, s.
struct Motion {
  float rate_hz = 60;
  std::vector<Pose> poses;  ///< at least one

  float duration_s() const { return static_cast<float>(poses.size() - 1) / rate_hz; }
};

/// The pose at `time_s`, interpolated between the two nearest; before the first and after the last,
/// those. Sets the rotations of `roles` only.
Pose sample(const Motion& motion, float time_s, std::span<const Role> roles = kRoles);

/// The pose at `time_s` of a motion that plays forwards and backwards in turn without end, so that
/// it never jumps. `roles` as in sample().
Pose sample_ping_pong(const Motion& motion, float time_s, std::span<const Role> roles = kRoles);

/// The stored pose at or before the time. The rotations of sample() have the signs of this pose's
/// (q and -q are the same rotation).
const Pose& pose_before(const Motion& motion, float time_s);
/// The same for sample_ping_pong().
const Pose& pose_before_ping_pong(const Motion& motion, float time_s);

/// A recorded or authored motion with its description.
struct Clip {
  std::string name;  ///< unique in its library
  Purpose purpose = Purpose::anticipation;
  std::string kind;                      ///< "block", "duck", …, free text
  std::string source;                    ///< the file it came from, or how it was authored
  std::optional<Annotation> annotation;  ///< none: it answers no threat
  std::string mirrored_from;             ///< name of the clip that this one mirrors; empty if none
  Motion motion;
  std::optional<Push> push;  ///< none: it answers no push
};

}  // namespace flinch::motion
