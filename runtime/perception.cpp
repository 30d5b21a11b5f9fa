// SPDX-License-Identifier: MIT
#include "runtime/perception.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "features/random.h"
#include "motion/rotation.h"

namespace flinch::runtime {
namespace {

constexpr float kSimpleReactionTime_s = 0.22F;  // s
constexpr float kDelayPerDoubling_s = 0.15F;    // s

bool is_at_least_zero(float number) {
  return number >= 0 && std::isfinite(number);
}

/// Random errors in the perception of one threat: standard normal, except the chance.
struct Draws {
  double chance;  ///< uniform in [0, 1)
  std::array<float, 2> bearing;
  float distance;
  std::array<float, 2> heading;
  float speed;
};

// Draws all numbers in a fixed order, so that changing one limit does not change the others'
// errors.
Draws draw(std::uint64_t seed, std::uint64_t number) {
  features::Random random(seed, features::RandomStream::perception, number);
  const auto normal = [&] { return static_cast<float>(random.normal()); };
  Draws draws{};
  draws.chance = random.uniform();
  for (float& angle : draws.bearing) angle = normal();
  draws.distance = normal();
  for (float& angle : draws.heading) angle = normal();
  draws.speed = normal();
  return draws;
}

/// Returns `vector` rotated by normal angles about two axes perpendicular to it.
Eigen::Vector3f turned(const Eigen::Vector3f& vector, const std::array<float, 2>& normals,
                       float noise) {
  const float length = vector.norm();
  if (!(noise > 0 && length > 0)) return vector;
  const Eigen::Vector3f first = vector.unitOrthogonal();
  const Eigen::Vector3f second = vector.cross(first) / length;
  return motion::rotation_from_vector<float>(noise * (normals[0] * first + normals[1] * second)) *
         vector;
}

/// Returns exp(sigma n), which is exactly 1 without noise.
float factor(float normal, float noise) {
  return std::exp(noise * normal);
}

}  // namespace

bool is_valid(const PerceptionLimits& limits) noexcept {
  return is_at_least_zero(limits.reaction_delay_s) && is_at_least_zero(limits.bearing_noise) &&
         is_at_least_zero(limits.distance_noise) && is_at_least_zero(limits.heading_noise) &&
         is_at_least_zero(limits.speed_noise) && is_at_least_zero(limits.chance_to_fail) &&
         limits.chance_to_fail <= 1;
}

// Hick's law: delay = a + b log2(choices).
PerceptionLimits human_limits(int choices) noexcept {
  const float doublings = std::log2(static_cast<float>(std::max(choices, 1)));
  return {.reaction_delay_s = kSimpleReactionTime_s + kDelayPerDoubling_s * doublings,
          .bearing_noise = motion::radians(0.1F),
          .distance_noise = 0.05F,
          .heading_noise = motion::radians(0.2F),
          .speed_noise = 0.07F,
          .chance_to_fail = 0.03F};
}

Perceived perceive(const features::Threat& threat, const Eigen::Vector3f& eye,
                   const PerceptionLimits& limits, std::uint64_t seed,
                   std::uint64_t number) noexcept {
  Perceived perceived{.noticed = true, .delay_s = 0, .threat = threat};
  if (!is_valid(limits)) return perceived;
  perceived.delay_s = limits.reaction_delay_s;
  if (!is_usable(threat) || !eye.allFinite()) return perceived;
  const Draws draws = draw(seed, number);
  perceived.noticed = !(draws.chance < static_cast<double>(limits.chance_to_fail));
  const float distance_factor = factor(draws.distance, limits.distance_noise);
  if (limits.bearing_noise > 0 || limits.distance_noise > 0) {
    perceived.threat.position =
        eye + distance_factor * turned(threat.position - eye, draws.bearing, limits.bearing_noise);
  }
  perceived.threat.velocity = distance_factor * factor(draws.speed, limits.speed_noise) *
                              turned(threat.velocity, draws.heading, limits.heading_noise);
  // Noise of any size is allowed, so what is seen may be out of all range: it makes no sense.
  perceived.noticed = perceived.noticed && is_usable(perceived.threat);
  return perceived;
}

}  // namespace flinch::runtime
