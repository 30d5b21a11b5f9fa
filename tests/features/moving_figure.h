// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/impact_prediction.h"
#include "motion/collision_shape.h"
#include "motion/default_character.h"

namespace flinch::tests {

/// The default character, standing with its arms down and swaying: the trunk turns, the arms swing
/// and the pelvis circles, with up to about 0.5 m/s at the hands.
struct SwayingFigure {
  motion::Physique character = motion::default_character();
  motion::BodyModel model = make_body_model(character);
  motion::Pose standing = swayed(0);
  motion::Motion idle = swaying();
  features::MotionBounds motion_bounds =
      features::motion_bounds_of(character.skeleton, model, idle);
  features::CollisionFigure collision_figure =
      features::make_collision_figure(character.skeleton, model);

  SwayingFigure() = default;
  SwayingFigure(const SwayingFigure&) = delete;
  SwayingFigure& operator=(const SwayingFigure&) = delete;

  /// Computed directly from the joints, in double.
  motion::PerBody<motion::CollisionShape> outlines(const motion::Pose& pose) const {
    const motion::JointFrames frames = forward_kinematics(character.skeleton, pose);
    motion::PerBody<motion::CollisionShape> outlines;
    for (motion::Body body : motion::kBodies) {
      const motion::Role role = role_of(body);
      const motion::Shape& shape = model[body].shape;
      motion::CollisionShape& outline = outlines[body];
      outline = motion::collision_shape_of(shape);
      outline.centre =
          (frames.position[role] + frames.orientation[role] * shape.centre).cast<double>();
      outline.orientation = (frames.orientation[role] * shape.orientation).cast<double>();
    }
    return outlines;
  }
  double gap_of(motion::Body body, const motion::Pose& pose, const Eigen::Vector3d& ball,
                double radius) const {
    return clearance(ball, radius, outlines(pose)[body]).gap;
  }
  /// Gap to the nearest body.
  double gap(const motion::Pose& pose, const Eigen::Vector3d& ball, double radius) const {
    double min_gap = std::numeric_limits<double>::infinity();
    for (const motion::CollisionShape& outline : outlines(pose)) {
      min_gap = std::min(min_gap, clearance(ball, radius, outline).gap);
    }
    return min_gap;
  }

 private:
  motion::Pose swayed(float phase) const {
    using motion::Role;
    const auto turned = [](float angle, const Eigen::Vector3f& axis) {
      return Eigen::Quaternionf(Eigen::AngleAxisf(angle, axis));
    };
    const Eigen::Vector3f x = Eigen::Vector3f::UnitX();
    const Eigen::Vector3f z = Eigen::Vector3f::UnitZ();
    motion::Pose pose = rest_pose(character.skeleton);
    pose.root_position +=
        Eigen::Vector3f(0.03F * std::sin(phase), 0.04F * std::cos(phase) - 0.04F, 0);
    pose.rotation[Role::abdomen] = turned(0.2F * std::sin(phase), z);
    pose.rotation[Role::left_upper_arm] = turned(-1.3F + 0.2F * std::sin(2 * phase), x);
    pose.rotation[Role::right_upper_arm] = turned(1.3F - 0.2F * std::sin(2 * phase), x);
    return pose;
  }

  motion::Motion swaying() const {
    motion::Motion motion;
    for (int i = 0; i <= 150; ++i) motion.poses.push_back(swayed(static_cast<float>(i) / 50));
    return motion;
  }
};

}  // namespace flinch::tests
