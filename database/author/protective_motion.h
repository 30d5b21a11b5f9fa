// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/author/static_balance.h"
#include "database/author/transition.h"
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

/// The poses that answer a threat.
struct ProtectivePoses {
  motion::Pose start;                    ///< of the motion, when the threat is perceived
  std::optional<motion::Pose> startled;  ///< the first flinch, if asked for
  BalancedPose sustained;
};

/// How far ahead in the motion the poses are taken, so that the body keeps its momentum, s.
inline constexpr float kStartleLookAhead = 1.0F / 12;
inline constexpr float kSustainedLookAhead = 1.0F / 6;

/// The poses that answer a threat perceived `time_s` into a motion (section 4.2); beyond its end
/// the motion stands still. Throws Error for a danger that check_threat refuses.
ProtectivePoses protective_poses(const motion::Figure& figure, const motion::Motion& motion,
                                 float time_s, const AimedThreat& threat,
                                 const RuleControls& controls, bool with_startle);

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
motion::Motion protective_motion(const motion::Figure& figure, const motion::Pose& start,
                                 const std::optional<motion::Pose>& startled,
                                 const motion::Pose& sustained, const ProtectiveTiming& timing,
                                 float rate_hz);

}  // namespace flinch::database
