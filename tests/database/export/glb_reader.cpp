// SPDX-License-Identifier: MIT
#include "glb_reader.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <stdexcept>

namespace flinch::tests {
namespace {

using Eigen::Affine3d;
using nlohmann::json;

// Translation, rotation and scale, by their glTF names.
using Transform = std::map<std::string, std::vector<double>>;

std::size_t index_in(const json& object, const char* key) {
  return object.at(key).get<std::size_t>();
}

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t place) {
  std::uint32_t word = 0;
  if (place + 4 > bytes.size()) throw std::runtime_error("the file ends early");
  std::memcpy(&word, bytes.data() + place, 4);
  return word;
}

template <class Number>
std::vector<double> numbers(const char* from, std::size_t count) {
  std::vector<Number> read(count);
  std::memcpy(read.data(), from, count * sizeof(Number));
  return {read.begin(), read.end()};
}

std::vector<double> sampled(const Glb& glb, const json& sampler, double time_s, bool is_rotation) {
  const std::vector<double> times = numbers_of(glb, sampler["input"]);
  const std::vector<double> values = numbers_of(glb, sampler["output"]);
  const std::size_t width = values.size() / times.size();
  const auto after = std::upper_bound(times.begin(), times.end(), time_s) - times.begin();
  const auto last = static_cast<std::ptrdiff_t>(times.size()) - 1;
  const auto low = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - 1, 0, last));
  const auto high = std::min(low + 1, times.size() - 1);
  const std::vector<double> a(values.begin() + static_cast<std::ptrdiff_t>(low * width),
                              values.begin() + static_cast<std::ptrdiff_t>((low + 1) * width));
  if (sampler["interpolation"] == "STEP" || low == high) return a;
  if (sampler["interpolation"] != "LINEAR") throw std::runtime_error("unknown interpolation");
  const double part = (time_s - times[low]) / (times[high] - times[low]);
  std::vector<double> between(width);
  const double* b = values.data() + high * width;
  if (is_rotation) {
    const Eigen::Map<const Eigen::Quaterniond> from(a.data());
    const Eigen::Map<const Eigen::Quaterniond> to(b);
    Eigen::Map<Eigen::Quaterniond>(between.data()) = from.slerp(part, to);
  } else {
    for (std::size_t i = 0; i < width; ++i) between[i] = a[i] + part * (b[i] - a[i]);
  }
  return between;
}

Affine3d matrix_of(const Transform& transform) {
  const std::vector<double>& t = transform.at("translation");
  const std::vector<double>& r = transform.at("rotation");
  const std::vector<double>& s = transform.at("scale");
  return Eigen::Translation3d(t[0], t[1], t[2]) * Eigen::Quaterniond(r[3], r[0], r[1], r[2]) *
         Eigen::Scaling(s[0], s[1], s[2]);
}

std::vector<Transform> transforms_at_rest(const Glb& glb) {
  std::vector<Transform> transforms;
  for (const json& node : glb.document["nodes"]) {
    transforms.push_back({{"translation", node.value("translation", std::vector<double>{0, 0, 0})},
                          {"rotation", node.value("rotation", std::vector<double>{0, 0, 0, 1})},
                          {"scale", node.value("scale", std::vector<double>{1, 1, 1})}});
  }
  return transforms;
}

std::vector<Affine3d> scene_of(const Glb& glb, const std::vector<Transform>& transforms) {
  std::vector<Affine3d> scene(transforms.size());
  const std::function<void(std::size_t, const Affine3d&)> place = [&](std::size_t node,
                                                                      const Affine3d& parent) {
    scene[node] = parent * matrix_of(transforms[node]);
    for (const json& child : glb.document["nodes"][node].value("children", json::array())) {
      place(child, scene[node]);
    }
  };
  for (const json& root : glb.document["scenes"][0]["nodes"]) place(root, Affine3d::Identity());
  return scene;
}

}  // namespace

Glb read_glb(std::span<const std::byte> bytes) {
  if (word_at(bytes, 0) != 0x46546C67 || word_at(bytes, 4) != 2) {
    throw std::runtime_error("not a glTF 2.0 file");
  }
  if (word_at(bytes, 8) != bytes.size()) throw std::runtime_error("the length is wrong");
  const std::uint32_t text = word_at(bytes, 12);
  if (word_at(bytes, 16) != 0x4E4F534A) throw std::runtime_error("no JSON chunk");
  const std::uint32_t binary = word_at(bytes, 20 + text);
  if (word_at(bytes, 24 + text) != 0x004E4942) throw std::runtime_error("no BIN chunk");
  if (text % 4 != 0 || binary % 4 != 0 || 28 + text + binary != bytes.size()) {
    throw std::runtime_error("the chunks do not fill the file");
  }
  const char* from = reinterpret_cast<const char*>(bytes.data());
  return {json::parse(from + 20, from + 20 + text), std::string(from + 28 + text, binary)};
}

std::vector<double> numbers_of(const Glb& glb, std::size_t index) {
  static const std::map<std::string, std::size_t> kWidths{
      {"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
  const json& accessor = glb.document["accessors"].at(index);
  const json& view = glb.document["bufferViews"].at(index_in(accessor, "bufferView"));
  const std::size_t place = view["byteOffset"];
  const std::size_t size = view["byteLength"];
  const std::size_t count = kWidths.at(accessor["type"]) * accessor["count"].get<std::size_t>();
  const int type = accessor["componentType"];
  const std::size_t width = type == 5121 ? 1 : type == 5123 ? 2 : 4;
  if (place % 4 != 0 || size != count * width || place + size > glb.binary.size()) {
    throw std::runtime_error("accessor " + std::to_string(index) + " does not fit its view");
  }
  const char* from = glb.binary.data() + place;
  if (type == 5121) return numbers<std::uint8_t>(from, count);
  if (type == 5123) return numbers<std::uint16_t>(from, count);
  if (type == 5125) return numbers<std::uint32_t>(from, count);
  if (type == 5126) return numbers<float>(from, count);
  throw std::runtime_error("unknown component type");
}

int node_named(const Glb& glb, const std::string& name) {
  const json& nodes = glb.document["nodes"];
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i]["name"] == name) return static_cast<int>(i);
  }
  throw std::runtime_error("no node " + name);
}

std::vector<Affine3d> scene_at(const Glb& glb, double time_s) {
  std::vector<Transform> transforms = transforms_at_rest(glb);
  const json& animation = glb.document["animations"].at(0);
  for (const json& channel : animation["channels"]) {
    const std::string path = channel["target"]["path"];
    const std::size_t node = channel["target"]["node"];
    transforms[node][path] = sampled(glb, animation["samplers"].at(index_in(channel, "sampler")),
                                     time_s, path == "rotation");
  }
  return scene_of(glb, transforms);
}

std::vector<Affine3d> scene_at_rest(const Glb& glb) {
  return scene_of(glb, transforms_at_rest(glb));
}

// glTF 2.0, 3.7.3: the sum over a vertex's joints of weight * joint * inverse bind * position; the
// transform of the mesh's own node is ignored.
std::vector<Eigen::Vector3d> skinned_positions(const Glb& glb, std::size_t primitive,
                                               const std::vector<Affine3d>& nodes) {
  const json& skin = glb.document["skins"].at(0);
  const json& attributes = glb.document["meshes"][0]["primitives"][primitive]["attributes"];
  const std::vector<double> binds = numbers_of(glb, skin["inverseBindMatrices"]);
  const std::vector<double> positions = numbers_of(glb, attributes["POSITION"]);
  const std::vector<double> joints = numbers_of(glb, attributes["JOINTS_0"]);
  const std::vector<double> weights = numbers_of(glb, attributes["WEIGHTS_0"]);
  std::vector<Eigen::Vector3d> skinned;
  for (std::size_t i = 0; i < positions.size() / 3; ++i) {
    const Eigen::Vector3d position = Eigen::Map<const Eigen::Vector3d>(positions.data() + 3 * i);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
      const auto joint = static_cast<std::size_t>(joints[k]);
      const Affine3d bind(Eigen::Map<const Eigen::Matrix4d>(binds.data() + 16 * joint));
      const Affine3d& node = nodes.at(skin["joints"].at(joint).get<std::size_t>());
      sum += weights[k] * (node * bind * position);
    }
    skinned.push_back(sum);
  }
  return skinned;
}

}  // namespace flinch::tests
