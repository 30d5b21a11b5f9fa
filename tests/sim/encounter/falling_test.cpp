// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "motion/default_character.h"
#include "tests/sim/figure_motions.h"
#include "tests/sim/tumble.h"

namespace flinch::sim {
namespace {

/// Change of the angular momentum in a second in the air, as a share of it.
double change_of_angular_momentum(const motion::Pose& pose, const Eigen::Vector3d& turning,
                                  double step_s) {
  const FigureModel figure_model(motion::default_character());
  scenes::Tumble tumble(figure_model, pose, turning);
  const Eigen::Vector3d before = tumble.angular_momentum();
  tumble.run(1, step_s);
  return (tumble.angular_momentum() - before).norm() / before.norm();
}

// Guards the figures of docs/simulation.md.
TEST(FallingFigure, KeepsItsAngularMomentumInTheAir) {
  const motion::Skeleton skeleton = motion::default_character().skeleton;
  for (const motion::Pose& pose : {scenes::standing(skeleton), scenes::guarding(skeleton)}) {
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d turning = 5 * Eigen::Vector3d::Unit(axis);
      const double shipped = change_of_angular_momentum(pose, turning, 1.0 / 120);
      const double fine = change_of_angular_momentum(pose, turning, 1.0 / 480);
      EXPECT_LT(shipped, 0.01) << "about axis " << axis;
      EXPECT_LT(fine, 0.5 * shipped + 1e-4) << "about axis " << axis;
    }
  }
}

}  // namespace
}  // namespace flinch::sim
