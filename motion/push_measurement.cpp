// SPDX-License-Identifier: MIT
#include "motion/push_measurement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/rotation.h"

namespace flinch::motion {
namespace {

constexpr float kHalfInterval_s = 1.0F / 30;
constexpr float kFirstPeakShare = 0.9F;
constexpr float kContactShare = 0.1F;

/// The joint's velocity in each pose, m/s.
std::vector<Eigen::Vector3f> velocities_of(const Skeleton& skeleton, const Motion& motion,
                                           Role joint) {
  std::vector<Eigen::Vector3f> places;
  places.reserve(motion.poses.size());
  for (const Pose& pose : motion.poses)
    places.push_back(forward_kinematics(skeleton, pose).position[joint]);
  const auto reach =
      static_cast<std::size_t>(std::max<long>(std::lround(kHalfInterval_s * motion.rate_hz), 1));
  std::vector<Eigen::Vector3f> velocities(places.size(), Eigen::Vector3f::Zero());
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t from = k - std::min(k, reach);
    const std::size_t to = std::min(k + reach, places.size() - 1);
    if (to == from) continue;
    velocities[k] = (places[to] - places[from]) * (motion.rate_hz / static_cast<float>(to - from));
  }
  return velocities;
}

Eigen::Vector2f away_from(float direction) {
  return {-std::cos(direction), -std::sin(direction)};
}

}  // namespace

std::optional<Push> measure_push(const Skeleton& skeleton, const Motion& motion,
                                 const PushNotes& notes) {
  const std::vector<Eigen::Vector3f> velocities = velocities_of(skeleton, motion, notes.place);
  const auto index_at = [&](float time_s) {
    const float last = static_cast<float>(velocities.size() - 1);
    return static_cast<std::size_t>(std::clamp(std::round(time_s * motion.rate_hz), 0.0F, last));
  };
  const std::size_t rise = index_at(kMaxPushRise_s);
  std::size_t contact = index_at(notes.contact_s.value_or(0));
  const std::size_t end =
      notes.contact_s ? std::min(contact + rise + 1, velocities.size()) : velocities.size();
  const auto speed = [&](std::size_t k) {
    const Eigen::Vector2f velocity = velocities[k].head<2>();
    if (!notes.direction) return velocity.norm();
    const float facing_yaw = facing(motion.poses[contact]);
    return velocity.dot(Eigen::Rotation2Df(facing_yaw) * away_from(*notes.direction));
  };
  std::size_t peak = contact;
  for (std::size_t k = contact; k < end; ++k) {
    if (speed(k) > speed(peak)) peak = k;
  }
  if (!notes.contact_s) {
    const float least = kFirstPeakShare * speed(peak);
    peak = 0;
    while (speed(peak) < least) ++peak;
    while (peak + 1 < end && speed(peak + 1) > speed(peak)) ++peak;
    const Eigen::Vector2f along = velocities[peak].head<2>().normalized();
    const float slow = kContactShare * velocities[peak].head<2>().norm();
    contact = peak;
    while (contact > peak - std::min(peak, rise) &&
           velocities[contact].head<2>().dot(along) > slow) {
      --contact;
    }
  }
  if (peak == contact || !(speed(peak) >= kMinPushSpeed_mps)) return std::nullopt;
  Push push;
  push.contact_s = static_cast<float>(contact) / motion.rate_hz;
  push.peak_s = static_cast<float>(peak) / motion.rate_hz;
  push.place = notes.place;
  push.velocity =
      rotation_about(Eigen::Vector3f::UnitZ(), -facing(motion.poses[contact])) * velocities[peak];
  push.direction = notes.direction.value_or(std::atan2(-push.velocity.y(), -push.velocity.x()));
  if (push.direction <= -std::numbers::pi_v<float>) push.direction = std::numbers::pi_v<float>;
  return push;
}

}  // namespace flinch::motion
