// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "motion/clip.h"

namespace flinch::motion {

/// The longest time from the contact of a push to the peak of its velocity, s. Hands stay on the
/// body that they push: in recordings they accelerate it for 0.25 to 0.6 s.
inline constexpr float kMaxPushRise_s = 0.65F;

/// The slowest movement that counts as a push, m/s.
inline constexpr float kMinPushSpeed_mps = 0.1F;

/// What is known of a push beside the motion.
struct PushNotes {
  std::optional<float> contact_s;  ///< from the first pose
  std::optional<float> direction;  ///< see Push::direction
  Role place = Role::chest;
};

/// Measures the push in a recorded recovery. Speeds are horizontal, by central differences over
/// 1/15 s. With a known contact, the peak is the highest speed (along the direction, if that is
/// known) within kMaxPushRise_s of it. Otherwise the peak is where the joint first moves at 90 % of
/// its highest speed and stops to accelerate, and the contact is the last time before it at which
/// the joint moves at less than 10 % of the peak along the same direction. Returns nothing for a
/// motion in which nothing moves at kMinPushSpeed_mps, or that ends at the contact.
std::optional<Push> measure_push(const Skeleton& skeleton, const Motion& motion,
                                 const PushNotes& notes);

}  // namespace flinch::motion
