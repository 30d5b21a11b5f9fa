// SPDX-License-Identifier: MIT
#include "motion/body_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/segment.h"

namespace flinch::motion {

namespace {

// Frame of the outline in the world.
struct ShapeFrame {
  Eigen::Vector3f centre;
  Eigen::Quaternionf orientation;
};

ShapeFrame shape_frame(const Figure& figure, const JointFrames& frames, Body body) {
  const Shape& shape = figure.bodies[body].shape;
  const Role role = role_of(body);
  return {frames.position[role] + frames.orientation[role] * shape.centre,
          frames.orientation[role] * shape.orientation};
}

}  // namespace

Capsule capsule_of(const Figure& figure, const JointFrames& frames, Body body) {
  const Shape& shape = figure.bodies[body].shape;
  const ShapeFrame place = shape_frame(figure, frames, body);
  if (shape.kind == Shape::Kind::capsule) {
    const Eigen::Vector3f half = place.orientation * (shape.half_length * Eigen::Vector3f::UnitZ());
    return {place.centre - half, place.centre + half, shape.radius};
  }
  Eigen::Index longest = 0;
  const float half_length = shape.half_extents.maxCoeff(&longest);
  const float radius = shape.half_extents.minCoeff();
  const Eigen::Vector3f half =
      place.orientation * ((half_length - radius) * Eigen::Vector3f::Unit(longest));
  return {place.centre - half, place.centre + half, radius};
}

float distance_to(const Figure& figure, const JointFrames& frames, Body body,
                  const Eigen::Vector3f& point) {
  const Shape& shape = figure.bodies[body].shape;
  if (shape.kind == Shape::Kind::capsule) {
    const Capsule capsule = capsule_of(figure, frames, body);
    return std::max(
        (nearest_on_segment(capsule.from, capsule.to, point) - point).norm() - capsule.radius,
        0.0F);
  }
  const ShapeFrame place = shape_frame(figure, frames, body);
  const Eigen::Vector3f local = place.orientation.conjugate() * (point - place.centre);
  return (local.cwiseAbs() - shape.half_extents).cwiseMax(0).norm();
}

// The distance to a convex set is convex along a segment, so ternary search finds its minimum.
float distance_between(const Figure& figure, const JointFrames& frames, Body body,
                       const Capsule& capsule) {
  constexpr int kRounds = 28;  // (2/3)^28 of a metre is about 1e-5 m
  const auto at = [&](float t) {
    return distance_to(figure, frames, body, capsule.from + t * (capsule.to - capsule.from));
  };
  float low = 0;
  float high = 1;
  for (int round = 0; round < kRounds; ++round) {
    const float third = (high - low) / 3;
    if (at(low + third) <= at(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return at(0.5F * (low + high)) - capsule.radius;
}

float distance_to_figure(const Figure& figure, const JointFrames& frames,
                         const Eigen::Vector3f& point) {
  float min_distance = std::numeric_limits<float>::infinity();
  for (Body body : kBodies) {
    min_distance = std::min(min_distance, distance_to(figure, frames, body, point));
  }
  return min_distance;
}

// A ray leaves a box where it first leaves one of the three slabs; it meets the box only if it
// enters all slabs before that.
float clearance_along(const Figure& figure, const JointFrames& frames, const Eigen::Vector3f& point,
                      const Eigen::Vector3f& direction) {
  float farthest = 0;
  for (Body body : kCoreBodies) {
    const Shape& shape = figure.bodies[body].shape;
    const Eigen::Vector3f extents =
        shape.kind == Shape::Kind::box
            ? shape.half_extents
            : Eigen::Vector3f(shape.radius, shape.radius, shape.radius + shape.half_length);
    const ShapeFrame place = shape_frame(figure, frames, body);
    const Eigen::Vector3f from = place.orientation.conjugate() * (point - place.centre);
    const Eigen::Vector3f along = place.orientation.conjugate() * direction;
    float enter = -std::numeric_limits<float>::infinity();
    float leave = std::numeric_limits<float>::infinity();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      constexpr float kParallel = 1e-6F;
      const float slope = std::abs(along[axis]) < kParallel ? kParallel : along[axis];
      const float a = (-extents[axis] - from[axis]) / slope;
      const float b = (extents[axis] - from[axis]) / slope;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (leave >= enter) farthest = std::max(farthest, leave);
  }
  return farthest;
}

}  // namespace flinch::motion
