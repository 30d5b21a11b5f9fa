// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "features/threat.h"

namespace flinch::runtime {

/// How far a character's perception falls short of the truth (Zordan et al. 2007, section 8:
/// delays, noise and failed attempts against the omnipotent look). All off by default. Each is at
/// least 0.
///
/// Noise is in what an eye measures: directions err by angles, sizes by fractions. A distance or
/// speed is off by a factor exp(sigma n) of a normal n, so that it stays positive and half of all
/// draws are too large; a direction is turned by a normal angle about each of two axes across it.
/// Who takes a threat to be farther takes it to be faster by as much: people tell the time to
/// contact from how fast the image grows, whatever the distance (Gray and Regan 1999, "Do monocular
/// time-to-collision estimates necessarily involve perceived distance?").
struct PerceptionLimits {
  /// Until the character can act on what it has seen, s.
  float reaction_delay_s = 0;
  float bearing_noise = 0;   ///< of the direction in which it sees the threat, radians
  float distance_noise = 0;  ///< of its distance from the eye and its speed together, a fraction
  float heading_noise = 0;   ///< of the direction of its velocity, radians
  float speed_noise = 0;     ///< of its speed, and so of the time to contact, a fraction
  float chance_to_fail = 0;  ///< that it does not notice the threat at all, at most 1
};

/// Whether all limits are finite and in their ranges.
bool is_valid(const PerceptionLimits& limits) noexcept;

/// A person's limits, who chooses among `choices` answers (below 1 counts as 1).
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

/// What a character makes of a threat.
struct Perceived {
  bool noticed = true;      ///< false: there is nothing to answer
  float delay_s = 0;        ///< until the character can act on it
  features::Threat threat;  ///< as it takes it to be at perception, before the delay
};

/// What is perceived of a threat from `eye` (world, m). The same seed and number of the threat give
/// the same bits, whatever else was perceived; each limit has its own draws, so that to change one
/// changes no other's. Radius and mass are taken as they are, and what has a limit of 0 keeps its
/// bits. Limits that are not valid count as off; of a threat or an eye that is not finite, the
/// threat is handed on as it is, for the prediction to refuse. Allocates nothing, throws nothing.
Perceived perceive(const features::Threat& threat, const Eigen::Vector3f& eye,
                   const PerceptionLimits& limits, std::uint64_t seed,
                   std::uint64_t number) noexcept;

}  // namespace flinch::runtime
