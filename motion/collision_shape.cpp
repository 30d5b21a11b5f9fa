// SPDX-License-Identifier: MIT
#include "motion/collision_shape.h"

#include <algorithm>
#include <array>
#include <span>

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

/// A segment in the axes of an outline's core: the box within which a ball of the outline's radius
/// is the outline. A capsule's core is a box without width.
class SegmentBesideCore {
 public:
  SegmentBesideCore(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                    const CollisionShape& outline)
      : extents_(outline.kind == Shape::Kind::capsule ? Eigen::Vector3d(0, 0, outline.half_length)
                                                      : outline.half_extents),
        from_(outline.orientation.conjugate() * (from - outline.centre)),
        edge_(outline.orientation.conjugate() * (to - from)) {}

  // Half the derivative of the squared distance, d . (p - nearest(p)), never falls along the
  // segment, and is linear between the places where p crosses a face's plane.
  double nearest() const {
    std::array<double, 8> breaks{};  // ascending; 0 and 1 among them
    std::size_t count = 1;
    const auto insert = [&](double share) {
      std::size_t at = count++;
      for (; breaks[at - 1] > share; --at) breaks[at] = breaks[at - 1];
      breaks[at] = share;
    };
    for (int axis = 0; axis < 3; ++axis) {
      for (const double face : {-extents_[axis], extents_[axis]}) {
        const double share = (face - from_[axis]) / edge_[axis];  // not finite if parallel
        if (share > 0 && share < 1) insert(share);
      }
    }
    insert(1);
    // It is 0 where the segment is in the core, but for rounding.
    const double rounding = 1e-12 * edge_.squaredNorm();
    const std::span<const double> all = std::span(breaks).first(count);
    const double first = root(all, [rounding](double x) { return x >= -rounding; });
    const double last = root(all, [rounding](double x) { return x > rounding; });
    const double middle = 0.5 * (first + last);
    return depth_at(middle) > 0 ? deepest(first, last) : middle;
  }

 private:
  Eigen::Vector3d at(double share) const { return from_ + share * edge_; }
  double derivative_at(double share) const {
    const Eigen::Vector3d point = at(share);
    return edge_.dot(point - point.cwiseMax(-extents_).cwiseMin(extents_));
  }
  double depth_at(double share) const { return (extents_ - at(share).cwiseAbs()).minCoeff(); }

  /// Where the derivative first is such, at most 1.
  template <class Predicate>
  double root(std::span<const double> breaks, Predicate is_reached) const {
    double before = breaks.front();
    double value_before = derivative_at(before);
    if (is_reached(value_before)) return before;
    for (const double share : breaks.subspan(1)) {
      const double value = derivative_at(share);
      if (is_reached(value))
        return value > value_before
                   ? before + (share - before) *
                                  std::clamp(-value_before / (value - value_before), 0.0, 1.0)
                   : before;
      before = share;
      value_before = value;
    }
    return 1;
  }

  // The depth is concave along the segment.
  double deepest(double low, double high) const {
    constexpr int kThirds = 40;
    for (int i = 0; i < kThirds; ++i) {
      const double third = (high - low) / 3;
      if (depth_at(low + third) < depth_at(high - third)) {
        low += third;
      } else {
        high -= third;
      }
    }
    return 0.5 * (low + high);
  }

  Eigen::Vector3d extents_;
  Eigen::Vector3d from_;
  Eigen::Vector3d edge_;
};

}  // namespace

double nearest_share(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                     const CollisionShape& outline) {
  return SegmentBesideCore(from, to, outline).nearest();
}

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
