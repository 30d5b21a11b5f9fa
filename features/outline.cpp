// SPDX-License-Identifier: MIT
#include "features/outline.h"

#include <algorithm>

namespace flinch::features {
namespace {

/// The Z axis turned, to the bits of Eigen's product without the terms that are nothing.
Eigen::Vector3d axis_of(const Outline& capsule) {
  const Eigen::Quaterniond& q = capsule.orientation;
  return {q.w() * (2 * q.y()) + q.z() * (2 * q.x()), q.w() * (-2 * q.x()) + q.z() * (2 * q.y()),
          1 + (q.x() * (-2 * q.x()) - q.y() * (2 * q.y()))};
}

Eigen::Vector3d nearest_on_axis(const Eigen::Vector3d& centre, const Outline& capsule) {
  const Eigen::Vector3d axis = axis_of(capsule);
  const Eigen::Vector3d offset = centre - capsule.centre;
  const double along = std::clamp(offset.dot(axis), -capsule.half_length, capsule.half_length);
  return capsule.centre + along * axis;
}

/// From the nearest point of a capsule's axis.
Clearance capsule_clearance(const Eigen::Vector3d& centre, double radius, const Outline& capsule) {
  const Eigen::Vector3d nearest = nearest_on_axis(centre, capsule);
  const Eigen::Vector3d separation = centre - nearest;
  const double distance = separation.norm();
  Clearance result;
  if (distance > 0) result.normal = separation / distance;
  result.gap = distance - radius - capsule.radius;
  result.point = nearest + capsule.radius * result.normal;
  return result;
}

/// Where a point is in a box's own axes, and the point of the box that is nearest to it.
struct InBox {
  InBox(const Eigen::Vector3d& point, const Outline& box)
      : local(box.orientation.conjugate() * (point - box.centre)),
        nearest(local.cwiseMax(-box.half_extents).cwiseMin(box.half_extents)),
        distance((local - nearest).norm()) {}

  Eigen::Vector3d local;
  Eigen::Vector3d nearest;
  double distance;
};

/// From inside, the way out through the nearest face, and which that is: 0 or below.
double way_out(const InBox& in, const Outline& box, int& face) {
  return -(box.half_extents - in.local.cwiseAbs()).minCoeff(&face);
}

/// From the nearest point of a box; from inside, through the nearest face.
Clearance box_clearance(const Eigen::Vector3d& centre, double radius, const Outline& box) {
  InBox in(centre, box);
  Eigen::Vector3d normal = in.local - in.nearest;
  if (in.distance > 0) {
    normal /= in.distance;
  } else {
    int face = 0;
    in.distance = way_out(in, box, face);
    const double side = in.local[face] < 0 ? -1.0 : 1.0;
    normal = side * Eigen::Vector3d::Unit(face);
    in.nearest[face] = side * box.half_extents[face];
  }
  return {in.distance - radius, box.centre + box.orientation * in.nearest,
          box.orientation * normal};
}

double box_gap(const Eigen::Vector3d& centre, double radius, const Outline& box) {
  const InBox in(centre, box);
  int face = 0;
  return (in.distance > 0 ? in.distance : way_out(in, box, face)) - radius;
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

Outline outline_of(const motion::BodyModel& model, const motion::JointFrames& frames,
                   motion::Body body) {
  const motion::Role role = role_of(body);
  const Eigen::Quaterniond orientation = frames.orientation[role].cast<double>();
  Outline outline = outline_of(model[body].shape);
  outline.centre = frames.position[role].cast<double>() + orientation * outline.centre;
  outline.orientation = orientation * outline.orientation;
  return outline;
}

motion::PerBody<Outline> outlines_of(const motion::BodyModel& model,
                                     const motion::JointFrames& frames) {
  motion::PerBody<Outline> outlines;
  for (motion::Body body : motion::kBodies) outlines[body] = outline_of(model, frames, body);
  return outlines;
}

Clearance clearance(const Eigen::Vector3d& ball_centre, double ball_radius,
                    const Outline& outline) {
  return outline.kind == motion::Shape::Kind::capsule
             ? capsule_clearance(ball_centre, ball_radius, outline)
             : box_clearance(ball_centre, ball_radius, outline);
}

double gap(const Eigen::Vector3d& ball_centre, double ball_radius, const Outline& outline) {
  return outline.kind == motion::Shape::Kind::capsule
             ? (ball_centre - nearest_on_axis(ball_centre, outline)).norm() - ball_radius -
                   outline.radius
             : box_gap(ball_centre, ball_radius, outline);
}

}  // namespace flinch::features
