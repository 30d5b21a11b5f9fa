// SPDX-License-Identifier: MIT
#include "train/realism/proxy_judge.h"

#include <algorithm>
#include <cmath>

#include "database/quality/quality.h"
#include "motion/support_polygon.h"

namespace flinch::train {
namespace {

constexpr float kGravity_mps2 = 9.81F;
constexpr std::size_t kSittings = 10;

/// Largest distance of the extrapolated centre of mass x + v / w0 outside the soles, m; poses in
/// the air do not count.
float out_of_balance_m(const motion::Figure& figure, const motion::Motion& motion) {
  const motion::Skeleton& skeleton = figure.skeleton();
  std::vector<motion::JointFrames> frames;
  for (const motion::Pose& pose : motion.poses)
    frames.push_back(motion::forward_kinematics(skeleton, pose));
  const auto centre = [&](std::size_t k) {
    return motion::centre_of_mass(figure.bodies, frames[k]);
  };
  float most = 0;
  for (std::size_t k = 1; k + 1 < frames.size(); ++k) {
    const auto soles = motion::support_polygon(skeleton, frames[k]);
    if (soles.empty()) continue;
    const Eigen::Vector3f x = centre(k);
    const Eigen::Vector3f v = (centre(k + 1) - centre(k - 1)) * (motion.rate_hz / 2);
    const float w0 = std::sqrt(kGravity_mps2 / std::max(x.z(), 0.1F));
    const Eigen::Vector2f extrapolated = x.head<2>() + v.head<2>() / w0;
    most = std::max(most, -motion::signed_distance_inside(soles, extrapolated));
  }
  return most;
}

/// 1 up to `allowed`, 0 from `allowed + tolerance` on.
float score(float value, float allowed, float tolerance) {
  return std::clamp(1 - (value - allowed) / tolerance, 0.0F, 1.0F);
}

}  // namespace

ProxyJudge::ProxyJudge(const runtime::PushResponses& responses)
    : responses_(responses), figure_(motion::make_figure(responses.library->library->character)) {
  for (const runtime::PushResponse& response : responses.responses) {
    const motion::Motion& whole = responses.library->clip(response.clip).motion;
    motion::Motion rest{.rate_hz = whole.rate_hz, .poses = {}};
    const auto first = static_cast<std::ptrdiff_t>(response.contact_s * whole.rate_hz);
    rest.poses.assign(whole.poses.begin() + first, whole.poses.end());
    recorded_.push_back(measured(rest));
  }
}

ProxyMeasures ProxyJudge::measured(const motion::Motion& motion) const {
  motion::Clip clip;
  clip.motion = motion;
  const database::ClipQuality quality = database::measure_quality(figure_, clip);
  return {quality.limit_excess_deg,       quality.support_drift_m,
          quality.foot_below_ground_m,    quality.speed_share,
          quality.peak_acceleration_mps2, out_of_balance_m(figure_, motion)};
}

std::array<float, 6> ProxyJudge::scores_of(const PushExample& example) const {
  const ProxyMeasures found = measured(played(responses_, example));
  const ProxyMeasures& own = recorded_[static_cast<std::size_t>(example.answer.response)];
  const database::QualityBounds bounds;
  const float acceleration = std::max(own.acceleration_mps2, bounds.peak_acceleration_mps2);
  return {
      score(found.limit_excess_deg, std::max(own.limit_excess_deg, bounds.limit_excess_deg), 20),
      score(found.support_drift_m, std::max(own.support_drift_m, 0.005F), 0.03F),
      score(found.below_ground_m, std::max(own.below_ground_m, bounds.foot_below_ground_m), 0.02F),
      score(found.speed_share, std::max(own.speed_share, bounds.speed_share), 1),
      score(found.acceleration_mps2, acceleration, acceleration),
      score(found.out_of_balance_m, own.out_of_balance_m, 0.15F)};
}

float ProxyJudge::quality_of(const PushExample& example) const {
  const std::array<float, 6> scores = scores_of(example);
  return *std::min_element(scores.begin(), scores.end());
}

std::vector<Label> proxy_labels(const runtime::PushResponses& responses, const ProxyJudge& judge,
                                std::size_t count, std::uint64_t seed) {
  const std::string sittings = "proxy " + std::to_string(seed) + ".";
  std::vector<Label> labels;
  for (std::size_t i = 0; i < count; ++i) {
    features::Random random(seed, features::RandomStream::realism, i);
    const PushExample example = sample_example(responses, random);
    labels.push_back({example, judge.quality_of(example), std::string(kProxyJudge),
                      sittings + std::to_string(i * kSittings / count)});
  }
  return labels;
}

}  // namespace flinch::train
