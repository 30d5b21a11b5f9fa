// SPDX-License-Identifier: MIT
#include "database/export/gltf_writer.h"

#include <algorithm>
#include <cmath>

#include "database/export/export_check.h"
#include "database/export/glb.h"
#include "database/export/solid_mesh.h"
#include "database/export/y_up.h"
#include "database/files/file_io.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "motion/skin/figure_skin.h"

namespace flinch::database {
namespace {

using Eigen::Quaternionf;
using Eigen::Vector3f;
using Json = nlohmann::ordered_json;
using motion::kRoles;
using motion::Role;

constexpr int kBallSegments = 10;  // chords of a quarter circle

// Indices of the nodes in the document.
enum Node : int { kFigureNode, kFirstJointNode, kBallNode = 1 + motion::kRoleCount };

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

// --- Materials ---

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

// --- The figure, the ball ---

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

// One primitive per covering; all share the vertices. Weights are floats: Assimp 5.2.5 reads
// normalised bytes wrongly.
Json figure_mesh(const motion::FigureSkin& skin, GltfBuffer& buffer) {
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

Json ball_mesh(float radius, GltfBuffer& buffer) {
  const Mesh sphere = rounded_solid(Vector3f::Zero(), radius, kBallSegments);
  const Json attributes = surface(sphere.positions, sphere.normals, buffer);
  return {{"name", "ball"},
          {"primitives",
           Json::array({primitive(attributes, sphere.triangles, motion::kCoveringCount, buffer)})}};
}

// Transforms from the mesh, in the rest pose, to each joint's frame, whose axes are parallel to the
// world's there. Column-major.
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

// --- The nodes ---

Json joint_node(const motion::Skeleton& skeleton, Role joint) {
  Json node{{"name", motion::name_of(joint)},
            {"translation", json_of(to_y_up(skeleton.offset[joint]))}};
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
  for (const Role joint : kRoles) nodes.push_back(joint_node(skeleton, joint));
  if (!ball.empty()) {
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

  Json json(const std::string& name, const Json& extras) const {
    Json animation{{"name", name}, {"channels", channels_}, {"samplers", samplers_}};
    if (!extras.empty()) animation["extras"] = extras;
    return animation;
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
    Eigen::Vector4d key = to_y_up(pose.rotation[joint]).coeffs().cast<double>().normalized();
    if (key.dot(before) < 0) key = -key;
    for (const double number : key) keys.push_back(static_cast<float>(number));
    before = key;
  }
  return keys;
}

void animate_figure(const motion::Motion& motion, Animation& animation) {
  std::vector<Vector3f> pelvis;
  for (const motion::Pose& pose : motion.poses) pelvis.push_back(to_y_up(pose.root_position));
  animation.add(node_of(Role::pelvis), "translation", floats_of(pelvis), GltfElement::vec3);
  for (const Role joint : kRoles) {
    animation.add(node_of(joint), "rotation", rotation_keys(motion, joint), GltfElement::vec4);
  }
}

// Positions of the ball where it is visible or hidden, in glTF's axes; the origin if it is never
// visible.
std::vector<Vector3f> places_of(const BallTrack& ball) {
  const auto first = std::find_if(ball.positions.begin(), ball.positions.end(),
                                  [](const auto& position) { return position.has_value(); });
  Vector3f place = first == ball.positions.end() ? Vector3f(Vector3f::Zero()) : to_y_up(**first);
  std::vector<Vector3f> places;
  for (const std::optional<Vector3f>& position : ball.positions) {
    if (position) place = to_y_up(*position);
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

// A float's decimal digits, without those that come from its conversion to double.
double decimal(float number) {
  return std::round(double{number} * 1e5) / 1e5;
}

Json extras_of(const MotionFacts& facts) {
  Json extras = Json::object();
  if (!facts.clip.empty()) extras["clip"] = facts.clip;
  if (const auto& annotation = facts.annotation) {
    extras["target"] = motion::name_of(annotation->target);
    extras["direction_degrees"] = std::lround(motion::degrees(annotation->direction));
    extras["degree"] = motion::name_of(annotation->degree);
    extras["onset_s"] = decimal(annotation->onset_s);
    extras["peak_s"] = decimal(annotation->peak_s);
    extras["end_s"] = decimal(annotation->end_s);
  }
  if (facts.impact_s) extras["impact_s"] = decimal(*facts.impact_s);
  if (facts.contact_s) extras["contact_s"] = decimal(*facts.contact_s);
  if (facts.hit_body) extras["hit_body"] = motion::name_of(*facts.hit_body);
  if (facts.impulse_ns) extras["impulse_ns"] = decimal(*facts.impulse_ns);
  return extras;
}

// --- The file ---

// What a file holds beside its animations.
struct Scene {
  GltfBuffer buffer;
  Json meshes = Json::array();
  Json materials = Json::array();
  Json roots = Json::array({int{kFigureNode}, node_of(Role::pelvis)});
  int bind = 0;
};

Scene scene_of(const motion::Physique& character) {
  Scene scene;
  scene.meshes.push_back(figure_mesh(motion::make_figure_skin(character), scene.buffer));
  for (const Material& material : kMaterials) scene.materials.push_back(json_of(material));
  scene.bind = inverse_bind_matrices(character.skeleton, scene.buffer);
  return scene;
}

std::vector<std::byte> file_of(const motion::Skeleton& skeleton, const std::vector<Vector3f>& ball,
                               Scene scene, Json animations) {
  Json joints = Json::array();
  for (const Role role : kRoles) joints.push_back(node_of(role));
  return scene.buffer.file(
      {{"asset", {{"version", "2.0"}, {"generator", "Flinch " FLINCH_VERSION}}},
       {"scene", 0},
       {"scenes", Json::array({{{"name", "scene"}, {"nodes", std::move(scene.roots)}}})},
       {"nodes", nodes_of(skeleton, ball)},
       {"meshes", std::move(scene.meshes)},
       {"materials", std::move(scene.materials)},
       {"skins", Json::array({{{"name", "figure"},
                               {"inverseBindMatrices", scene.bind},
                               {"skeleton", node_of(Role::pelvis)},
                               {"joints", std::move(joints)}}})},
       {"animations", std::move(animations)}});
}

void write_bytes(const std::string& path, const std::vector<std::byte>& bytes) {
  write_file_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

std::vector<std::byte> make_glb(const motion::Physique& character, const motion::Motion& motion,
                                const std::optional<BallTrack>& ball, const MotionFacts& facts) {
  check_exportable(character, motion);
  if (ball) check(*ball, motion.poses.size());
  const std::vector<Vector3f> places = ball ? places_of(*ball) : std::vector<Vector3f>();
  Scene scene = scene_of(character);
  Animation animation(motion, scene.buffer);
  animate_figure(motion, animation);
  if (ball) {
    scene.meshes.push_back(ball_mesh(ball->radius, scene.buffer));
    scene.materials.push_back(json_of(kBallMaterial));
    scene.roots.push_back(int{kBallNode});
    animate_ball(*ball, places, animation);
  }
  Json animations = Json::array({animation.json("motion", extras_of(facts))});
  return file_of(character.skeleton, places, std::move(scene), std::move(animations));
}

std::vector<std::byte> make_glb(const motion::Physique& character,
                                std::span<const NamedMotion> motions) {
  if (motions.empty()) throw Error("", "there are no motions to write");
  for (const NamedMotion& one : motions) check_exportable(character, one.motion);
  Scene scene = scene_of(character);
  Json animations = Json::array();
  for (const NamedMotion& one : motions) {
    Animation animation(one.motion, scene.buffer);
    animate_figure(one.motion, animation);
    animations.push_back(animation.json(one.name, extras_of(one.facts)));
  }
  return file_of(character.skeleton, {}, std::move(scene), std::move(animations));
}

void write_glb(const std::string& path, const motion::Physique& character,
               const motion::Motion& motion, const std::optional<BallTrack>& ball,
               const MotionFacts& facts) {
  write_bytes(path, make_glb(character, motion, ball, facts));
}

void write_glb(const std::string& path, const motion::Physique& character,
               std::span<const NamedMotion> motions) {
  write_bytes(path, make_glb(character, motions));
}

}  // namespace flinch::database
