// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "runtime/response/response.h"

namespace flinch::runtime {

struct PushDeformation;  // opaque: runtime/push/push_deformation.h
struct PushResponses;    // opaque: runtime::Library::push_responses()

/// A response that could answer a push, and why it is chosen or not. Vectors are in the frame of
/// the character's facing: X forward, Y left, Z up.
struct PushCandidate {
  int response = 0;   ///< index in PushResponses
  int clip = 0;       ///< index in the library
  float realism = 0;  ///< Q: how much the motion will look like a recording, 0 to 1
  float taper = 0;    ///< w of theta, 1/m^2: how fast the deformation declines over the body
  /// m of theta: what the response's own velocity lacks of the asked one, m/s.
  Eigen::Vector3f deformation = Eigen::Vector3f::Zero();
  float turn = 0;  ///< of the response against the character's facing, radians
};

/// A response counts as good from this Q on.
inline constexpr float kGoodRealism = 0.5F;

/// How a foot of a pushed character differs from that of the recorded response.
///
/// A foot that stands is moved as a whole: turned by `yaw` about the vertical through `pivot`, then
/// shifted, so that it rolls over its toes where it stands; what it differs by in height and tilt
/// goes away by the spring. Any other foot goes to the response's by the spring.
struct PushFoot {
  bool stands = false;
  Eigen::Vector3f offset = Eigen::Vector3f::Zero();  ///< of the ankle when the push comes, m
  Eigen::Vector3f offset_velocity = Eigen::Vector3f::Zero();  ///< m/s; zero for a standing foot
  float yaw = 0;                                              ///< of a standing foot, radians
  Eigen::Vector3f pivot = Eigen::Vector3f::Zero();  ///< the response's ankle at contact, world, m
  Eigen::Vector3f turn = Eigen::Vector3f::Zero();   ///< of the foot, beside `yaw`, rotation vector
  Eigen::Vector3f turn_velocity = Eigen::Vector3f::Zero();  ///< radians/s
  Interval fade;      ///< in which the difference fades to none, s after the push
  float reach_m = 0;  ///< longest distance of the ankle from the hip
};

/// The motion of a pushed character: a recorded response from its contact on, turned and moved to
/// the character, with what the character differs from it and what another push changes (Arikan et
/// al. 2005, section 3). A plain value that refers to the library.
///
/// The difference x of the root and of each joint's rotation to the response goes to zero by
/// motion::offset_spring, in joint angles, so that bones keep their lengths; the deformation is
/// added to the joints' positions (shift_joints). Feet that stand stay where they are until the
/// response lifts them, and come down where the response has them.
struct PushMotion {
  const PreparedLibrary* library = nullptr;  ///< null: none
  int clip = 0;
  float contact_s = 0;   ///< where in the clip the motion begins
  float duration_s = 0;  ///< of the rest of the clip
  float yaw = 0;         ///< the clip is laid in the world by motion::placed() with this
  Eigen::Vector3f translation = Eigen::Vector3f::Zero();
  Eigen::Vector3f root = Eigen::Vector3f::Zero();           ///< x_0 of the pelvis, m
  Eigen::Vector3f root_velocity = Eigen::Vector3f::Zero();  ///< x'_0, m/s
  motion::PerRole<Eigen::Vector3f> rotation{};              ///< x_0, rotation vectors
  motion::PerRole<Eigen::Vector3f> rotation_velocity{};
  float rise_s = 0;  ///< of the deformation
  motion::Role place = motion::Role::chest;
  Eigen::Vector3f deformation = Eigen::Vector3f::Zero();  ///< m, world, m/s
  motion::PerRole<float> share{};                         ///< of m that each joint has
  motion::PerSide<PushFoot> feet;
};

/// Begins response number `response` for a character in pose `now` that was in pose `before` `dt_s`
/// (above 0) earlier, world. The response is turned by `turn` (radians, counter-clockwise) against
/// the character's facing. Allocates nothing.
PushMotion make_push_motion(const PushResponses& responses, std::size_t response, float turn,
                            const PushDeformation& deformation, const motion::Pose& before,
                            const motion::Pose& now, float dt_s) noexcept;

/// Goes over to another clip of the library at `time_s` without a push: the same, unbent and not
/// turned. Allocates nothing.
PushMotion make_transition(const PreparedLibrary& library, int clip, float time_s,
                           const motion::Pose& before, const motion::Pose& now,
                           float dt_s) noexcept;

/// The pose `time_s` after the push, world; at 0 that of the character then, just before 0 nearly
/// the one before it. The last pose after the end. Bones have the skeleton's lengths. Costs a few
/// microseconds; allocates nothing.
motion::Pose pose_at(const PushMotion& motion, float time_s) noexcept;

/// The horizontal velocity of the pushed joint when the response's own push is at its peak, world,
/// m/s: over kClipVelocityInterval_s.
Eigen::Vector3f velocity_at_peak(const PushMotion& motion) noexcept;

/// Changes the deformation until velocity_at_peak() is `wanted` (horizontal), to 1 % as seen from
/// above, in at most four rounds.
void match_velocity(const Eigen::Vector3f& wanted, PushMotion& motion) noexcept;

/// The horizontal velocity of the pushed joint when it is fastest along `wanted` within
/// motion::kMaxPushRise_s of the push, world, m/s: over kClipVelocityInterval_s.
Eigen::Vector3f peak_velocity(const PushMotion& motion, const Eigen::Vector3f& wanted) noexcept;

/// Whether a velocity, as seen from above, is within 10 % and 15 degrees of the wanted one: pushed
/// bodies sink by up to 0.8 m/s while they take a step.
bool is_faithful(const Eigen::Vector3f& reached, const Eigen::Vector3f& wanted) noexcept;

}  // namespace flinch::runtime
