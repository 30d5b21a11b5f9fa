// SPDX-License-Identifier: MIT
#include "features/outline.h"

#include <algorithm>

namespace flinch::features {
namespace {

/// From the nearest point of a capsule's axis.
Clearance capsule_clearance(const Eigen::Vector3d& centre, double radius, const Outline& capsule) {
  const Eigen::Vector3d axis = capsule.orientation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d offset = centre - capsule.centre;
  const double along = std::clamp(offset.dot(axis), -capsule.half_length, capsule.half_length);
  const Eigen::Vector3d nearest = capsule.centre + along * axis;
  const Eigen::Vector3d separation = centre - nearest;
  const double distance = separation.norm();
  Clearance result;
  if (distance > 0) result.normal = separation / distance;
  result.gap = distance - radius - capsule.radius;
  result.point = nearest + capsule.radius * result.normal;
  return result;
}

/// From the nearest point of a box; from inside, through the nearest face.
Clearance box_clearance(const Eigen::Vector3d& centre, double radius, const Outline& box) {
  const Eigen::Vector3d local = box.orientation.conjugate() * (centre - box.centre);
  Eigen::Vector3d nearest = local.cwiseMax(-box.half_extents).cwiseMin(box.half_extents);
  Eigen::Vector3d normal = local - nearest;
  double distance = normal.norm();
  if (distance > 0) {
    normal /= distance;
  } else {
    int face = 0;
    distance = -(box.half_extents - local.cwiseAbs()).minCoeff(&face);
    const double side = local[face] < 0 ? -1.0 : 1.0;
    normal = side * Eigen::Vector3d::Unit(face);
    nearest[face] = side * box.half_extents[face];
  }
  return {distance - radius, box.centre + box.orientation * nearest, box.orientation * normal};
}

}  // namespace

double Outline::reach() const {
  return kind == motion::Shape::Kind::capsule ? half_length : half_extents.norm();
}

Outline outline_of(const motion::Shape& shape) {
  return {.kind = shape.kind,
          .radius = static_cast<double>(shape.radius),
          .half_length = static_cast<double>(shape.half_length),
          .half_extents = shape.half_extents.cast<double>(),
          .centre = shape.centre.cast<double>(),
          .orientation = shape.orientation.cast<double>().normalized()};
}

motion::PerBody<Outline> outlines_of(const motion::BodyModel& model,
                                     const motion::JointFrames& frames) {
  motion::PerBody<Outline> outlines;
  for (motion::Body body : motion::kBodies) {
    const motion::Role role = role_of(body);
    const Eigen::Quaterniond orientation = frames.orientation[role].cast<double>();
    Outline& outline = outlines[body];
    outline = outline_of(model[body].shape);
    outline.centre = frames.position[role].cast<double>() + orientation * outline.centre;
    outline.orientation = orientation * outline.orientation;
  }
  return outlines;
}

Clearance clearance(const Eigen::Vector3d& ball_centre, double ball_radius,
                    const Outline& outline) {
  return outline.kind == motion::Shape::Kind::capsule
             ? capsule_clearance(ball_centre, ball_radius, outline)
             : box_clearance(ball_centre, ball_radius, outline);
}

}  // namespace flinch::features
