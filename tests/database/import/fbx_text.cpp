// SPDX-License-Identifier: MIT
#include "tests/database/import/fbx_text.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace flinch::tests {
namespace {

using database::Bvh;
using database::BvhChannel;
using database::BvhJoint;

constexpr double kTicksPerSecond = 46186158000;
constexpr int kOrderYxz = 3;  // Y first, then X, then Z: the product Rz Rx Ry
constexpr int kLayer = 11;
constexpr int kFirstJoint = 1000;
constexpr int kFirstCurve = 100000;

class Writer {
 public:
  Writer(const Bvh& bvh, const FbxSettings& settings) : bvh_(bvh), settings_(settings) {
    objects_ << std::setprecision(12);
  }

  std::string text() {
    objects_ << "AnimationStack: 10, \"AnimStack::take\", \"\" {\n}\n";
    for (int layer = kLayer; layer < kLayer + settings_.layer_count; ++layer) {
      objects_ << "AnimationLayer: " << layer << ", \"AnimLayer::base\", \"\" {\n}\n";
      connections_ << "C: \"OO\"," << layer << ",10\n";
    }
    for (std::size_t i = 0; i < bvh_.joints.size(); ++i) add_joint(static_cast<int>(i));
    for (int layer = kLayer + 1; layer < kLayer + settings_.layer_count; ++layer) {
      add_curves(bvh_.joints[0], kFirstJoint, BvhChannel::x_rotation, "Lcl Rotation", layer);
    }
    std::ostringstream text;
    text << "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\n"
         << "FBXVersion: 7400\n}\nGlobalSettings:  {\nVersion: 1000\nProperties70:  {\n"
         << property("UpAxis", "int", "Integer") << settings_.up_axis << "\n"
         << property("UpAxisSign", "int", "Integer") << settings_.up_axis_sign << "\n"
         << property("UnitScaleFactor", "double", "Number") << settings_.unit_centimetres
         << "\n}\n}\nObjects:  {\n"
         << objects_.str() << "}\nConnections:  {\n"
         << connections_.str() << "}\n";
    return text.str();
  }

 private:
  static std::string property(const std::string& name, const std::string& type,
                              const std::string& label) {
    return "P: \"" + name + "\", \"" + type + "\", \"" + label + "\", \"\",";
  }

  static std::string list(const Eigen::Vector3d& v) {
    std::ostringstream text;
    text << std::setprecision(12) << v.x() << ',' << v.y() << ',' << v.z();
    return text.str();
  }

  void add_joint(int index) {
    const BvhJoint& joint = bvh_.joints[static_cast<std::size_t>(index)];
    const int id = kFirstJoint + index;
    const bool is_last = &joint == &bvh_.joints.back();
    objects_ << "Model: " << id << ", \"Model::" << joint.name << "\", \"LimbNode\" {\n"
             << "Version: 232\nProperties70:  {\n"
             << property("RotationOrder", "enum", "")
             << (is_last ? settings_.last_rotation_order : kOrderYxz) << "\n"
             << property("RotationActive", "bool", "")
             << (is_last && !settings_.is_rotation_active ? 0 : 1) << "\n"
             << property("PreRotation", "Vector3D", "Vector") << list(settings_.pre_rotation)
             << "\n"
             << property("PostRotation", "Vector3D", "Vector") << list(settings_.post_rotation)
             << "\n"
             << property("GeometricTranslation", "Vector3D", "Vector")
             << list(settings_.geometric_translation) << "\n"
             << property("GeometricRotation", "Vector3D", "Vector")
             << list(settings_.geometric_rotation) << "\n"
             << property("Lcl Translation", "Lcl Translation", "") << list(joint.offset) << "\n"
             << property("Lcl Rotation", "Lcl Rotation", "") << "0,0,0\n}\n}\n";
    const int parent = joint.parent < 0 ? 0 : kFirstJoint + joint.parent;
    connections_ << "C: \"OO\"," << id << ',' << parent << "\n";
    if (joint.parent < 0) add_curves(joint, id, BvhChannel::x_position, "Lcl Translation");
    add_curves(joint, id, BvhChannel::x_rotation, "Lcl Rotation");
  }

  void add_curves(const BvhJoint& joint, int joint_id, BvhChannel first, const std::string& name,
                  int layer = kLayer) {
    const int node = next_id_++;
    objects_ << "AnimationCurveNode: " << node << ", \"AnimCurveNode::" << name
             << "\", \"\" {\n}\n";
    connections_ << "C: \"OO\"," << node << ',' << layer << "\nC: \"OP\"," << node << ','
                 << joint_id << ", \"" << name << "\"\n";
    for (std::size_t i = 0; i < joint.channels.size(); ++i) {
      const int axis = static_cast<int>(joint.channels[i]) - static_cast<int>(first);
      if (axis < 0 || axis > 2) continue;
      const int curve = next_id_++;
      add_curve(curve, static_cast<std::size_t>(joint.first_channel) + i);
      connections_ << "C: \"OP\"," << curve << ',' << node << ", \"d|"
                   << "XYZ"[axis] << "\"\n";
    }
  }

  void add_curve(int id, std::size_t column) {
    const int count = bvh_.frame_count;
    objects_ << "AnimationCurve: " << id << ", \"AnimCurve::\", \"\" {\nDefault: 0\nKeyTime: *"
             << count << " {\na: ";
    for (int k = 0; k < count; ++k) {
      objects_ << (k > 0 ? "," : "") << std::llround(k * bvh_.frame_time_s * kTicksPerSecond);
    }
    objects_ << "\n}\nKeyValueFloat: *" << count << " {\na: ";
    for (int k = 0; k < count; ++k) {
      objects_ << (k > 0 ? "," : "")
               << bvh_.values[static_cast<std::size_t>(k * bvh_.channel_count) + column];
    }
    objects_ << "\n}\n}\n";
  }

  const Bvh& bvh_;
  const FbxSettings& settings_;
  std::ostringstream objects_;
  std::ostringstream connections_;
  int next_id_ = kFirstCurve;
};

}  // namespace

std::string fbx_text(const Bvh& bvh, const FbxSettings& settings) {
  return Writer(bvh, settings).text();
}

}  // namespace flinch::tests
