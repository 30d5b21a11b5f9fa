// SPDX-License-Identifier: MIT
#include "database/export/gltf_writer.h"

#include <algorithm>
#include <cmath>

#include "database/export/export_check.h"
#include "database/export/figure_mesh.h"
#include "database/export/glb.h"
#include "database/export/y_up.h"
#include "database/import/file_io.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

using Eigen::Quaternionf;
using Eigen::Vector3f;
using Json = nlohmann::ordered_json;
using motion::kRoles;
using motion::Role;

constexpr int kBallSegments = 10;  // chords of a quarter circle

// Indices of the nodes in the document.
enum Node : int { kFigureNode, kWorldNode, kFirstJointNode, kBallNode = 2 + motion::kRoleCount };
enum Material : int { kBodyMaterial, kAccentMaterial, kBallMaterial };

int node_of(Role joint) {
  return kFirstJointNode + static_cast<int>(joint);
}

template <class Vectors>
std::vector<float> floats_of(const Vectors& vectors) {
  std::vector<float> floats;
  for (const auto& vector : vectors) floats.insert(floats.end(), vector.begin(), vector.end());
  return floats;
}

std::vector<Vector3f> all_to_y_up(const std::vector<Vector3f>& vectors) {
  std::vector<Vector3f> turned;
  turned.reserve(vectors.size());
  for (const Vector3f& vector : vectors) turned.push_back(to_y_up(vector));
  return turned;
}

Json json_of(const Vector3f& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

/// Colour: linear red, green and blue.
Json material(const char* name, const std::array<double, 3>& colour, double roughness) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", Json::array({colour[0], colour[1], colour[2], 1})},
            {"metallicFactor", 0},
            {"roughnessFactor", roughness}}}};
}

// --- The figure, the ball ---

Json primitive(const Mesh& mesh, Material material, GltfBuffer& buffer) {
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : mesh.triangles) {
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
  const int positions =
      buffer.add(floats_of(mesh.positions), GltfElement::vec3, GltfTarget::vertices, true);
  const int normals = buffer.add(floats_of(mesh.normals), GltfElement::vec3, GltfTarget::vertices);
  return {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
          {"indices", buffer.add_indices(indices)},
          {"material", static_cast<int>(material)}};
}

// In glTF's axes: a skinned mesh is placed in the scene directly, whatever its node's transform.
Json skinned_primitive(SkinnedMesh skinned, Material material, GltfBuffer& buffer) {
  skinned.mesh.positions = all_to_y_up(skinned.mesh.positions);
  skinned.mesh.normals = all_to_y_up(skinned.mesh.normals);
  std::vector<std::uint8_t> joints;
  std::vector<std::uint8_t> weights;
  for (const Role joint : skinned.joints) {
    joints.insert(joints.end(), {static_cast<std::uint8_t>(joint), 0, 0, 0});
    weights.insert(weights.end(), {255, 0, 0, 0});
  }
  Json made = primitive(skinned.mesh, material, buffer);
  made["attributes"]["JOINTS_0"] =
      buffer.add(joints, GltfElement::vec4, GltfTarget::vertices, false);
  made["attributes"]["WEIGHTS_0"] =
      buffer.add(weights, GltfElement::vec4, GltfTarget::vertices, true);
  return made;
}

// Transforms from the mesh, in glTF's axes and the rest pose, to each joint's frame: back to our
// axes, then to the joint, whose axes are parallel to the world's. Column-major.
int inverse_bind_matrices(const motion::Skeleton& skeleton, GltfBuffer& buffer) {
  const motion::JointFrames rest = forward_kinematics(skeleton, motion::rest_pose(skeleton));
  std::vector<float> matrices;
  for (const Role role : kRoles) {
    const Vector3f& joint = rest.position[role];
    matrices.insert(matrices.end(), {0, 1, 0, 0,  // X of glTF is our Y
                                     0, 0, 1, 0,  // Y is our Z
                                     1, 0, 0, 0,  // Z is our X
                                     -joint.x(), -joint.y(), -joint.z(), 1});
  }
  return buffer.add(matrices, GltfElement::mat4);
}

// --- The nodes ---

Json joint_node(const motion::Skeleton& skeleton, Role joint) {
  Json node{{"name", motion::name_of(joint)}, {"translation", json_of(skeleton.offset[joint])}};
  Json children = Json::array();
  for (const Role role : kRoles) {
    if (motion::parent_of(role) == joint) children.push_back(node_of(role));
  }
  if (!children.empty()) node["children"] = std::move(children);
  return node;
}

Json nodes_of(const motion::Skeleton& skeleton, const std::vector<Vector3f>& ball) {
  Json nodes = Json::array();
  nodes.push_back({{"name", "figure"}, {"mesh", 0}, {"skin", 0}});
  nodes.push_back({{"name", "flinch"},
                   {"rotation", Json::array({-0.5, -0.5, -0.5, 0.5})},
                   {"children", Json::array({node_of(Role::pelvis)})}});
  for (const Role joint : kRoles) nodes.push_back(joint_node(skeleton, joint));
  if (!ball.empty()) {
    nodes[kWorldNode]["children"].push_back(static_cast<int>(kBallNode));
    nodes.push_back({{"name", "ball"}, {"translation", json_of(ball.front())}, {"mesh", 1}});
  }
  return nodes;
}

// --- The animation ---

class Animation {
 public:
  Animation(const motion::Motion& motion, GltfBuffer& buffer) : buffer_(buffer) {
    std::vector<float> times;
    for (std::size_t k = 0; k < motion.poses.size(); ++k) {
      times.push_back(static_cast<float>(static_cast<double>(k) / double{motion.rate_hz}));
    }
    times_ = buffer.add(times, GltfElement::scalar, GltfTarget::none, true);
  }

  void add(int node, const char* path, const std::vector<float>& values, GltfElement element,
           const char* interpolation = "LINEAR") {
    channels_.push_back(
        {{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers_.push_back({{"input", times_},
                         {"output", buffer_.add(values, element)},
                         {"interpolation", interpolation}});
  }

  Json json() const {
    return {{"name", "motion"}, {"channels", channels_}, {"samplers", samplers_}};
  }

 private:
  GltfBuffer& buffer_;
  int times_ = 0;
  Json channels_ = Json::array();
  Json samplers_ = Json::array();
};

// x y z w; each unit and in the hemisphere of the previous one.
std::vector<float> rotation_keys(const motion::Motion& motion, Role joint) {
  std::vector<float> keys;
  Eigen::Vector4d before = Quaternionf::Identity().coeffs().cast<double>();
  for (const motion::Pose& pose : motion.poses) {
    Eigen::Vector4d key = pose.rotation[joint].coeffs().cast<double>().normalized();
    if (key.dot(before) < 0) key = -key;
    for (const double number : key) keys.push_back(static_cast<float>(number));
    before = key;
  }
  return keys;
}

void animate_figure(const motion::Motion& motion, Animation& animation) {
  std::vector<Vector3f> pelvis;
  for (const motion::Pose& pose : motion.poses) pelvis.push_back(pose.root_position);
  animation.add(node_of(Role::pelvis), "translation", floats_of(pelvis), GltfElement::vec3);
  for (const Role joint : kRoles) {
    animation.add(node_of(joint), "rotation", rotation_keys(motion, joint), GltfElement::vec4);
  }
}

// Positions of the ball where it is visible or hidden; the origin if it is never visible.
std::vector<Vector3f> places_of(const BallTrack& ball) {
  const auto first = std::find_if(ball.positions.begin(), ball.positions.end(),
                                  [](const auto& position) { return position.has_value(); });
  Vector3f place = first == ball.positions.end() ? Vector3f(Vector3f::Zero()) : **first;
  std::vector<Vector3f> places;
  for (const std::optional<Vector3f>& position : ball.positions) {
    place = position.value_or(place);
    places.push_back(place);
  }
  return places;
}

void animate_ball(const BallTrack& ball, const std::vector<Vector3f>& places,
                  Animation& animation) {
  std::vector<Vector3f> scales;
  for (const std::optional<Vector3f>& position : ball.positions) {
    scales.push_back(Vector3f::Constant(position ? 1.0F : 0.0F));
  }
  animation.add(kBallNode, "translation", floats_of(places), GltfElement::vec3);
  animation.add(kBallNode, "scale", floats_of(scales), GltfElement::vec3, "STEP");
}

void check(const BallTrack& ball, std::size_t pose_count) {
  if (!std::isfinite(ball.radius) || ball.radius <= 0) {
    throw Error("", "the ball's radius is not above 0");
  }
  if (ball.positions.size() != pose_count) {
    throw Error("", "the ball has " + std::to_string(ball.positions.size()) +
                        " positions, the motion " + std::to_string(pose_count) +
                        " poses: give one per pose");
  }
  for (std::size_t k = 0; k < pose_count; ++k) {
    if (ball.positions[k] && !ball.positions[k]->allFinite()) {
      throw Error("", "position " + std::to_string(k) + " of the ball is not finite");
    }
  }
}

}  // namespace

std::vector<std::byte> make_glb(const motion::Physique& character, const motion::Motion& motion,
                                const std::optional<BallTrack>& ball) {
  check_exportable(character, motion);
  if (ball) check(*ball, motion.poses.size());
  const motion::Skeleton& skeleton = character.skeleton;
  const std::vector<Vector3f> places = ball ? places_of(*ball) : std::vector<Vector3f>();

  GltfBuffer buffer;
  const FigureMesh figure = figure_mesh(character);
  Json meshes = Json::array();
  meshes.push_back(
      {{"name", "figure"},
       {"primitives", Json::array({skinned_primitive(figure.body, kBodyMaterial, buffer),
                                   skinned_primitive(figure.accents, kAccentMaterial, buffer)})}});
  Json materials = Json::array(
      {material("body", {0.62, 0.58, 0.50}, 0.7), material("accents", {0.03, 0.10, 0.16}, 0.5)});
  Json joints = Json::array();
  for (const Role role : kRoles) joints.push_back(node_of(role));
  const int bind = inverse_bind_matrices(skeleton, buffer);

  Animation animation(motion, buffer);
  animate_figure(motion, animation);
  if (ball) {
    const Mesh sphere = rounded_solid(Vector3f::Zero(), ball->radius, kBallSegments);
    meshes.push_back({{"name", "ball"},
                      {"primitives", Json::array({primitive(sphere, kBallMaterial, buffer)})}});
    materials.push_back(material("ball", {0.85, 0.25, 0.03}, 0.4));
    animate_ball(*ball, places, animation);
  }

  return buffer.file(
      {{"asset", {{"version", "2.0"}, {"generator", "Flinch"}}},
       {"scene", 0},
       {"scenes", Json::array({{{"name", "scene"},
                                {"nodes", Json::array({int{kFigureNode}, int{kWorldNode}})}}})},
       {"nodes", nodes_of(skeleton, places)},
       {"meshes", std::move(meshes)},
       {"materials", std::move(materials)},
       {"skins", Json::array({{{"name", "figure"},
                               {"inverseBindMatrices", bind},
                               {"skeleton", node_of(Role::pelvis)},
                               {"joints", std::move(joints)}}})},
       {"animations", Json::array({animation.json()})}});
}

void write_glb(const std::string& path, const motion::Physique& character,
               const motion::Motion& motion, const std::optional<BallTrack>& ball) {
  const std::vector<std::byte> bytes = make_glb(character, motion, ball);
  write_file_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace flinch::database
