// SPDX-License-Identifier: MIT
#pragma once

#include "features/predicted_motion.h"

namespace flinch::features {

/// Result of an impact prediction.
enum class Outcome : std::uint8_t {
  unusable,  ///< the input does not allow a prediction
  miss,
  impact,
  touching,  ///< it already touches or overlaps the figure: the impact is now
};
/// "unusable", "miss", "impact" or "touching".
std::string_view name_of(Outcome outcome);

/// The impact of a threat on a figure that does not respond to it. Fields other than the outcome
/// are valid only for `impact` and `touching`.
struct PredictedImpact {
  Outcome outcome = Outcome::unusable;
  /// Time until the surfaces first touch, s from now; 0 for `touching`.
  float touch_s = 0;
  /// Time until the threat's centre is nearest to the centre of the target `aimed_at`, if it flies
  /// on: the time to impact that scenarios hold and selectors are trained on. At least touch_s, and
  /// at most the horizon.
  float time_to_impact_s = 0;
  motion::Body body = motion::Body::head;        ///< the body that is struck first
  motion::Target struck = motion::Target::head;  ///< target_of(body)
  /// The target whose centre the threat's path passes nearest to; but the struck one where another
  /// is nearer by 5 cm or less. This is what scenarios call the target. It need not be the struck
  /// one: arms hang in front of pelvis and legs.
  motion::Target aimed_at = motion::Target::head;
  Eigen::Vector3f point = Eigen::Vector3f::Zero();    ///< on the body's surface, world, m
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< unit, from the body to the threat, world
};

/// A figure for predict_impact: everything that depends on neither threat nor pose. Refers to
/// skeleton and model, which must outlive it.
struct CollisionFigure {
  const motion::Skeleton* skeleton = nullptr;
  const motion::BodyModel* model = nullptr;
  float reach_m = 0;  ///< max distance of a surface point from the pelvis joint, over all poses
  motion::PerBody<float> body_reach_m{};  ///< the same of each body's surface from its own joint
};
CollisionFigure make_collision_figure(const motion::Skeleton& skeleton,
                                      const motion::BodyModel& model);

struct PredictionOptions {
  float horizon_s = 2;  ///< later impacts are not searched for; at most kMaxHorizon_s
  /// Of threats that fall; 0 for one that rolls. One that flies straight feels none.
  float gravity_mps2 = kGravity;
};

/// Faster figures are unusable, m/s.
inline constexpr float kMaxSurfaceSpeed_mps = 100;

/// Predicts when, where and on which body a falling ball strikes the figure in `ahead`. Sweeps the
/// sphere against the figure's capsules and boxes, to within a millimetre: a ball that passes a
/// surface within that distance counts as touching it. A ball that meets the ground first misses.
///
/// Unusable: a threat that is not usable (is_usable), other numbers that are not finite or exceed
/// kMaxExtent, kMaxHorizon_s or kMaxSurfaceSpeed_mps, a negative gravity or horizon, poses that are
/// not finite. Allocates nothing; throws only what `ahead` throws. A miss
/// by more than the figure's reach takes a fraction of a microsecond, anything else a few
/// evaluations of `ahead`.
PredictedImpact predict_impact(const Threat& threat, const CollisionFigure& figure,
                               const PredictedMotion& ahead, const PredictionOptions& options = {});

/// The same for a character that goes on in its stance, which is that of the state. `bounds` is
/// that of the stance's motion (motion_bounds_of). A motion without poses or a state that is not
/// finite is unusable.
PredictedImpact predict_impact(const Threat& threat, const CollisionFigure& figure,
                               const motion::Loop& stance, const MotionBounds& bounds,
                               const CharacterState& state,
                               const PredictionOptions& options = {}) noexcept;

/// The same for a character that holds a pose (world).
PredictedImpact predict_impact(const Threat& threat, const CollisionFigure& figure,
                               const motion::Pose& held,
                               const PredictionOptions& options = {}) noexcept;

}  // namespace flinch::features
