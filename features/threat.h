// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

#include "motion/clip.h"

namespace flinch::features {

/// Acceleration of gravity, m/s^2, downwards.
inline constexpr double kGravity_mps2 = 9.81;
/// The same as a float.
inline constexpr float kGravity = static_cast<float>(kGravity_mps2);

/// The radius of a volleyball, which threats are by default.
inline constexpr double kVolleyballRadius_m = 0.105;
/// The mass of a volleyball.
inline constexpr double kVolleyballMass_kg = 0.27;

/// Restitution and friction of a ball's contacts with bodies and the ground. Doubles, because the
/// simulation computes in double.
struct Bounce {
  /// Share of the closing speed with which it leaves again (Newton's coefficient), from 0 to 1.
  double restitution = 0.7;
  double friction = 0.5;  ///< Coulomb's coefficient, at least 0

  bool operator==(const Bounce&) const = default;
};

/// The shape of a threat.
enum class ThreatShape : std::uint8_t {
  ball,
  blade,  ///< thin, such as a knife: a sphere as small as its point, which does not bounce
  fist,   ///< the end of a limb: a sphere that is driven along a stroke
  rod,    ///< a bat or a stick: a capsule that is swung along a stroke or thrown
};
/// How many shapes there are.
inline constexpr std::size_t kThreatShapeCount = 4;
/// Returns "ball", "blade", "fist" or "rod".
std::string_view name_of(ThreatShape shape);
/// Returns the shape with that name, if there is one.
std::optional<ThreatShape> threat_shape_named(std::string_view name);

/// The motion of a threat that is driven, as a fist is: it waits, moves straight, and stops. It
/// touches nothing before and after.
struct Stroke {
  float starts_in_s = 0;  ///< from now, at least 0
  float lasts_s = 0;      ///< from its start or, once it has started, from now; at least 0
};

/// What makes a threat a rod: a capsule whose axis runs from its butt to its tip and turns about
/// the threat's position. That is the grip of one that is swung, and the centre of mass of one that
/// is thrown. It does not roll about its axis.
struct Rod {
  Eigen::Vector3f axis = Eigen::Vector3f::UnitX();             ///< unit, from butt to tip, world
  Eigen::Vector3f angular_velocity = Eigen::Vector3f::Zero();  ///< rad/s, world, across the axis
  /// From the threat's position to the centres of the axis' rounded ends, along it, m.
  float to_butt_m = 0.5F;
  float to_tip_m = 0.5F;
  float to_mass_m = 0;     ///< to the rod's centre of mass, towards the tip; 0 if it is thrown
  float grip_mass_kg = 0;  ///< effective mass of the hands that hold it; 0 if it is thrown
};

/// A rod or none. Holds one in either case, so that threats are copied as plain numbers: of
/// std::optional's copies by condition GCC 12 warns that a rod which is not there is not set.
class MaybeRod {
 public:
  MaybeRod() = default;
  MaybeRod(const Rod& rod) : rod_(rod), is_there_(true) {}

  explicit operator bool() const { return is_there_; }
  bool has_value() const { return is_there_; }
  const Rod& operator*() const { return rod_; }
  Rod& operator*() { return rod_; }
  const Rod* operator->() const { return &rod_; }
  Rod* operator->() { return &rod_; }
  Rod value_or(const Rod& otherwise) const { return is_there_ ? rod_ : otherwise; }
  void reset() { *this = MaybeRod(); }

 private:
  Rod rod_;
  bool is_there_ = false;
};

/// Something that approaches in free fall or straight, at the moment of perception: a ball as a
/// character perceives it. features::Ball is a ball as physics moves it. World frame, Z up.
struct Threat {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();      ///< of its centre (see also Rod), m
  Eigen::Vector3f velocity = Eigen::Vector3f::Zero();      ///< m/s
  float radius = static_cast<float>(kVolleyballRadius_m);  ///< m
  float mass_kg = static_cast<float>(kVolleyballMass_kg);
  Bounce bounce{};
  bool falls = true;  ///< or flies straight
  int kind = 0;       ///< index among the kinds of threats that a store or a selector knows
  /// Of a fist or a rod that is swung, which flies straight whatever `falls` says; its `velocity`
  /// and turn are those of the stroke, also while it waits. None for what is thrown.
  std::optional<Stroke> stroke = std::nullopt;
  MaybeRod rod{};  ///< only of a rod; with a stroke, it is swung
};

/// Numbers beyond these are refused: no real scene reaches them, and sums lose precision.
inline constexpr float kMaxHorizon_s = 100;  ///< of a time to impact, s
/// Of a position, m, a velocity, m/s, a radius, m, a mass, kg, and gravity, m/s².
inline constexpr float kMaxExtent = 1e6F;
inline constexpr float kMaxRodLength_m = 5;  ///< of a rod, m

/// Whether all numbers are finite and within kMaxExtent, radius, mass, friction, kind and the times
/// of a stroke at least 0, and restitution from 0 to 1; and a rod has a unit axis, some length, a
/// centre of mass on it, and turns across it. Every call that takes a threat from outside refuses
/// others.
bool is_usable(const Threat& threat);

/// The position of a threat `time_s` after perception: p + v t - g t^2 / 2, where g is 0 for one
/// that flies straight. For a stroke, t is the time for which it has moved by then.
Eigen::Vector3f position_at(const Threat& threat, float time_s);

/// Its velocity then: v - g t. For a stroke always that of the stroke.
Eigen::Vector3f velocity_at(const Threat& threat, float time_s);

/// A point of a threat, and how it moves.
struct StrikingPoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Eigen::Vector3f velocity = Eigen::Vector3f::Zero();
  float mass_kg = 0;  ///< effective: of a free sphere that would give the same impulse
};
/// What of a threat strikes `target`, `time_s` after perception: the centre of a ball, or the point
/// of a rod's axis that is nearest to it.
StrikingPoint striking_point(const Threat& threat, float time_s, const Eigen::Vector3f& target);

/// The ball that flies straight as what strikes `target` then does: what a rod's answer by rule is
/// for. A ball stays as it is.
Threat striking_ball(const Threat& threat, float time_s, const Eigen::Vector3f& target);

/// Masses of a rod in motion, with the hands that hold it.
struct RodInertia {
  double mass_kg = 0;
  double to_mass_m = 0;     ///< from the point about which it turns to the centre of mass
  double inertia_kgm2 = 0;  ///< about an axis across it through that centre
  /// Effective mass at a point of the axis that is this far from the point about which it turns:
  /// 1 / (1/m + r^2/I), with r from the centre of mass.
  double effective_mass_kg(double at_m) const;
};
/// A uniform rod's m L^2 / 12, moved to the centre of mass that it shares with the hands.
RodInertia inertia_of(const Rod& rod, float radius_m, float mass_kg);

/// The threat `time_s` later: its position and velocity then.
Threat advanced(const Threat& threat, float time_s);

/// How far a rod's swing goes on beyond the impact, as a share of its reach.
inline constexpr float kFollowThrough = 0.5F;

/// A rod as people describe it. The point that strikes moves across the rod at the impact.
struct RodDescription {
  float length_m = 1;    ///< from end to end
  float balance = 0.5F;  ///< share of the length from the butt to the centre of mass
  float strikes_at = 1;  ///< share of the length from the butt to the point that strikes
  /// Turn of the rod about the direction of its motion, radians: 0 with the tip to the left as seen
  /// along the motion, pi/2 with the tip up.
  float tilt = 0;
  float grip_share = 0;    ///< of one that is swung: the grip's speed as a share of that point's
  float grip_mass_kg = 0;  ///< of one that is swung: effective mass of the hands
  float spin = 0;          ///< of one that is thrown, rad/s: its tip goes ahead of its centre
};

/// A threat as people describe it, by its impact.
struct ThreatDescription {
  /// Where the threat comes from, radians counter-clockwise from the character's facing: 0 is the
  /// front, pi/2 the character's left.
  float azimuth = 0;
  float elevation = 0;            ///< how far above the horizontal it comes from at impact, radians
  float speed_mps = 20;           ///< at impact
  float time_to_impact_s = 0.5F;  ///< from perception
  float radius = static_cast<float>(kVolleyballRadius_m);  ///< m
  float mass_kg = static_cast<float>(kVolleyballMass_kg);
  motion::Target target = motion::Target::head;
  Bounce bounce{};
  bool falls = true;  ///< or flies straight
  int kind = 0;       ///< see Threat::kind
  /// Of a fist: how far it moves before the impact point, where it stops, m. One that would have
  /// had to start before perception is under way then. Of a rod that is swung: how far the point
  /// that strikes does; it follows through for kFollowThrough of that.
  std::optional<float> reach_m = std::nullopt;
  std::optional<RodDescription> rod = std::nullopt;  ///< only of a rod
};

/// The threat whose centre reaches `impact_point` (world, m) after `description.time_to_impact_s`
/// with the speed and direction described, run backwards to perception (Hermens 2006, section 3.1,
/// keeps the values at the collision the same way). `facing` is that of the character
/// at perception (CharacterState::facing), radians.
Threat threat_from_description(const ThreatDescription& description,
                               const Eigen::Vector3f& impact_point, float facing);

}  // namespace flinch::features
