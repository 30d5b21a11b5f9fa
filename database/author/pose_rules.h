// SPDX-License-Identifier: MIT
#pragma once

#include "motion/figure.h"

namespace flinch::database {

/// A threat as the rules see it (Hermens 2006, section 3.1). World frame.
struct AimedThreat {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< of its centre, when perceived, m
  float speed_mps = 0;
  float radius_m = 0.105F;                                 ///< its size
  Eigen::Vector3f target_point = Eigen::Vector3f::Zero();  ///< where it will strike, m
};

/// What counts as slow and fast, small and large: the ends of normalisation. Speeds are those of
/// spiked volleyballs (Hermens 2006, section 3.1); radii those of a tennis ball and of a gym ball.
struct ThreatRange {
  float min_speed_mps = 22.8F;
  float max_speed_mps = 29.7F;
  float min_radius_m = 0.033F;
  float max_radius_m = 0.2F;
};

/// How much of each rule is used, each in [0, 1] (table 3.1).
struct RuleControls {
  float lean = 0;  ///< from the threat's speed; all others from its size
  float turn = 0;
  float recoil = 0;
  motion::PerSide<float> reach{};   ///< 0 reaches farthest out
  motion::PerSide<float> swivel{};  ///< 0 lifts the elbow farthest out
};

/// The value's place between `min` and `max`, clamped to [0, 1].
float normalised(float value, float min, float max);

/// Table 3.1. Speeds and sizes beyond the range are clamped.
RuleControls rule_controls(const AimedThreat& threat, const ThreatRange& range = {});

/// Equation 3.4: how much of the responses for head and for pelvis answers a threat at a point.
/// W_i = (D_total - D_i) / D_total; they add up to 1.
struct TargetWeights {
  float head = 1;
  float pelvis = 0;
};
TargetWeights target_weights(float distance_to_head_m, float distance_to_pelvis_m);

/// Throws Error for a speed that is not positive and finite, or a position that is not finite, or
/// inside the body in this pose, or at the target point.
void check_threat(const motion::Figure& figure, const motion::Pose& pose,
                  const AimedThreat& threat);

/// The rules, to be used in this order. `travel` is the unit direction in which the threat travels,
/// in the frame of the character's facing. Angles are in degrees in table 3.2, radians here.

/// Leans the trunk and neck away: about y by travel_x, about x by -travel_y, times table 3.2's
/// maxima and `lean`. The pelvis' part is reversed for the pelvis (section 3.4), others fade.
motion::Pose lean_away(const motion::Pose& pose, const Eigen::Vector3f& travel, float lean,
                       const TargetWeights& weights);

/// Turns the back of the head toward the threat at `azimuth`, radians counter-clockwise from where
/// the head faces: neck and head up to 65 degrees, then 50, 30 and 20 % of what remains over back,
/// waist and pelvis, up to their maxima, all times `turn`. A threat straight ahead is turned from
/// to the right.
motion::Pose turn_away(const motion::Pose& pose, float azimuth, float turn);

/// Draws the shoulders up.
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

/// Whether the threat comes from behind the shoulders, so that hands go to the back of the head.
bool guards_head_from_behind(const motion::JointFrames& trunk, const ThreatGeometry& geometry);

/// By how much a reach control of 1 brings a hand nearer to its shoulder than one of 0, m.
float reach_range(const motion::Figure& figure, const TargetWeights& weights);

/// Puts both hands on the threat's line, at 0.9 to 0.3 m (head) or 0.5 to 0.4 m (pelvis) from their
/// shoulders (lengths of a figure of 1.75 m, scaled to this one), between threat and body, elbows
/// at 70 to 10 degrees from down; side by side, so that palms do not coincide. A threat behind the
/// shoulders is met by both hands on the back of the head. Out of reach, hands stop short. `trunk`
/// are the pose's joints.
void block(const motion::Figure& figure, const motion::JointFrames& trunk,
           const ThreatGeometry& geometry, const RuleControls& controls, motion::Pose& pose);

/// Both palms on the back of the head, elbows forward beside the face.
motion::Pose cover_head(const motion::Figure& figure, const motion::Pose& pose);

/// All four rules, with the feet put to `feet` and the pelvis as low as they need: the sustained
/// pose before balance. `feet_reach` tells whether they came there.
motion::Pose apply_rules(const motion::Figure& figure, const motion::Pose& pose,
                         const ThreatGeometry& geometry, const RuleControls& controls,
                         const motion::PerSide<motion::FootPose>& feet, bool* feet_reach = nullptr);

/// The first flinch (section 3.2.6): 0.2 of the way from `pose` to fully drawn up shoulders and
/// arms, the head turned 40 % of the way toward the threat.
motion::Pose startle(const motion::Figure& figure, const motion::Pose& pose,
                     const AimedThreat& threat);

}  // namespace flinch::database
