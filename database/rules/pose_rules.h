// SPDX-License-Identifier: MIT
#pragma once

#include "features/threat.h"
#include "motion/figure.h"

namespace flinch::database {

/// A threat as the rules see it (Hermens 2006, section 3.1). World frame.
struct AimedThreat {
  features::Threat threat;                                 ///< at the moment of perception
  Eigen::Vector3f target_point = Eigen::Vector3f::Zero();  ///< where it will strike, m
};

/// The range of threats that maps to [0, 1]: from slow to fast and from small to large. Speeds are
/// those of spiked volleyballs (Hermens 2006, section 3.1); radii are those of a tennis ball and a
/// gym ball.
struct ThreatRange {
  float min_speed_mps = 22.8F;
  float max_speed_mps = 29.7F;
  float min_radius_m = 0.033F;
  float max_radius_m = 0.2F;
};

/// Strength of each rule, in [0, 1] (table 3.1).
struct RuleControls {
  float lean = 0;  ///< from the threat's speed; all others are from its size
  float turn = 0;
  float recoil = 0;
  motion::PerSide<float> reach{};   ///< 0 reaches farthest
  motion::PerSide<float> swivel{};  ///< 0 raises the elbow farthest
};

/// Maps `min` to 0 and `max` to 1, clamped to [0, 1].
float normalised(float value, float min, float max);

/// Table 3.1. Speeds and sizes beyond the range are clamped.
RuleControls rule_controls(const AimedThreat& threat, const ThreatRange& range = {});

/// Returns the time from the perception of a threat to its contact, s, by equation 4.1 (Hermens
/// 2006):
///
/// TTC = (0.25 + 0.75 (1 - speed)) (1 + 0.2 (1 - cos angle))
///
/// `normalised_speed` is clamped to [0, 1]; `cos_angle` is that of the angle between facing and the
/// direction to the threat. A faster threat has a shorter time, as in the equation and as for real
/// balls; the thesis' text says the opposite. See docs/authoring.md.
float time_to_contact_s(float normalised_speed, float cos_angle);

/// How far ahead in the motion the key poses start, so that the body keeps its momentum, s.
inline constexpr float kStartleLookAhead = 1.0F / 12;
inline constexpr float kSustainedLookAhead = 1.0F / 6;

/// Duration of the startle, if any, s (section 4.2).
inline constexpr float kStartle = 15.0F / 120;
/// How long the sustained pose is held, and how long the way back takes, if nothing hits, s.
inline constexpr float kHold = 1.0F / 3;
inline constexpr float kRecovery = 0.26F + 0.375F;

inline constexpr float kBraceDistance = 0.10F;  ///< of the centre of mass, toward the threat, m

/// Equation 3.4: weights of the responses for head and for pelvis to a threat at a given point. W_i
/// = (D_total - D_i) / D_total; they add up to 1.
struct TargetWeights {
  float head = 1;
  float pelvis = 0;
};
TargetWeights target_weights(float distance_to_head_m, float distance_to_pelvis_m);

/// The rules, to be applied in this order. `travel` is the unit direction in which the threat
/// travels, in the frame of the character's facing. Angles are in degrees in table 3.2, radians
/// here.

/// Leans the trunk and neck away from the threat: about y by travel_x, about x by -travel_y, times
/// table 3.2's maxima and `lean`. The pelvis leans with the weight for the head minus that for the
/// pelvis (section 3.4), the other parts with the weight for the head.
motion::Pose lean_away(const motion::Pose& pose, const Eigen::Vector3f& travel, float lean,
                       const TargetWeights& weights);

/// Turns the back of the head towards the threat at `azimuth`, radians counter-clockwise from where
/// the head faces. Neck and head turn up to 65 degrees; back, waist and pelvis turn by 50, 30 and
/// 20 % of the remainder, up to their maxima; all are multiplied by `turn`. For a threat straight
/// ahead, the figure turns to the right.
motion::Pose turn_away(const motion::Pose& pose, float azimuth, float turn);

/// Raises the shoulders.
motion::Pose recoil(const motion::Pose& pose, float amount);

/// What the rules need to know of a threat, as the character stands when it perceives.
struct ThreatGeometry {
  Eigen::Vector3f target_point = Eigen::Vector3f::Zero();  ///< world, m
  Eigen::Vector3f to_threat = Eigen::Vector3f::UnitX();    ///< from there, unit, world
  Eigen::Vector3f travel = -Eigen::Vector3f::UnitX();      ///< as lean_away wants it
  float azimuth = 0;                                       ///< as turn_away wants it
  TargetWeights weights;
};
ThreatGeometry threat_geometry(const motion::Figure& figure, const motion::Pose& pose,
                               const AimedThreat& threat);

/// Returns whether the threat comes from behind the shoulders, so that hands cover the back of the
/// head.
bool guards_head_from_behind(const motion::JointFrames& trunk, const ThreatGeometry& geometry);

/// Returns by how much a reach control of 1 brings a hand nearer to its shoulder than one of 0, m.
float reach_range(const motion::Figure& figure, const TargetWeights& weights);

/// Puts both hands on the threat's line, between threat and body, at 0.9 to 0.3 m (head) or 0.5 to
/// 0.4 m (pelvis) from their shoulders (lengths for a figure of 1.75 m, scaled to this one), with
/// the elbows at 70 to 10 degrees from straight down. The hands are side by side, so that the palms
/// do not coincide. For a threat from behind the shoulders, both hands cover the back of the head.
/// Hands that cannot reach their places stop short. `trunk` holds the pose's joint frames.
void block(const motion::Figure& figure, const motion::JointFrames& trunk,
           const ThreatGeometry& geometry, const RuleControls& controls, motion::Pose& pose);

/// Puts both palms on the back of the head, elbows forward beside the face.
motion::Pose cover_head(const motion::Figure& figure, const motion::Pose& pose);

/// Applies all four rules, with the feet at `feet` and the pelvis as low as they require: the
/// sustained pose before balance. Sets `feet_reach` to whether the feet reached their places.
motion::Pose apply_rules(const motion::Figure& figure, const motion::Pose& pose,
                         const ThreatGeometry& geometry, const RuleControls& controls,
                         const motion::PerSide<motion::FootPose>& feet, bool* feet_reach = nullptr);

/// The first flinch (section 3.2.6): 0.2 of the way from `pose` to fully drawn up shoulders and
/// arms, the head turned 40 % of the way toward the threat.
motion::Pose startle(const motion::Figure& figure, const motion::Pose& pose,
                     const AimedThreat& threat);

}  // namespace flinch::database
