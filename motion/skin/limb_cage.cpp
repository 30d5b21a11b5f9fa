// SPDX-License-Identifier: MIT
#include "motion/skin/limb_cage.h"

#include <cmath>

namespace flinch::motion {
namespace {

using Eigen::Vector3f;

// A subdivided ring of eight points lies this much farther out than its vertices' mean. (6 + 2 cos
// 45 degrees) / 8 of the radius remains.
constexpr float kGrowth = 1.08F;

// Half extents of the bone's outline across it: forward and sideways.
Eigen::Vector2f half_extents(const CageGuide& guide, Role bone) {
  const Shape& shape = guide.bodies[body_of(bone)].shape;
  if (shape.kind == Shape::Kind::capsule) return Eigen::Vector2f::Constant(shape.radius);
  return {shape.half_extents.x(), shape.half_extents.z()};
}

// From the bone's joint to the next one of the limb, or to the fingertips.
Vector3f bone_vector(const Skeleton& skeleton, Role bone) {
  for (const Role role : kRoles) {
    if (parent_of(role) == bone) return skeleton.offset[role];
  }
  return skeleton.tip[bone];
}

}  // namespace

LimbAxes limb_axes(Side side, const Vector3f& direction, const Vector3f& default_direction) {
  const Vector3f along =
      direction.norm() > 1e-6F ? Vector3f(direction.normalized()) : default_direction;
  const Vector3f forward =
      std::abs(along.x()) < 0.9F ? Vector3f::UnitX() : Vector3f(-Vector3f::UnitZ());
  const Vector3f front = (forward - forward.dot(along) * along).normalized();
  return {along, front, sign_of(side) * front.cross(along)};
}

std::array<Vector3f, 8> section_points(const LimbAxes& axes, const Vector3f& centre,
                                       const Section& section) {
  const auto at = [&](float forward, float sideways) -> Vector3f {
    return centre + kGrowth * (forward * axes.front + sideways * axes.side);
  };
  const float c = section.corner;
  return {at(section.front, 0),       at(c * section.front, c * section.side),
          at(0, section.side),        at(-c * section.back, c * section.side),
          at(-section.back, 0),       at(-c * section.back, -c * section.other_side),
          at(0, -section.other_side), at(c * section.front, -c * section.other_side)};
}

Ring add_limb_row(const CageGuide& guide, Side side, const LimbRow& row, CageBuilder& builder) {
  const Skeleton& skeleton = guide.character.skeleton;
  const Role bone = role_on(side, row.left_bone);
  const Role parent = *parent_of(bone);
  const bool is_arm = row.left_bone < Role::left_thigh;
  const Vector3f default_direction =
      is_arm ? Vector3f(sign_of(side) * Vector3f::UnitY()) : Vector3f(-Vector3f::UnitZ());
  const Vector3f to_end = bone_vector(skeleton, bone);
  const LimbAxes axes = limb_axes(side, to_end, default_direction);
  const Eigen::Vector2f extents = half_extents(guide, bone);
  Section section = row.section;
  section.front *= extents.x();
  section.back *= extents.x();
  section.side *= extents.y();
  section.other_side *= extents.y();

  JointWeights weights = joint_weights(
      {{parent, row.parent_weight}, {bone, 1 - row.parent_weight - row.child_weight}});
  for (const Role child : kRoles) {
    if (parent_of(child) == bone) weights[child] += row.child_weight;
  }
  return builder.add(section_points(axes, guide.joint(bone) + row.along * to_end, section),
                     weights);
}

}  // namespace flinch::motion
