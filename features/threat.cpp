// SPDX-License-Identifier: MIT
#include "features/threat.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "motion/enum_array.h"

namespace flinch::features {
namespace {

Eigen::Vector3f acceleration_of(bool falls) {
  return {0, 0, falls ? -kGravity : 0.0F};
}

Eigen::Vector3f acceleration_of(const Threat& threat) {
  return acceleration_of(threat.falls && !threat.stroke);
}

/// For how long a threat will have moved by then.
float moved_s(const Threat& threat, float time_s) {
  if (!threat.stroke) return time_s;
  return std::clamp(time_s - threat.stroke->starts_in_s, 0.0F, threat.stroke->lasts_s);
}

bool is_within_extent(const Eigen::Vector3f& vector) {
  return (vector.array().abs() <= kMaxExtent).all();  // false for NaN
}

constexpr motion::EnumArray<ThreatShape, std::string_view, kThreatShapeCount> kShapeNames{
    "ball", "blade", "fist", "rod"};

bool is_within_extent(float number) {
  return number >= 0 && number <= kMaxExtent;  // false for NaN
}

bool is_usable(const Rod& rod, bool is_swung) {
  constexpr float kTolerance = 1e-3F;
  const float turns = rod.angular_velocity.norm();
  return std::abs(rod.axis.norm() - 1) <= kTolerance && is_within_extent(rod.angular_velocity) &&
         std::abs(rod.angular_velocity.dot(rod.axis)) <= kTolerance * std::max(turns, 1.0F) &&
         rod.to_butt_m >= 0 && rod.to_tip_m >= 0 && rod.to_butt_m + rod.to_tip_m > 0 &&
         rod.to_butt_m + rod.to_tip_m <= kMaxRodLength_m &&
         (is_swung ? is_within_extent(rod.grip_mass_kg) && rod.to_mass_m >= -rod.to_butt_m &&
                         rod.to_mass_m <= rod.to_tip_m
                   : rod.grip_mass_kg == 0 && rod.to_mass_m == 0);
}

/// The rod `time_s` of motion later.
Rod turned(Rod rod, float time_s) {
  const float turns = rod.angular_velocity.norm();
  if (turns > 0)
    rod.axis =
        (Eigen::AngleAxisf(turns * time_s, rod.angular_velocity / turns) * rod.axis).normalized();
  return rod;
}

/// How far the point that strikes is from the one about which the rod turns.
float strikes_m(const ThreatDescription& description, const Rod& rod) {
  return description.rod->strikes_at * (rod.to_butt_m + rod.to_tip_m) - rod.to_butt_m;
}

/// The rod at the impact, when the point that strikes moves along the unit vector `along`.
Rod rod_at_impact(const ThreatDescription& description, const Eigen::Vector3f& along) {
  const RodDescription& from = *description.rod;
  const Eigen::Vector3f level = Eigen::Vector3f::UnitZ().cross(along);
  constexpr float kSteep = 1e-4F;  // for a vertical motion any side will do
  const Eigen::Vector3f side =
      level.norm() > kSteep ? level.normalized() : Eigen::Vector3f::UnitY();
  Rod rod;
  rod.axis = std::cos(from.tilt) * side + std::sin(from.tilt) * along.cross(side);
  const float length = std::max(from.length_m - 2 * description.radius, 0.0F);
  const bool is_swung = description.reach_m.has_value();
  rod.to_butt_m = is_swung ? 0 : from.balance * length;
  rod.to_tip_m = length - rod.to_butt_m;
  if (is_swung) {
    rod.to_mass_m = from.balance * length;
    rod.grip_mass_kg = from.grip_mass_kg;
  }
  const float turn =
      is_swung ? (1 - from.grip_share) * description.speed_mps / strikes_m(description, rod)
               : from.spin;
  rod.angular_velocity = turn * rod.axis.cross(along);
  return rod;
}

}  // namespace

std::string_view name_of(ThreatShape shape) {
  return kShapeNames[shape];
}

std::optional<ThreatShape> threat_shape_named(std::string_view name) {
  const auto found = std::ranges::find(kShapeNames, name);
  if (found == kShapeNames.end()) return std::nullopt;
  return static_cast<ThreatShape>(found - kShapeNames.begin());
}

bool is_usable(const Threat& threat) {
  return is_within_extent(threat.position) && is_within_extent(threat.velocity) &&
         is_within_extent(threat.radius) && is_within_extent(threat.mass_kg) &&
         threat.bounce.restitution >= 0 && threat.bounce.restitution <= 1 &&
         threat.bounce.friction >= 0 && threat.bounce.friction <= double{kMaxExtent} &&
         threat.kind >= 0 &&
         (!threat.stroke || (is_within_extent(threat.stroke->starts_in_s) &&
                             is_within_extent(threat.stroke->lasts_s))) &&
         (!threat.rod || is_usable(*threat.rod, threat.stroke.has_value()));
}

Eigen::Vector3f position_at(const Threat& threat, float time_s) {
  const float t = moved_s(threat, time_s);
  return threat.position + t * threat.velocity + 0.5F * t * t * acceleration_of(threat);
}

Eigen::Vector3f velocity_at(const Threat& threat, float time_s) {
  return threat.velocity + time_s * acceleration_of(threat);
}

Threat advanced(const Threat& threat, float time_s) {
  Threat later = threat;
  later.position = position_at(threat, time_s);
  later.velocity = velocity_at(threat, time_s);
  if (threat.stroke) {
    later.stroke->starts_in_s = std::max(threat.stroke->starts_in_s - time_s, 0.0F);
    later.stroke->lasts_s = threat.stroke->lasts_s - moved_s(threat, time_s);
  }
  if (threat.rod) later.rod = turned(*threat.rod, moved_s(threat, time_s));
  return later;
}

double RodInertia::effective_mass_kg(double at_m) const {
  const double arm_m = at_m - to_mass_m;
  return 1 / (1 / mass_kg + arm_m * arm_m / inertia_kgm2);
}

// With the rod's mass m at x from the point about which it turns, and the hands' M at it, the
// common centre is at X = m x / (m + M), and I = m L^2 / 12 + m (x - X)^2 + M X^2.
RodInertia inertia_of(const Rod& rod, float radius_m, float mass_kg) {
  const double length_m = double{rod.to_butt_m} + double{rod.to_tip_m} + 2 * double{radius_m};
  const double mass = double{mass_kg};
  const double hands = double{rod.grip_mass_kg};
  const double to_mass = double{rod.to_mass_m};
  RodInertia inertia;
  inertia.mass_kg = mass + hands;
  inertia.to_mass_m = mass * to_mass / inertia.mass_kg;
  const double beside = to_mass - inertia.to_mass_m;
  inertia.inertia_kgm2 = mass * length_m * length_m / 12 + mass * beside * beside +
                         hands * inertia.to_mass_m * inertia.to_mass_m;
  return inertia;
}

StrikingPoint striking_point(const Threat& threat, float time_s, const Eigen::Vector3f& target) {
  const Threat then = advanced(threat, time_s);
  if (!then.rod) return {then.position, then.velocity, then.mass_kg};
  const Rod& rod = *then.rod;
  const float along =
      std::clamp(rod.axis.dot(target - then.position), -rod.to_butt_m, rod.to_tip_m);
  return {then.position + along * rod.axis,
          then.velocity + along * rod.angular_velocity.cross(rod.axis),
          static_cast<float>(
              inertia_of(rod, then.radius, then.mass_kg).effective_mass_kg(double{along}))};
}

Threat striking_ball(const Threat& threat, float time_s, const Eigen::Vector3f& target) {
  if (!threat.rod) return threat;
  const StrikingPoint strikes = striking_point(threat, time_s, target);
  Threat ball = threat;
  ball.rod.reset();
  ball.stroke.reset();
  ball.falls = false;
  ball.velocity = strikes.velocity;
  ball.position = strikes.position - time_s * strikes.velocity;
  ball.mass_kg = strikes.mass_kg;
  return ball;
}

// At the impact the threat is at p_T with v_T = -speed u, where u is the unit vector to where it
// comes from. Going back by T under the acceleration a, which is (0, 0, -g) or 0:
//   v_0 = v_T - a T,   p_0 = p_T - v_0 T - a T^2 / 2
//
// A stroke moves for only the last part of T, and without acceleration. A rod turns back by its
// turn in this time, and the point about which it turns is beside the one that strikes.
Threat threat_from_description(const ThreatDescription& description,
                               const Eigen::Vector3f& impact_point, float facing) {
  const float yaw = facing + description.azimuth;
  const Eigen::Vector3f origin_direction(std::cos(description.elevation) * std::cos(yaw),
                                         std::cos(description.elevation) * std::sin(yaw),
                                         std::sin(description.elevation));
  Threat threat;
  float time_s = description.time_to_impact_s;
  if (description.reach_m) {
    const float lasts_s = std::min(*description.reach_m / description.speed_mps, time_s);
    threat.stroke = {time_s - lasts_s, lasts_s};
    time_s = lasts_s;
  }
  const Eigen::Vector3f acceleration = acceleration_of(description.falls && !threat.stroke);
  Eigen::Vector3f impact_velocity = -description.speed_mps * origin_direction;
  Eigen::Vector3f impact_position = impact_point;
  if (description.rod) {
    const Rod rod = rod_at_impact(description, -origin_direction);
    const Eigen::Vector3f arm = strikes_m(description, rod) * rod.axis;
    impact_velocity -= rod.angular_velocity.cross(arm);
    impact_position -= arm;
    threat.rod = turned(rod, -time_s);
    if (threat.stroke) threat.stroke->lasts_s *= 1 + kFollowThrough;
  }
  threat.velocity = impact_velocity - time_s * acceleration;
  threat.position =
      impact_position - time_s * threat.velocity - 0.5F * time_s * time_s * acceleration;
  threat.radius = description.radius;
  threat.mass_kg = description.mass_kg;
  threat.bounce = description.bounce;
  threat.falls = description.falls;
  threat.kind = description.kind;
  return threat;
}

}  // namespace flinch::features
