// SPDX-License-Identifier: MIT
#include "motion/collision_shape.h"

#include <algorithm>

namespace flinch::motion {
namespace {

/// The rotated Z axis, to the bits of Eigen's product, without the terms that are zero.
Eigen::Vector3d axis_of(const CollisionShape& capsule) {
  const Eigen::Quaterniond& q = capsule.orientation;
  return {q.w() * (2 * q.y()) + q.z() * (2 * q.x()), q.w() * (-2 * q.x()) + q.z() * (2 * q.y()),
          1 + (q.x() * (-2 * q.x()) - q.y() * (2 * q.y()))};
}

Eigen::Vector3d nearest_on_axis(const Eigen::Vector3d& centre, const CollisionShape& capsule) {
  const Eigen::Vector3d axis = axis_of(capsule);
  const Eigen::Vector3d offset = centre - capsule.centre;
  const double along = std::clamp(offset.dot(axis), -capsule.half_length, capsule.half_length);
  return capsule.centre + along * axis;
}

/// Measured from the nearest point on a capsule's axis.
Clearance capsule_clearance(const Eigen::Vector3d& centre, double radius,
                            const CollisionShape& capsule) {
  const Eigen::Vector3d nearest = nearest_on_axis(centre, capsule);
  const Eigen::Vector3d separation = centre - nearest;
  const double distance = separation.norm();
  Clearance result;
  if (distance > 0) result.normal = separation / distance;
  result.gap = distance - radius - capsule.radius;
  result.point = nearest + capsule.radius * result.normal;
  return result;
}

/// A point in a box's own axes, and the point of the box that is nearest to it.
struct InBox {
  InBox(const Eigen::Vector3d& point, const CollisionShape& box)
      : local(box.orientation.conjugate() * (point - box.centre)),
        nearest(local.cwiseMax(-box.half_extents).cwiseMin(box.half_extents)),
        distance((local - nearest).norm()) {}

  Eigen::Vector3d local;
  Eigen::Vector3d nearest;
  double distance;
};

/// For a point inside: the gap (at most 0) to the nearest face, and which face that is.
double way_out(const InBox& in, const CollisionShape& box, int& face) {
  return -(box.half_extents - in.local.cwiseAbs()).minCoeff(&face);
}

/// Measured from the nearest point of a box; from inside, through the nearest face.
Clearance box_clearance(const Eigen::Vector3d& centre, double radius, const CollisionShape& box) {
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

double box_gap(const Eigen::Vector3d& centre, double radius, const CollisionShape& box) {
  const InBox in(centre, box);
  int face = 0;
  return (in.distance > 0 ? in.distance : way_out(in, box, face)) - radius;
}

}  // namespace

double CollisionShape::reach() const {
  return kind == Shape::Kind::capsule ? half_length : half_extents.norm();
}

CollisionShape collision_shape_of(const Shape& shape) {
  return {.kind = shape.kind,
          .radius = static_cast<double>(shape.radius),
          .half_length = static_cast<double>(shape.half_length),
          .half_extents = shape.half_extents.cast<double>(),
          .centre = shape.centre.cast<double>(),
          .orientation = shape.orientation.cast<double>().normalized()};
}

CollisionShape collision_shape_of(const BodyModel& model, const JointFrames& frames, Body body) {
  const Role role = role_of(body);
  const Eigen::Quaterniond orientation = frames.orientation[role].cast<double>();
  CollisionShape outline = collision_shape_of(model[body].shape);
  outline.centre = frames.position[role].cast<double>() + orientation * outline.centre;
  outline.orientation = orientation * outline.orientation;
  return outline;
}

PerBody<CollisionShape> collision_shapes_of(const BodyModel& model, const JointFrames& frames) {
  PerBody<CollisionShape> outlines;
  for (Body body : kBodies) outlines[body] = collision_shape_of(model, frames, body);
  return outlines;
}

Clearance clearance(const Eigen::Vector3d& ball_centre, double ball_radius,
                    const CollisionShape& outline) {
  return outline.kind == Shape::Kind::capsule ? capsule_clearance(ball_centre, ball_radius, outline)
                                              : box_clearance(ball_centre, ball_radius, outline);
}

double gap(const Eigen::Vector3d& ball_centre, double ball_radius, const CollisionShape& outline) {
  return outline.kind == Shape::Kind::capsule
             ? (ball_centre - nearest_on_axis(ball_centre, outline)).norm() - ball_radius -
                   outline.radius
             : box_gap(ball_centre, ball_radius, outline);
}

}  // namespace flinch::motion
