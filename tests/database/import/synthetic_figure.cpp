// SPDX-License-Identifier: MIT
#include "tests/database/import/synthetic_figure.h"

#include <numbers>

namespace flinch::tests {
namespace {

using database::Bvh;
using database::BvhChannel;
using database::BvhJoint;
using motion::JointFrames;
using motion::kRoles;
using motion::PerRole;
using motion::Role;

class Maker {
 public:
  Maker(const motion::Skeleton& skeleton, const SyntheticRig& rig)
      : skeleton_(skeleton), rig_(rig), rest_(forward_kinematics(skeleton, rig.rest)) {
    for (Role role : kRoles) add(role);
  }

  Bvh bvh(const std::vector<motion::Pose>& poses, double frame_time_s) {
    bvh_.path = "made.bvh";
    bvh_.frame_time_s = frame_time_s;
    bvh_.frame_count = static_cast<int>(poses.size());
    for (const motion::Pose& pose : poses) add_frame(pose);
    return bvh_;
  }

 private:
  Eigen::Vector3d in_file(const Eigen::Vector3f& metres) const {
    return rig_.axes * metres.cast<double>() * rig_.units_per_metre;
  }

  Role named_above(Role role) const {
    Role above = *motion::parent_of(role);
    while (rig_.names[above].empty()) above = *motion::parent_of(above);
    return above;
  }

  int push(const std::string& name, int parent, const Eigen::Vector3d& offset) {
    BvhJoint joint;
    joint.name = name;
    joint.parent = parent;
    joint.offset = offset;
    joint.first_channel = bvh_.channel_count;
    if (parent < 0) {
      joint.channels = {BvhChannel::x_position, BvhChannel::y_position, BvhChannel::z_position};
    }
    joint.channels.insert(joint.channels.end(),
                          {BvhChannel::z_rotation, BvhChannel::x_rotation, BvhChannel::y_rotation});
    bvh_.channel_count += static_cast<int>(joint.channels.size());
    bvh_.joints.push_back(joint);
    return static_cast<int>(bvh_.joints.size()) - 1;
  }

  void add(Role role) {
    joint_[role] = -1;
    if (rig_.names[role].empty()) return;
    if (role == Role::pelvis) {
      joint_[role] = push(rig_.names[role], -1, Eigen::Vector3d::Zero());
      return;
    }
    const Role above = named_above(role);
    Eigen::Vector3d offset = in_file(rest_.position[role] - rest_.position[above]);
    int parent = joint_[above];
    if (!rig_.twist_suffix.empty()) {
      push(rig_.names[role] + rig_.twist_suffix, parent, 0.5 * offset);
    }
    if (!rig_.dummy_suffix.empty()) {
      parent = push(rig_.names[role] + rig_.dummy_suffix, parent, offset);
      offset.setZero();
    }
    joint_[role] = push(rig_.names[role], parent, offset);
    const bool is_leaf = role == Role::head || role == Role::left_hand ||
                         role == Role::right_hand || role == Role::left_toes ||
                         role == Role::right_toes;
    if (is_leaf) {
      const Eigen::Vector3f tip = rest_.orientation[role] * skeleton_.tip[role];
      bvh_.joints.back().end_sites.push_back(in_file(tip));
    }
  }

  // World orientations relative to the rest figure's, in the file's axes.
  void add_frame(const motion::Pose& pose) {
    const JointFrames frames = forward_kinematics(skeleton_, pose);
    const std::size_t row = bvh_.values.size();
    bvh_.values.resize(row + static_cast<std::size_t>(bvh_.channel_count), 0.0);
    for (Role role : kRoles) {
      if (joint_[role] < 0) continue;
      Eigen::Quaterniond local = turned(frames, role);
      if (role != Role::pelvis) local = turned(frames, named_above(role)).conjugate() * local;
      const BvhJoint& joint = bvh_.joints[static_cast<std::size_t>(joint_[role])];
      double* value = bvh_.values.data() + row + joint.first_channel;
      if (role == Role::pelvis) {
        const Eigen::Vector3d place = in_file(frames.position[role]);
        for (int axis = 0; axis < 3; ++axis) *value++ = place[axis];
      }
      const Eigen::Vector3d angles = local.toRotationMatrix().eulerAngles(2, 0, 1);
      for (int i = 0; i < 3; ++i) *value++ = angles[i] * 180 / std::numbers::pi;
    }
  }

  Eigen::Quaterniond turned(const JointFrames& frames, Role role) const {
    const Eigen::Quaternionf turn = frames.orientation[role] * rest_.orientation[role].conjugate();
    return rig_.axes * turn.cast<double>() * rig_.axes.conjugate();
  }

  const motion::Skeleton& skeleton_;
  const SyntheticRig& rig_;
  JointFrames rest_;
  PerRole<int> joint_{};
  Bvh bvh_;
};

}  // namespace

SyntheticRig::SyntheticRig() {
  for (Role role : kRoles) names[role] = std::string(motion::name_of(role));
  Eigen::Matrix3d from_library;  // forward to Z, left to X, up to Y
  from_library << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  axes = Eigen::Quaterniond(from_library);
}

Bvh synthetic_bvh(const motion::Skeleton& skeleton, const SyntheticRig& rig,
                  const std::vector<motion::Pose>& poses, double frame_time_s) {
  return Maker(skeleton, rig).bvh(poses, frame_time_s);
}

PerRole<std::string> rig_names(const std::vector<std::string>& spine,
                               const std::vector<std::string>& left_arm,
                               const std::vector<std::string>& left_leg, const std::string& left,
                               const std::string& right) {
  PerRole<std::string> names;
  const auto set = [&](Role first, const std::vector<std::string>& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto role = static_cast<Role>(static_cast<std::size_t>(first) + i);
      if (list[i] == "-") continue;
      names[role] = list[i];
      if (motion::mirrored(role) == role) continue;
      std::string other = list[i];
      other.replace(other.find(left), left.size(), right);
      names[motion::mirrored(role)] = other;
    }
  };
  set(Role::pelvis, spine);
  set(Role::left_clavicle, left_arm);
  set(Role::left_thigh, left_leg);
  return names;
}

}  // namespace flinch::tests
