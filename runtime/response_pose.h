// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "runtime/response.h"

namespace flinch::runtime {

/// The parts that a response's pose is made of, each a function of time, for pose_at and for the
/// planning of responses. Where `roles` are not all, the rotations of others are not set.

/// What the character does if nothing answers.
motion::Pose source_pose_at(const Response& response, float time_s,
                            std::span<const motion::Role> roles = motion::kRoles);
/// The idle clip where it goes on after the response.
motion::Pose home_pose_at(const Response& response, float time_s,
                          std::span<const motion::Role> roles = motion::kRoles);
/// The clip's pose, aligned.
motion::Pose clip_pose_at(const Response& response, float time_s,
                          std::span<const motion::Role> roles = motion::kRoles);

/// Where a foot is in each of them; of the source, where it stands.
motion::FootPlace source_foot_in(const Response& response, motion::Side side,
                                 const motion::Pose& source);
motion::FootPlace clip_foot_in(const Response& response, motion::Side side,
                               const motion::Pose& clip, float time_s);
motion::FootPlace source_foot_at(const Response& response, motion::Side side, float time_s);
motion::FootPlace clip_foot_at(const Response& response, motion::Side side, float time_s);
motion::FootPlace home_foot_at(const Response& response, motion::Side side, float time_s);

/// A pose is made in three stages. First the motions that it is blended from are sampled, once.
struct Samples {
  enum class Of : std::uint8_t {
    source_untouched,  ///< before the response: no weight is shifted
    source,
    source_and_clip,
    clip,
    clip_and_home,
    source_and_home,
    home,  ///< after the response
  };
  Of of = Of::source_untouched;
  float time_s = 0;
  motion::Pose from;               ///< the first of them
  std::optional<motion::Pose> to;  ///< the other, if there is one
};
Samples samples_at(const Response& response, float time_s,
                   std::span<const motion::Role> roles = motion::kRoles);

/// Second, joints are blended, each by itself.
motion::Pose blended(const Response& response, const Samples& samples,
                     std::span<const motion::Role> roles = motion::kRoles);

/// Third, the feet are placed, with the weight shifted by `shift`: nothing that the pelvis does
/// moves a foot.
/// This turns thighs, shins and feet alone, and needs no roles but the legs' and the pelvis'.
struct Legs {
  motion::JointFrames frames;               ///< of the pelvis and the legs, before the third stage
  motion::PerSide<motion::FootPlace> feet;  ///< where the feet go
};
bool must_place_feet(const Response& response, const Samples& samples,
                     const Eigen::Vector3f& shift);
Legs legs_of(const Response& response, const Samples& samples, const motion::Pose& blended);
void place_feet(const Response& response, const Legs& legs, const Eigen::Vector3f& shift,
                motion::Pose& pose);

/// By how much the shifts of weight move the pelvis, world, m.
Eigen::Vector3f weight_shift_at(const Response& response, float time_s);

Eigen::Vector3f level(const Eigen::Vector3f& vector);

}  // namespace flinch::runtime
