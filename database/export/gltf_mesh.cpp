// SPDX-License-Identifier: MIT
#include "database/export/gltf_mesh.h"

#include "database/export/solid_mesh.h"
#include "database/export/y_up.h"
#include "motion/skin/figure_skin.h"

namespace flinch::database {
namespace {

using Eigen::Vector3f;
using Json = nlohmann::ordered_json;
using motion::kRoles;
using motion::Role;

constexpr int kBallSegments = 10;  // chords of a quarter circle

std::vector<Vector3f> all_to_y_up(const std::vector<Vector3f>& vectors) {
  std::vector<Vector3f> turned;
  turned.reserve(vectors.size());
  for (const Vector3f& vector : vectors) turned.push_back(to_y_up(vector));
  return turned;
}

struct Material {
  const char* name;
  std::array<double, 3> colour;  // linear red, green and blue
  double roughness;
};
constexpr motion::PerCovering<Material> kMaterials{{{
    {"skin", {0.56, 0.33, 0.23}, 0.6},
    {"hair", {0.035, 0.022, 0.016}, 0.7},
    {"eyes", {0.02, 0.02, 0.025}, 0.3},
    {"lips", {0.32, 0.12, 0.09}, 0.6},
    {"shirt", {0.10, 0.24, 0.36}, 0.85},
    {"trousers", {0.06, 0.065, 0.08}, 0.85},
    {"shoes", {0.35, 0.34, 0.32}, 0.7},
}}};
constexpr Material kBallMaterial{"ball", {0.85, 0.25, 0.03}, 0.4};

Json json_of(const Material& material) {
  const auto& [red, green, blue] = material.colour;
  return {{"name", material.name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", Json::array({red, green, blue, 1})},
            {"metallicFactor", 0},
            {"roughnessFactor", material.roughness}}}};
}

template <class Triangles>
int add_triangles(const Triangles& triangles, GltfBuffer& buffer) {
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : triangles) {
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
  return buffer.add_indices(indices);
}

template <class Triangles>
Json primitive(const Json& attributes, const Triangles& triangles, int material,
               GltfBuffer& buffer) {
  return {{"attributes", attributes},
          {"indices", add_triangles(triangles, buffer)},
          {"material", material}};
}

Json surface(const std::vector<Vector3f>& positions, const std::vector<Vector3f>& normals,
             GltfBuffer& buffer) {
  return {{"POSITION", buffer.add(floats_of(all_to_y_up(positions)), GltfElement::vec3,
                                  GltfTarget::vertices, true)},
          {"NORMAL",
           buffer.add(floats_of(all_to_y_up(normals)), GltfElement::vec3, GltfTarget::vertices)}};
}

}  // namespace

Json figure_materials() {
  Json materials = Json::array();
  for (const Material& material : kMaterials) materials.push_back(json_of(material));
  return materials;
}

Json ball_material() {
  return json_of(kBallMaterial);
}

// Weights are floats: Assimp 5.2.5 reads normalised bytes wrongly.
Json figure_mesh(const motion::Physique& character, GltfBuffer& buffer) {
  const motion::FigureSkin skin = motion::make_figure_skin(character);
  std::vector<std::uint8_t> joints;
  for (const auto& vertex : skin.joints) {
    for (const Role joint : vertex) joints.push_back(static_cast<std::uint8_t>(joint));
  }
  Json attributes = surface(skin.positions, skin.normals, buffer);
  attributes["JOINTS_0"] = buffer.add(joints, GltfElement::vec4, GltfTarget::vertices);
  attributes["WEIGHTS_0"] =
      buffer.add(floats_of(skin.weights), GltfElement::vec4, GltfTarget::vertices);
  Json primitives = Json::array();
  for (const motion::Covering covering : motion::kCoverings) {
    primitives.push_back(
        primitive(attributes, skin.triangles[covering], static_cast<int>(covering), buffer));
  }
  return {{"name", "figure"}, {"primitives", std::move(primitives)}};
}

Json ball_mesh(float radius, float half_length, GltfBuffer& buffer) {
  const Mesh sphere = rounded_solid({half_length, 0, 0}, radius, kBallSegments);
  const Json attributes = surface(sphere.positions, sphere.normals, buffer);
  return {{"name", "ball"},
          {"primitives",
           Json::array({primitive(attributes, sphere.triangles, motion::kCoveringCount, buffer)})}};
}

// Column-major.
int inverse_bind_matrices(const motion::Skeleton& skeleton, GltfBuffer& buffer) {
  const motion::JointFrames rest = forward_kinematics(skeleton, motion::rest_pose(skeleton));
  std::vector<float> matrices;
  for (const Role role : kRoles) {
    const Vector3f joint = to_y_up(rest.position[role]);
    matrices.insert(matrices.end(), {1, 0, 0, 0,  //
                                     0, 1, 0, 0,  //
                                     0, 0, 1, 0,  //
                                     -joint.x(), -joint.y(), -joint.z(), 1});
  }
  return buffer.add(matrices, GltfElement::mat4);
}

}  // namespace flinch::database
