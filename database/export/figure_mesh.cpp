// SPDX-License-Identifier: MIT
#include "database/export/figure_mesh.h"

#include <algorithm>
#include <limits>

#include "motion/error.h"

namespace flinch::database {
namespace {

using Eigen::Quaternionf;
using Eigen::Vector3f;
using motion::Body;
using motion::BodyModel;
using motion::Role;
using motion::Shape;

constexpr int kSegments = 6;         // chords of a quarter circle
constexpr float kRounding = 0.7F;    // radius of a box's edges / its smallest half extent
constexpr float kJointSize = 0.85F;  // of a joint filler / the thinner of the adjacent parts

// A part of the mesh, in the frame of its joint.
struct Part {
  Mesh mesh;
  Quaternionf orientation = Quaternionf::Identity();
  Vector3f centre = Vector3f::Zero();
};

Part outline(const Shape& shape) {
  if (shape.kind == Shape::Kind::capsule) {
    return {rounded_solid({0, 0, shape.half_length}, shape.radius, kSegments), shape.orientation,
            shape.centre};
  }
  const float radius = kRounding * shape.half_extents.minCoeff();
  return {rounded_solid(shape.half_extents - Vector3f::Constant(radius), radius, kSegments),
          shape.orientation, shape.centre};
}

// In front of the upper skull, as wide as a pair of glasses.
Part visor(const Shape& skull) {
  const float radius = 0.16F * skull.radius;
  const Vector3f core = skull.radius * Vector3f(0.25F, 0.52F, 0.08F);
  const Vector3f eyes(0.72F * skull.radius, 0, 0.6F * skull.half_length);
  return {rounded_solid(core, radius, kSegments), skull.orientation,
          skull.centre + skull.orientation * eyes};
}

bool is_limb(Body body) {
  return body >= Body::left_upper_arm;
}

bool is_accent(Body body) {
  return body == Body::neck || body == Body::left_hand || body == Body::right_hand ||
         body == Body::left_foot || body == Body::right_foot;
}

// At the near end of a limb's part, as thick as the thinner of the two capsules.
Part joint_ball(const BodyModel& model, Body body) {
  const auto thickness = [&](Body part) {
    const Shape& shape = model[part].shape;
    return shape.kind == Shape::Kind::capsule ? shape.radius
                                              : std::numeric_limits<float>::infinity();
  };
  const float min_thickness = std::min(thickness(body), thickness(*motion::parent_of(body)));
  return {rounded_solid(Vector3f::Zero(), kJointSize * min_thickness, kSegments)};
}

// Between two boxes of the trunk, as broad and deep as the smaller one.
Part waist(const BodyModel& model, Body body) {
  const Vector3f extents = kJointSize * model[body].shape.half_extents.cwiseMin(
                                            model[*motion::parent_of(body)].shape.half_extents);
  const float radius = extents.minCoeff();
  return {rounded_solid({extents.x() - radius, extents.y() - radius, 0}, radius, kSegments)};
}

void add(const Part& part, Role joint, const Vector3f& joint_position, SkinnedMesh& whole) {
  append(part.mesh, part.orientation, joint_position + part.centre, whole.mesh);
  whole.joints.resize(whole.mesh.positions.size(), joint);
}

}  // namespace

FigureMesh figure_mesh(const motion::Physique& character) {
  const BodyModel model = motion::make_body_model(character);
  const motion::JointFrames rest =
      forward_kinematics(character.skeleton, motion::rest_pose(character.skeleton));
  FigureMesh figure;
  for (const Body body : motion::kBodies) {
    const Role joint = motion::role_of(body);
    const Shape& shape = model[body].shape;
    add(outline(shape), joint, rest.position[joint],
        is_accent(body) ? figure.accents : figure.body);
    if (is_limb(body)) add(joint_ball(model, body), joint, rest.position[joint], figure.accents);
    if (body == Body::abdomen || body == Body::chest) {
      add(waist(model, body), joint, rest.position[joint], figure.accents);
    }
  }
  add(visor(model[Body::head].shape), Role::head, rest.position[Role::head], figure.accents);

  for (const SkinnedMesh* mesh : {&figure.body, &figure.accents}) {
    const std::vector<Vector3f>& positions = mesh->mesh.positions;
    if (!std::all_of(positions.begin(), positions.end(),
                     [](const Vector3f& position) { return position.allFinite(); })) {
      throw Error("", "the character's body is too large to draw: check its skeleton and its mass");
    }
  }
  return figure;
}

}  // namespace flinch::database
