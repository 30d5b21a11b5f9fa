// SPDX-License-Identifier: MIT
#include "tests/database/import/gltf_files.h"

#include <iomanip>
#include <sstream>
#include <vector>

namespace flinch::tests {
namespace {

using database::Bvh;
using database::BvhFrame;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Elements of JSON with commas between them.
class JsonList {
 public:
  int add(const std::string& element) {
    text_ += (count_ > 0 ? ",\n" : "") + element;
    return count_++;
  }
  std::string text() const { return "[" + text_ + "]"; }

 private:
  std::string text_;
  int count_ = 0;
};

class GltfWriter {
 public:
  GltfWriter(const Bvh& bvh, const GltfSettings& settings) : bvh_(bvh), settings_(settings) {
    for (int frame = 0; frame < bvh.frame_count; ++frame) {
      const bool is_key = frame % settings.key_step == 0 || frame == bvh.frame_count - 1;
      if (is_key) frames_.push_back(frame);
    }
  }

  std::string write(const TemporaryFolder& folder) {
    add_joints();
    if (settings_.has_bind_pose) animations_.add(animation({0}, "LINEAR"));
    animations_.add(animation(frames_, settings_.interpolation));
    for (int skin = 0; skin < settings_.skin_count; ++skin) add_skin(skin);
    folder.write("numbers.bin", numbers_);
    const std::string count = std::to_string(numbers_.size());
    return folder.write("made.gltf",
                        R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": )" +
                            roots_.text() + "}],\n\"nodes\": " + nodes_.text() +
                            ",\n\"animations\": " + animations_.text() + member("meshes", meshes_) +
                            member("skins", skins_) + R"(, "buffers": [{"byteLength": )" + count +
                            R"(, "uri": "numbers.bin"}])" + member("bufferViews", views_) +
                            member("accessors", accessors_) + "}");
  }

 private:
  static std::string member(const std::string& name, const JsonList& list) {
    return list.text() == "[]" ? "" : ",\n\"" + name + "\": " + list.text();
  }

  static std::string text_of(const Vector3d& v) {
    std::ostringstream text;
    text << std::setprecision(12) << '[' << v.x() << ',' << v.y() << ',' << v.z() << ']';
    return text.str();
  }

  static constexpr int kFloat = 5126;
  static constexpr int kUint16 = 5123;

  int accessor(const std::string& bytes, int component, std::size_t count, const std::string& type,
               const std::string& more) {
    const int view =
        views_.add(R"({"buffer": 0, "byteOffset": )" + std::to_string(numbers_.size()) +
                   R"(, "byteLength": )" + std::to_string(bytes.size()) + "}");
    numbers_ += bytes;
    return accessors_.add(R"({"bufferView": )" + std::to_string(view) + R"(, "componentType": )" +
                          std::to_string(component) + R"(, "count": )" + std::to_string(count) +
                          R"(, "type": ")" + type + '"' + more + "}");
  }

  int accessor(const std::vector<float>& values, const std::string& type, std::size_t width,
               const std::string& more = "") {
    const std::string bytes(reinterpret_cast<const char*>(values.data()),
                            values.size() * sizeof(float));
    return accessor(bytes, kFloat, values.size() / width, type, more);
  }

  double metres() const { return 0.01 / settings_.armature_scale; }

  void add_joints() {
    // The node of joint i has number i; then come End Sites, the armature and the ball.
    std::vector<std::string> children(bvh_.joints.size());
    int next = static_cast<int>(bvh_.joints.size());
    JsonList ends;
    for (std::size_t i = 0; i < bvh_.joints.size(); ++i) {
      const auto add_child = [&children](int parent, int child) {
        std::string& list = children[static_cast<std::size_t>(parent)];
        list += (list.empty() ? "" : ",") + std::to_string(child);
      };
      if (bvh_.joints[i].parent >= 0) add_child(bvh_.joints[i].parent, static_cast<int>(i));
      for (const Vector3d& end : bvh_.joints[i].end_sites) {
        add_child(static_cast<int>(i), next++);
        ends.add(R"({"name": "end", "translation": )" + text_of(metres() * end) + "}");
      }
    }
    for (std::size_t i = 0; i < bvh_.joints.size(); ++i) {
      const auto renamed = settings_.renamed.find(bvh_.joints[i].name);
      const std::string& name =
          renamed == settings_.renamed.end() ? bvh_.joints[i].name : renamed->second;
      nodes_.add(R"({"name": ")" + name + R"(", "translation": )" +
                 text_of(metres() * bvh_.joints[i].offset) +
                 (children[i].empty() ? "" : R"(, "children": [)" + children[i] + "]") + "}");
    }
    if (ends.text() != "[]") {
      const std::string list = ends.text();
      nodes_.add(list.substr(1, list.size() - 2));
    }
    const std::string scale = std::to_string(settings_.armature_scale);
    nodes_.add(R"({"name": "Armature", "children": [0], "scale": [)" + scale + "," + scale + "," +
               scale + "]}");
    roots_.add(std::to_string(next++));
    if (settings_.has_ball) {
      ball_ = next;
      nodes_.add(R"({"name": "ball", "mesh": )" + std::to_string(mesh("")) + "}");
      roots_.add(std::to_string(ball_));
    }
    skinned_ = next + (settings_.has_ball ? 1 : 0);
  }

  int mesh(const std::string& attributes) {
    const int position =
        accessor({0, 0, 0, 0, 1, 0, 1, 0, 0}, "VEC3", 3, R"(, "min": [0, 0, 0], "max": [1, 1, 0])");
    return meshes_.add(R"({"primitives": [{"attributes": {"POSITION": )" +
                       std::to_string(position) + attributes + "}}]}");
  }

  void add_skin(int skin) {
    std::string joints;
    std::vector<float> inverse;
    for (std::size_t i = static_cast<std::size_t>(skin); i < bvh_.joints.size();
         i += static_cast<std::size_t>(settings_.skin_count)) {
      joints += (joints.empty() ? "" : ",") + std::to_string(i);
      for (int k = 0; k < 16; ++k) inverse.push_back(k % 5 == 0 ? 1.0F : 0.0F);
    }
    const int matrices = accessor(inverse, "MAT4", 16);
    const int indices = accessor(std::string(24, '\0'), kUint16, 3, "VEC4", "");
    const int weights = accessor({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
    const int body = mesh(R"(, "JOINTS_0": )" + std::to_string(indices) + R"(, "WEIGHTS_0": )" +
                          std::to_string(weights));
    skins_.add(R"({"joints": [)" + joints + R"(], "inverseBindMatrices": )" +
               std::to_string(matrices) + "}");
    nodes_.add(R"({"name": "body)" + std::to_string(skin) + R"(", "mesh": )" +
               std::to_string(body) + R"(, "skin": )" + std::to_string(skin) + "}");
    roots_.add(std::to_string(skinned_++));
  }

  std::string animation(const std::vector<int>& frames, const std::string& interpolation) {
    JsonList samplers;
    JsonList channels;
    const auto add = [&](int node, const char* path, int times, const std::vector<float>& values,
                         const char* type, std::size_t width, const std::string& between) {
      std::vector<float> stored = values;
      if (between == "CUBICSPLINE") {  // in-tangent, value, out-tangent
        stored.clear();
        for (std::size_t k = 0; k < values.size(); k += width) {
          stored.insert(stored.end(), width, 0.0F);
          stored.insert(stored.end(), values.begin() + static_cast<std::ptrdiff_t>(k),
                        values.begin() + static_cast<std::ptrdiff_t>(k + width));
          stored.insert(stored.end(), width, 0.0F);
        }
      }
      const int sampler = samplers.add(R"({"input": )" + std::to_string(times) + R"(, "output": )" +
                                       std::to_string(accessor(stored, type, width)) +
                                       R"(, "interpolation": ")" + between + "\"}");
      channels.add(R"({"sampler": )" + std::to_string(sampler) + R"(, "target": {"node": )" +
                   std::to_string(node) + R"(, "path": ")" + path + "\"}}");
    };
    const auto times_of = [this](const std::vector<float>& times_s) {
      return accessor(times_s, "SCALAR", 1,
                      R"(, "min": [)" + std::to_string(times_s.front()) + R"(], "max": [)" +
                          std::to_string(times_s.back()) + "]");
    };
    std::vector<float> times_s;
    for (const int frame : frames) {
      times_s.push_back(static_cast<float>(frame * bvh_.frame_time_s));
    }
    const int times = times_of(times_s);
    for (std::size_t i = 0; i < bvh_.joints.size(); ++i) {
      if (settings_.still.contains(bvh_.joints[i].name)) continue;
      std::vector<float> rotations;
      std::vector<float> positions;
      for (const int frame : frames) {
        const BvhFrame places = forward_kinematics(bvh_, frame);
        const int above = bvh_.joints[i].parent;
        Quaterniond turn = places.orientation[i];
        if (above >= 0) {
          turn = places.orientation[static_cast<std::size_t>(above)].conjugate() * turn;
        }
        for (const double value : turn.coeffs()) rotations.push_back(static_cast<float>(value));
        for (const double value : places.position[i]) {
          positions.push_back(static_cast<float>(metres() * value));
        }
      }
      const auto node = static_cast<int>(i);
      add(node, "rotation", times, rotations, "VEC4", 4, interpolation);
      if (i == 0) add(node, "translation", times, positions, "VEC3", 3, interpolation);
    }
    if (settings_.has_ball && frames.size() > 1) {
      add(ball_, "translation", times_of({0, 20}), {0, 0, 9, 0, 9, 0}, "VEC3", 3, "LINEAR");
    }
    return R"({"samplers": )" + samplers.text() + R"(, "channels": )" + channels.text() + "}";
  }

  const Bvh& bvh_;
  const GltfSettings& settings_;
  std::vector<int> frames_;
  std::string numbers_;
  JsonList roots_, nodes_, animations_, meshes_, skins_, views_, accessors_;
  int ball_ = 0;
  int skinned_ = 0;  // the next node with a skin
};

}  // namespace

std::string write_gltf(const TemporaryFolder& folder, const Bvh& bvh,
                       const GltfSettings& settings) {
  return GltfWriter(bvh, settings).write(folder);
}

}  // namespace flinch::tests
