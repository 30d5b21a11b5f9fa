// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "features/threat.h"

namespace flinch::runtime {

/// How a character's perception falls short of the truth (Zordan et al. 2007, section 8). The
/// defaults are perfect perception. Each value is finite and at least 0.
///
/// Noise acts on what an eye measures. A distance or speed is multiplied by exp(sigma n) with a
/// normal n, so it stays positive, and half of all draws are too large. A direction is turned by a
/// normal angle about each of two axes perpendicular to it. Distance and speed share one draw: who
/// takes a threat to be farther also takes it to be faster by the same factor, because people tell
/// the time to contact from how fast the image grows, whatever the distance (Gray and Regan 1999,
/// "Do monocular time-to-collision estimates necessarily involve perceived distance?").
struct PerceptionLimits {
  float reaction_delay_s = 0;  ///< from seeing a threat to acting on it, s
  float bearing_noise = 0;     ///< of the direction from the eye to the threat, radians
  float distance_noise = 0;    ///< of the distance from the eye and the speed together, a fraction
  float heading_noise = 0;     ///< of the direction of the threat's velocity, radians
  float speed_noise = 0;       ///< of the speed, and so of the time to contact, a fraction
  float chance_to_fail = 0;    ///< probability of not noticing a threat at all, at most 1
};

/// Whether all limits are finite and in their ranges.
bool is_valid(const PerceptionLimits& limits) noexcept;

/// The limits of a person who chooses among `choices` answers (below 1 counts as 1).
///
/// The delay is 0.22 s, the middle of simple visual reactions (0.19 to 0.25 s), and 0.15 s more for
/// each doubling of the choices (Hick 1952, "On the rate of gain of information"). Heading: 0.2
/// degrees, the threshold for the direction of motion in depth of a target that either eye sees
/// (Portfors-Yeomans and Regan 1997, "Discrimination of the direction and speed of motion in depth
/// of a monocularly visible target from binocular information alone": 0.14 to 0.22). Speed: 7 %, of
/// the 10 % by which two speeds in depth must differ to be told apart, which is the error of two
/// judgements (0.1 / sqrt 2; Portfors-Yeomans and Regan 1996, "Cyclopean discrimination thresholds
/// for the direction and speed of motion in depth"). Failures: 3 %, the middle of the rates at
/// which observers lapse (0 to 6 %, Wichmann and Hill 2001, "The psychometric function I"). Bearing
/// (0.1 degrees) and distance (5 %) are estimates.
PerceptionLimits human_limits(int choices = 1) noexcept;

/// A threat as a character perceives it.
struct Perceived {
  bool noticed = true;      ///< false: the character does not see it
  float delay_s = 0;        ///< until the character can act, s
  features::Threat threat;  ///< as perceived, before the delay passes
};

/// Applies the limits to threat number `number`, seen from `eye` (world, m). Character::perceive()
/// calls this; call it yourself to show what a character sees.
///
/// Equal arguments give equal bits, whatever else was perceived. Each limit has its own draws, so
/// changing one leaves the effect of the others as it was; a limit of 0 leaves the bits of what it
/// acts on unchanged. Radius and mass are perceived exactly. Limits that are not valid count as
/// none; a threat that is not usable (features::is_usable) or an eye that is not finite returns the
/// threat unchanged. What noise makes unusable is not noticed. Allocates nothing, throws nothing.
Perceived perceive(const features::Threat& threat, const Eigen::Vector3f& eye,
                   const PerceptionLimits& limits, std::uint64_t seed,
                   std::uint64_t number) noexcept;

}  // namespace flinch::runtime
