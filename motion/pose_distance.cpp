// SPDX-License-Identifier: MIT
#include "motion/pose_distance.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"

namespace flinch::motion {
namespace {

constexpr float kVelocityTime_s = 0.1F;  // T

}  // namespace

PoseMetric::PoseMetric(const Physique& character)
    : skeleton_(character.skeleton), model_(make_body_model(character)), order_(kBodies) {
  std::stable_sort(order_.begin(), order_.end(), [this](Body first, Body second) {
    return model_[first].mass_kg > model_[second].mass_kg;
  });
  for (const Body body : kBodies)
    weight_[body] = std::sqrt(model_[body].mass_kg / character.mass_kg);
}

PoseFeatures PoseMetric::features(const Pose& before, const Pose& now, float dt_s) const noexcept {
  const JointFrames from = forward_kinematics(skeleton_, before);
  const JointFrames to = forward_kinematics(skeleton_, now);
  const Eigen::Quaternionf into_facing = rotation_about(Eigen::Vector3f::UnitZ(), -facing(now));
  const Eigen::Vector3f origin(now.root_position.x(), now.root_position.y(), 0);
  PoseFeatures features;
  for (int column = 0; column < kBodyCount; ++column) {
    const Body body = order_[static_cast<std::size_t>(column)];
    const Eigen::Vector3f place = centre_of_mass(model_, to, body);
    const Eigen::Vector3f velocity = (place - centre_of_mass(model_, from, body)) / dt_s;
    const Eigen::Vector3f offset = place - origin;
    features.col(column).head<3>() = weight_[body] * (into_facing * offset);
    features.col(column).tail<3>() = weight_[body] * kVelocityTime_s * (into_facing * velocity);
  }
  return features;
}

// The heaviest bodies come first and decide most comparisons.
float squared_distance(const PoseFeatures& one, const PoseFeatures& other, float bound) noexcept {
  float squared = 0;
  for (int column = 0; column < kBodyCount && squared <= bound; ++column)
    squared += (one.col(column) - other.col(column)).squaredNorm();
  return squared;
}

}  // namespace flinch::motion
