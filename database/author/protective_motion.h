// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "database/author/static_balance.h"
#include "database/author/transition.h"
#include "motion/clip.h"

namespace flinch::database {

/// The key poses of a response to a threat.
struct ProtectivePoses {
  motion::Pose start;                    ///< pose when the threat is perceived
  std::optional<motion::Pose> startled;  ///< the first flinch, if requested
  BalancedPose sustained;
};

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

/// Returns the protective motion, without contact: from `start` to `sustained`, a hold, and back.
/// With a startle pose, it goes through that first.
motion::Motion protective_motion(const motion::Figure& figure, const motion::Pose& start,
                                 const std::optional<motion::Pose>& startled,
                                 const motion::Pose& sustained, const ProtectiveTiming& timing,
                                 float rate_hz);

}  // namespace flinch::database
