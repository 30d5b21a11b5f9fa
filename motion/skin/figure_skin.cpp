// SPDX-License-Identifier: MIT
#include "motion/skin/figure_skin.h"

#include <algorithm>

#include "motion/skin/figure_cage.h"

namespace flinch::motion {
namespace {

using Eigen::Vector3f;

ControlCage figure_cage(const Physique& character) {
  const CageGuide guide{character, make_body_model(character),
                        forward_kinematics(character.skeleton, rest_pose(character.skeleton))};
  CageBuilder builder;
  const TrunkEnds ends = add_trunk(guide, builder);
  add_head(guide, ends.neck, builder);
  for (const Side side : kSides) {
    add_arm(guide, side, ends.arms[side], builder);
    add_leg(guide, side, ends.legs[side], builder);
  }
  return std::move(builder).cage();
}

// Keeps the largest weights. One that equals the largest that is left out is left out too, so that
// the halves of a symmetric figure stay equal.
void add_vertex(const ControlCage::Vertex& vertex, FigureSkin& skin) {
  constexpr float kEqual = 1e-4F;
  std::array<Role, kRoleCount> roles = kRoles;
  std::stable_sort(roles.begin(), roles.end(),
                   [&](Role a, Role b) { return vertex.weights[a] > vertex.weights[b]; });
  const float left_out = vertex.weights[roles[kMaxSkinJoints]];
  std::array<Role, kMaxSkinJoints> joints{};
  std::array<float, kMaxSkinJoints> weights{};
  float sum = 0;
  for (std::size_t i = 0; i < kMaxSkinJoints; ++i) {
    if (vertex.weights[roles[i]] <= left_out + kEqual) break;
    joints[i] = roles[i];
    weights[i] = vertex.weights[roles[i]];
    sum += weights[i];
  }
  for (float& weight : weights) weight /= sum;
  skin.positions.push_back(vertex.position);
  skin.joints.push_back(joints);
  skin.weights.push_back(weights);
}

}  // namespace

FigureSkin make_figure_skin(const Physique& character) {
  const ControlCage cage = subdivided(figure_cage(character));
  FigureSkin skin;
  for (const ControlCage::Vertex& vertex : cage.vertices) add_vertex(vertex, skin);
  skin.normals.assign(skin.positions.size(), Vector3f::Zero());
  for (const ControlCage::Face& face : cage.faces) {
    const Vector3f& a = skin.positions[face.corners[0]];
    const Vector3f& b = skin.positions[face.corners[1]];
    const Vector3f& c = skin.positions[face.corners[2]];
    const Vector3f& d = skin.positions[face.corners[3]];
    const Vector3f area = (c - a).cross(d - b);
    for (const std::uint32_t corner : face.corners) skin.normals[corner] += area;
    auto& triangles = skin.triangles[face.covering];
    triangles.push_back({face.corners[0], face.corners[1], face.corners[2]});
    triangles.push_back({face.corners[0], face.corners[2], face.corners[3]});
  }
  for (Vector3f& normal : skin.normals) normal.normalize();
  return skin;
}

}  // namespace flinch::motion
