// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "motion/clip.h"

namespace flinch::tests {

inline float uniform(std::mt19937& random, float min, float max) {
  return std::uniform_real_distribution<float>(min, max)(random);
}

inline Eigen::Vector3f random_vector(std::mt19937& random, float reach) {
  const float x = uniform(random, -reach, reach);
  const float y = uniform(random, -reach, reach);
  const float z = uniform(random, -reach, reach);
  return {x, y, z};
}

inline Eigen::Vector3f random_direction(std::mt19937& random) {
  Eigen::Vector3f vector = random_vector(random, 1);
  while (vector.norm() < 0.1F || vector.norm() > 1) vector = random_vector(random, 1);
  return vector.normalized();
}

inline Eigen::Quaternionf random_rotation(std::mt19937& random, float max_angle = 3.1F) {
  const Eigen::Vector3f axis = random_direction(random);
  return Eigen::Quaternionf(Eigen::AngleAxisf(uniform(random, 0, max_angle), axis));
}

/// A uniformly distributed rotation.
inline Eigen::Quaterniond uniform_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Vector4d coefficients;
  for (double& coefficient : coefficients) coefficient = normal(random);
  return Eigen::Quaterniond(coefficients).normalized();
}

inline motion::Pose random_pose(std::mt19937& random, float max_angle = 3.1F) {
  motion::Pose pose;
  pose.root_position = random_vector(random, 2);
  for (motion::Role role : motion::kRoles) {
    pose.rotation[role] = random_rotation(random, max_angle);
  }
  return pose;
}

/// Largest difference over the joints: of the root in m, of rotations in radians.
inline float distance(const motion::Pose& a, const motion::Pose& b) {
  float max = (a.root_position - b.root_position).norm();
  for (motion::Role role : motion::kRoles) {
    const float along = a.rotation[role].coeffs().dot(b.rotation[role].coeffs()) < 0 ? -1.0F : 1.0F;
    const float chord = (a.rotation[role].coeffs() - along * b.rotation[role].coeffs()).norm();
    max = std::max(max, 2 * chord);
  }
  return max;
}

/// The skeleton with bones that are not parallel to its axes, as in skeletons of recorded people;
/// left and right stay mirror images.
inline motion::Skeleton with_crooked_bones(motion::Skeleton skeleton, std::mt19937& random) {
  const auto mirror = [](const Eigen::Vector3f& v) {
    return Eigen::Vector3f(v.x(), -v.y(), v.z());
  };
  for (motion::Role role : motion::kRoles) {
    const motion::Role other = motion::mirrored(role);
    if (other <= role) continue;
    skeleton.offset[role] += random_vector(random, 0.03F);
    skeleton.offset[other] = mirror(skeleton.offset[role]);
  }
  return skeleton;
}

}  // namespace flinch::tests
