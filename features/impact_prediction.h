// SPDX-License-Identifier: MIT
#pragma once

#include "features/poses_ahead.h"

namespace flinch::features {

/// What a threat comes to.
enum class Outcome : std::uint8_t {
  unusable,  ///< the input cannot be predicted from
  miss,
  impact,
  touching,  ///< it touches or overlaps the figure already: impact now
};
/// "unusable", "miss", "impact" or "touching".
std::string_view name_of(Outcome outcome);

/// The impact that a threat makes on a figure that does not answer it. All but the outcome counts
/// only for `impact` and `touching`.
struct PredictedImpact {
  Outcome outcome = Outcome::unusable;
  /// When the surfaces first touch, s from now; 0 for `touching`.
  float touch_s = 0;
  /// When the threat's centre would come nearest to the centre of the target `aimed_at`, if it flew
  /// on: the time to impact that scenarios have and selectors are trained on. At least touch_s.
  float time_to_impact_s = 0;
  motion::Body body = motion::Body::head;        ///< that is struck first
  motion::Target struck = motion::Target::head;  ///< target_of(body)
  /// The target whose centre the threat's path comes nearest to, that which it strikes if another
  /// is nearer by no more than 5 cm: what scenarios call the target. Not always what is struck:
  /// arms hang before pelvis and legs.
  motion::Target aimed_at = motion::Target::head;
  Eigen::Vector3f point = Eigen::Vector3f::Zero();    ///< on the body's surface, world, m
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< unit, from the body to the threat, world
};

/// A figure for predict_impact: what depends on neither threat nor pose. Refers to skeleton and
/// model, which must outlive it.
struct SweptFigure {
  const motion::Skeleton* skeleton = nullptr;
  const motion::BodyModel* model = nullptr;
  float reach_m = 0;  ///< no pose has a point of the surface farther from the pelvis' joint
  motion::PerBody<float> body_reach_m{};  ///< of each body's surface, from its own joint
};
SweptFigure make_swept_figure(const motion::Skeleton& skeleton, const motion::BodyModel& model);

struct PredictionOptions {
  float horizon_s = 2;            ///< later impacts are not looked for; at most kMostHorizon
  float gravity_mps2 = kGravity;  ///< 0 for what flies or rolls straight on
};

/// Inputs beyond these are unusable: no figure of ours meets them, and sums lose their digits.
inline constexpr float kMostHorizon = 100;  ///< s
inline constexpr float kMostExtent = 1e6F;  ///< of a position, m, a velocity, m/s, a gravity, m/s²
inline constexpr float kMostSwaySpeed = 100;  ///< m/s

/// When, where and on what a falling ball strikes the figure in `ahead`: by swept sphere against
/// its capsules and boxes, within a millimetre: a ball that passes within that of a surface counts
/// as touching it. A ball that meets the ground first misses.
///
/// Unusable: numbers that are not finite or beyond the bounds above, a radius, gravity or horizon
/// below 0, poses that are not finite. Allocates nothing, throws nothing unless `ahead` does. A
/// miss by more than the figure's reach costs a fraction of a microsecond, all else a few
/// evaluations of `ahead`.
PredictedImpact predict_impact(const Threat& threat, const SweptFigure& figure,
                               const PosesAhead& ahead, const PredictionOptions& options = {});

/// Of a character that idles. `sway` is that of the idle clip (sway_of). A clip without poses or a
/// state that is not finite is unusable.
PredictedImpact predict_impact(const Threat& threat, const SweptFigure& figure,
                               const motion::Motion& idle, const Sway& sway,
                               const CharacterState& state,
                               const PredictionOptions& options = {}) noexcept;

/// Of a character that holds a pose (world).
PredictedImpact predict_impact(const Threat& threat, const SweptFigure& figure,
                               const motion::Pose& held,
                               const PredictionOptions& options = {}) noexcept;

}  // namespace flinch::features
