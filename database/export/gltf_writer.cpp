// SPDX-License-Identifier: MIT
#include "database/export/gltf_writer.h"

#include <algorithm>
#include <cmath>

#include "database/export/export_check.h"
#include "database/export/glb.h"
#include "database/export/gltf_mesh.h"
#include "database/export/y_up.h"
#include "database/files/file_io.h"
#include "motion/error.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

using Eigen::Quaternionf;
using Eigen::Vector3f;
using Json = nlohmann::ordered_json;
using motion::kRoles;
using motion::Role;

// Indices of the nodes in the document: those of each figure, then the ball.
constexpr int kNodesPerFigure = 1 + motion::kRoleCount;

int figure_node(int figure) {
  return kNodesPerFigure * figure;
}
int node_of(Role joint, int figure) {
  return figure_node(figure) + 1 + static_cast<int>(joint);
}
constexpr int kBallNode = kNodesPerFigure;  // beside one figure

Json json_of(const Vector3f& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

// --- The nodes ---

// Names are unique in a file.
std::string name_in(std::string_view name, int figure) {
  return figure == 0 ? std::string(name) : std::string(name) + "_" + std::to_string(figure + 1);
}

Json joint_node(const motion::Skeleton& skeleton, Role joint, int figure) {
  Json node{{"name", name_in(motion::name_of(joint), figure)},
            {"translation", json_of(to_y_up(skeleton.offset[joint]))}};
  Json children = Json::array();
  for (const Role role : kRoles) {
    if (motion::parent_of(role) == joint) children.push_back(node_of(role, figure));
  }
  if (!children.empty()) node["children"] = std::move(children);
  return node;
}

Json nodes_of(const motion::Skeleton& skeleton, int figures, const std::vector<Vector3f>& ball) {
  Json nodes = Json::array();
  for (int figure = 0; figure < figures; ++figure) {
    nodes.push_back({{"name", name_in("figure", figure)}, {"mesh", 0}, {"skin", figure}});
    for (const Role joint : kRoles) nodes.push_back(joint_node(skeleton, joint, figure));
  }
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
std::vector<float> rotation_keys(std::size_t count, auto rotation_at) {
  std::vector<float> keys;
  Eigen::Vector4d before = Quaternionf::Identity().coeffs().cast<double>();
  for (std::size_t k = 0; k < count; ++k) {
    Eigen::Vector4d key = to_y_up(Quaternionf(rotation_at(k))).coeffs().cast<double>().normalized();
    if (key.dot(before) < 0) key = -key;
    for (const double number : key) keys.push_back(static_cast<float>(number));
    before = key;
  }
  return keys;
}

void animate_figure(const motion::Motion& motion, int figure, Animation& animation) {
  std::vector<Vector3f> pelvis;
  for (const motion::Pose& pose : motion.poses) pelvis.push_back(to_y_up(pose.root_position));
  animation.add(node_of(Role::pelvis, figure), "translation", floats_of(pelvis), GltfElement::vec3);
  for (const Role joint : kRoles) {
    const auto keys = rotation_keys(motion.poses.size(),
                                    [&](std::size_t k) { return motion.poses[k].rotation[joint]; });
    animation.add(node_of(joint, figure), "rotation", keys, GltfElement::vec4);
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
  if (ball.axes.empty()) return;
  const auto keys = rotation_keys(ball.axes.size(), [&](std::size_t k) {
    return Quaternionf::FromTwoVectors(Vector3f::UnitX(), ball.axes[k]);
  });
  animation.add(kBallNode, "rotation", keys, GltfElement::vec4);
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
  if (!ball.axes.empty() && ball.axes.size() != pose_count)
    throw Error("", "the rod has " + std::to_string(ball.axes.size()) + " axes, the motion " +
                        std::to_string(pose_count) + " poses: give one per pose");
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
  int figures = 1;
  Json meshes = Json::array();
  Json materials = figure_materials();
  Json roots = Json::array();
  int bind = 0;
};

Scene scene_of(const motion::Physique& character, int figures = 1) {
  Scene scene;
  scene.figures = figures;
  scene.meshes.push_back(figure_mesh(character, scene.buffer));
  for (int figure = 0; figure < figures; ++figure) {
    scene.roots.push_back(figure_node(figure));
    scene.roots.push_back(node_of(Role::pelvis, figure));
  }
  scene.bind = inverse_bind_matrices(character.skeleton, scene.buffer);
  return scene;
}

Json skin_of(int bind, int figure) {
  Json joints = Json::array();
  for (const Role role : kRoles) joints.push_back(node_of(role, figure));
  return {{"name", name_in("figure", figure)},
          {"inverseBindMatrices", bind},
          {"skeleton", node_of(Role::pelvis, figure)},
          {"joints", std::move(joints)}};
}

std::vector<std::byte> file_of(const motion::Skeleton& skeleton, const std::vector<Vector3f>& ball,
                               Scene scene, Json animations) {
  Json skins = Json::array();
  for (int figure = 0; figure < scene.figures; ++figure)
    skins.push_back(skin_of(scene.bind, figure));
  return scene.buffer.file(
      {{"asset", {{"version", "2.0"}, {"generator", "Flinch " FLINCH_VERSION}}},
       {"scene", 0},
       {"scenes", Json::array({{{"name", "scene"}, {"nodes", std::move(scene.roots)}}})},
       {"nodes", nodes_of(skeleton, scene.figures, ball)},
       {"meshes", std::move(scene.meshes)},
       {"materials", std::move(scene.materials)},
       {"skins", std::move(skins)},
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
  animate_figure(motion, 0, animation);
  if (ball) {
    scene.meshes.push_back(ball_mesh(ball->radius, ball->half_length, scene.buffer));
    scene.materials.push_back(ball_material());
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
    animate_figure(one.motion, 0, animation);
    animations.push_back(animation.json(one.name, extras_of(one.facts)));
  }
  return file_of(character.skeleton, {}, std::move(scene), std::move(animations));
}

std::vector<std::byte> make_group_glb(const motion::Physique& character,
                                      std::span<const motion::Motion> motions) {
  if (motions.empty()) throw Error("", "there are no motions to write");
  for (const motion::Motion& motion : motions) {
    check_exportable(character, motion);
    if (motion.poses.size() != motions[0].poses.size() || motion.rate_hz != motions[0].rate_hz)
      throw Error("", "the motions of a group differ in length or rate");
  }
  Scene scene = scene_of(character, static_cast<int>(motions.size()));
  Animation animation(motions[0], scene.buffer);
  for (std::size_t i = 0; i < motions.size(); ++i)
    animate_figure(motions[i], static_cast<int>(i), animation);
  Json animations = Json::array({animation.json("motion", {})});
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

void write_group_glb(const std::string& path, const motion::Physique& character,
                     std::span<const motion::Motion> motions) {
  write_bytes(path, make_group_glb(character, motions));
}

}  // namespace flinch::database
