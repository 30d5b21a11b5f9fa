// SPDX-License-Identifier: MIT
#include "reaction/reaction_clips.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"

namespace flinch::reaction {
namespace {

using motion::Body;

constexpr float kRate_hz = 30;
constexpr float kMinRemaining_s = 0.3F;
constexpr float kVelocityWeight_s = 0.1F;
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
    : skeleton_(character.skeleton), model_(make_body_model(character)), order_(motion::kBodies) {
  std::stable_sort(order_.begin(), order_.end(), [this](Body first, Body second) {
    return model_[first].mass_kg > model_[second].mass_kg;
  });
  for (Body body : motion::kBodies) {
    weight_[body] = std::sqrt(model_[body].mass_kg / character.mass_kg);
  }
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const motion::Motion& motion = clips[i].motion;
    if (clips[i].purpose != purpose) continue;
    const Eigen::Vector2f push_mps = push_of(skeleton_, model_, motion);
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
  const motion::JointFrames from = forward_kinematics(skeleton_, before);
  const motion::JointFrames to = forward_kinematics(skeleton_, now);
  Frame frame{};
  frame.facing = facing(now);
  frame.pelvis = now.root_position.head<2>();
  const Eigen::Quaternionf into_facing =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), -frame.facing);
  const Eigen::Vector3f origin(frame.pelvis.x(), frame.pelvis.y(), 0);
  for (int column = 0; column < motion::kBodyCount; ++column) {
    const Body body = order_[static_cast<std::size_t>(column)];
    const Eigen::Vector3f place = centre_of_mass(model_, to, body);
    const Eigen::Vector3f velocity = (place - centre_of_mass(model_, from, body)) / dt_s;
    const Eigen::Vector3f offset = place - origin;
    frame.features.col(column).head<3>() = weight_[body] * (into_facing * offset);
    frame.features.col(column).tail<3>() =
        weight_[body] * kVelocityWeight_s * (into_facing * velocity);
  }
  return frame;
}

// Rejects a frame as soon as the distance of its first bodies, which are the heaviest, exceeds the
// best.
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
    float squared = 0;
    for (int column = 0; column < motion::kBodyCount && squared <= best; ++column) {
      squared += (frame.features.col(column) - wanted.features.col(column)).squaredNorm();
    }
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
