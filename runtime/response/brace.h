// SPDX-License-Identifier: MIT
#pragma once

#include "database/rules/pose_rules.h"
#include "runtime/response/response.h"

namespace flinch::runtime {

/// A threat that is answered by rule.
struct RuledThreat {
  features::Threat threat;  ///< at perception
  /// Where its centre is at the impact, world, m.
  Eigen::Vector3f target_point = Eigen::Vector3f::Zero();
  float time_to_impact_s = 0.5F;  ///< from perception, above 0
  float delay_s = 0;              ///< from perception until the character can act, s
  bool startles = false;          ///< whether the character startles first
};

/// Plans a response by the pose rules of Hermens 2006 instead of a clip: from what the character
/// does to a sustained pose, with the hands on the threat's line and the centre of mass moved
/// toward it (section 3.3), which it holds for a third of a second. Table 3.1 takes the strength of
/// the rules from the threat's speed and size, equation 4.1 the time that the movement takes. With
/// a startle, the movement goes through the startled pose (section 3.2.6).
///
/// The result is invalid where that of make_response() would be, or where the threat will stand
/// still at the impact. Costs some hundred microseconds; allocates nothing, throws nothing.
Response make_brace(const PreparedLibrary& library, const features::CharacterState& state,
                    const RuledThreat& threat,
                    const Inertialization& inertialization = {}) noexcept;

/// The sustained pose: `pose` with the rules applied, the feet at `feet`, and the pelvis where the
/// centre of mass is database::kBraceDistance nearer to the threat than the rules alone have it.
motion::Pose braced_pose(const motion::Figure& figure, const motion::Pose& pose,
                         const database::AimedThreat& threat,
                         const database::RuleControls& controls,
                         const motion::PerSide<motion::FootPose>& feet);

}  // namespace flinch::runtime
