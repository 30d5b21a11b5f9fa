// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "motion/rotation.h"
#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"
#include "tests/sim/figure_motions.h"

namespace flinch::sim {

/// Steps of anything to anywhere.
class RandomStep {
 public:
  explicit RandomStep(const FigureModel& figure_model, unsigned seed)
      : figure_model_(figure_model), generator_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  Eigen::Vector3d vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  /// A pose with all joints bent by up to `turn` radians, often beyond their limits.
  ReferenceState state(double turn) {
    motion::Pose pose = scenes::standing(figure_model_.skeleton);
    for (motion::Role role : motion::kRoles) {
      pose.rotation[role] =
          pose.rotation[role] * motion::rotation_from_vector<float>(vector(turn).cast<float>());
    }
    ReferenceState result = state_at_rest(figure_model_.skeleton, figure_model_.model, pose);
    for (BodyState& body : result.body) {
      body.velocity = vector(3);
      body.angular_velocity = vector(8);
    }
    return result;
  }
  /// Displaced from the motion, with the joints pulled apart a little.
  ReferenceState disturbed(const ReferenceState& from) {
    ReferenceState result = from;
    for (BodyState& body : result.body) {
      body.position += vector(0.01);
      body.orientation = motion::rotation_from_vector<double>(vector(0.3)) * body.orientation;
      body.velocity += vector(1);
    }
    return result;
  }

 private:
  const FigureModel& figure_model_;
  std::mt19937 generator_;
};

}  // namespace flinch::sim
