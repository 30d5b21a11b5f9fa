// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/transition.h"
#include "motion/clip.h"

namespace flinch::database {

/// Equation 4.1 (Hermens 2006): the time from perceiving a threat to its contact, s.
///
///     TTC = (0.25 + 0.75 (1 - speed)) (1 + 0.2 (1 - cos angle))
///
/// `normalised_speed` in [0, 1], clamped; `cos_angle` of the angle between facing and the direction
/// to the threat. Faster is shorter, as the equation has it and balls do; the thesis' text says the
/// opposite. See docs/authoring.md.
float time_to_contact_s(float normalised_speed, float cos_angle);

/// How long each part lasts, s (section 4.2).
struct ProtectiveTiming {
  float protect_s = 0.4F;  ///< from the start to the sustained pose, startle and all
  float settle_s = 0.04F;  ///< how long after that a response should meet its impact
  float hold_s = 1.0F / 3;
  float recover_s = 0.26F + 0.375F;
};
inline constexpr float kStartle = 15.0F / 120;  // s, length of the startle where there is one

/// The protective motion from `start` to `sustained`, held, and back, without contact. With a
/// startle pose it goes there first.
motion::Motion protective_motion(const Figure& figure, const motion::Pose& start,
                                 const std::optional<motion::Pose>& startled,
                                 const motion::Pose& sustained, const ProtectiveTiming& timing,
                                 float rate_hz);

}  // namespace flinch::database
