// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/author/static_balance.h"
#include "database/author/transition.h"
#include "motion/clip.h"

namespace flinch::database {

/// Returns the time from the perception of a threat to its contact, s, by equation 4.1 (Hermens
/// 2006):
///
/// TTC = (0.25 + 0.75 (1 - speed)) (1 + 0.2 (1 - cos angle))
///
/// `normalised_speed` is clamped to [0, 1]; `cos_angle` is that of the angle between facing and the
/// direction to the threat. A faster threat has a shorter time, as in the equation and as for real
/// balls; the thesis' text says the opposite. See docs/authoring.md.
float time_to_contact_s(float normalised_speed, float cos_angle);

/// The key poses of a response to a threat.
struct ProtectivePoses {
  motion::Pose start;                    ///< pose when the threat is perceived
  std::optional<motion::Pose> startled;  ///< the first flinch, if requested
  BalancedPose sustained;
};

/// How far ahead in the motion the key poses start, so that the body keeps its momentum, s.
inline constexpr float kStartleLookAhead = 1.0F / 12;
inline constexpr float kSustainedLookAhead = 1.0F / 6;

/// Returns the key poses for a threat perceived `time_s` into a motion (section 4.2); after its end
/// the motion holds its last pose. Throws Error for a threat that check_threat rejects.
ProtectivePoses protective_poses(const motion::Figure& figure, const motion::Motion& motion,
                                 float time_s, const AimedThreat& threat,
                                 const RuleControls& controls, bool with_startle);

/// Duration of each phase, s (section 4.2).
struct ProtectiveTiming {
  float protect_s = 0.4F;  ///< from the start to the sustained pose, including the startle
  float settle_s = 0.04F;  ///< time between the sustained pose and the intended impact
  float hold_s = 1.0F / 3;
  float recover_s = 0.26F + 0.375F;
};
inline constexpr float kStartle = 15.0F / 120;  // s, duration of the startle, if any

/// Returns the protective motion, without contact: from `start` to `sustained`, a hold, and back.
/// With a startle pose, it goes through that first.
motion::Motion protective_motion(const motion::Figure& figure, const motion::Pose& start,
                                 const std::optional<motion::Pose>& startled,
                                 const motion::Pose& sustained, const ProtectiveTiming& timing,
                                 float rate_hz);

}  // namespace flinch::database
