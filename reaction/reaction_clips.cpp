// SPDX-License-Identifier: MIT
#include "reaction/reaction_clips.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"

namespace flinch::reaction {
namespace {

constexpr float kRate_hz = 30;
constexpr float kMinRemaining_s = 0.3F;
constexpr float kDifference_s = 1.0F / 60;
constexpr float kPush_s = 0.1F;
constexpr float kMinPushCosine = 0.5F;           // of the angle between blow and push
constexpr float kMaxPushDifference_mps = 0.75F;  // between blow and push

Eigen::Vector2f push_of(const motion::Skeleton& skeleton, const motion::BodyModel& model,
                        const motion::Motion& motion) {
  std::vector<Eigen::Vector2f> centres;
  for (const motion::Pose& pose : motion.poses)
    centres.emplace_back(
        motion::centre_of_mass(model, forward_kinematics(skeleton, pose)).head<2>());
  if (centres.empty()) return Eigen::Vector2f::Zero();
  const auto distance = [&](const Eigen::Vector2f& centre) {
    return (centre - centres.front()).norm();
  };
  const auto farthest = std::ranges::max_element(centres, {}, distance);
  if (!(distance(*farthest) > 0)) return Eigen::Vector2f::Zero();
  const Eigen::Vector2f direction = (*farthest - centres.front()).normalized();
  const auto window = std::max<std::ptrdiff_t>(std::lround(kPush_s * motion.rate_hz), 1);
  float speed_mps = 0;
  for (auto from = centres.begin(); farthest - from >= window; ++from) {
    const float way_m = direction.dot(from[window] - *from);
    speed_mps = std::max(speed_mps, way_m * motion.rate_hz / static_cast<float>(window));
  }
  return speed_mps * direction;
}

bool fits(const Eigen::Vector2f& blow_mps, const Eigen::Vector2f& push_mps) {
  return blow_mps.dot(push_mps) >= kMinPushCosine * blow_mps.norm() * push_mps.norm() &&
         (blow_mps - push_mps).norm() <= kMaxPushDifference_mps;
}

}  // namespace

Eigen::Vector2f push_of(const motion::Physique& character, const motion::Motion& motion) {
  return push_of(character.skeleton, make_body_model(character), motion);
}

motion::Pose pose_of(const motion::Clip& clip, const ReactionMatch& match,
                     float time_since_match_s) noexcept {
  return motion::placed(motion::sample(clip.motion, match.time_s + time_since_match_s), match.yaw,
                        match.translation);
}

ReactionClips::ReactionClips(const motion::Physique& character, std::span<const motion::Clip> clips,
                             motion::Purpose purpose)
    : metric_(character) {
  const motion::BodyModel model = make_body_model(character);
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const motion::Motion& motion = clips[i].motion;
    if (clips[i].purpose != purpose) continue;
    const Eigen::Vector2f push_mps = push_of(character.skeleton, model, motion);
    const float last_s = motion.duration_s() - kMinRemaining_s;
    for (int k = 0; static_cast<float>(k) / kRate_hz <= last_s; ++k) {
      const float time_s = static_cast<float>(k) / kRate_hz;
      // The first pose has no predecessor, so the next difference replaces it.
      const float to_s = std::max(time_s, kDifference_s);
      Frame frame =
          frame_of(sample(motion, to_s - kDifference_s), sample(motion, to_s), kDifference_s);
      frame.clip = static_cast<int>(i);
      frame.time_s = to_s;
      frame.push_mps = Eigen::Rotation2Df(-frame.facing) * push_mps;
      frames_.push_back(frame);
    }
  }
}

ReactionClips::Frame ReactionClips::frame_of(const motion::Pose& before, const motion::Pose& now,
                                             float dt_s) const {
  return {.features = metric_.features(before, now, dt_s),
          .clip = 0,
          .time_s = 0,
          .facing = facing(now),
          .pelvis = now.root_position.head<2>()};
}

std::optional<ReactionMatch> ReactionClips::find(const motion::Pose& before,
                                                 const motion::Pose& now, float dt_s,
                                                 const Eigen::Vector2f& blow_mps,
                                                 float max_distance_m) const noexcept {
  if (!(dt_s > 0) || !std::isfinite(dt_s) || !is_sound(before) || !is_sound(now)) return {};
  if (!blow_mps.allFinite()) return {};
  const Frame wanted = frame_of(before, now, dt_s);
  const Eigen::Vector2f blow_from_facing = Eigen::Rotation2Df(-wanted.facing) * blow_mps;
  float best = max_distance_m * max_distance_m;
  const Frame* nearest = nullptr;
  for (const Frame& frame : frames_) {
    if (!fits(blow_from_facing, frame.push_mps)) continue;
    const float squared = motion::squared_distance(frame.features, wanted.features, best);
    if (squared < best || (squared <= best && !nearest)) {
      best = squared;
      nearest = &frame;
    }
  }
  if (!nearest) return {};
  ReactionMatch match{.clip = nearest->clip, .time_s = nearest->time_s};
  match.distance_m = std::sqrt(best);
  match.yaw = wanted.facing - nearest->facing;
  const Eigen::Vector2f turned = Eigen::Rotation2Df(match.yaw) * nearest->pelvis;
  match.translation = {wanted.pelvis.x() - turned.x(), wanted.pelvis.y() - turned.y(), 0};
  return match;
}

}  // namespace flinch::reaction
