// SPDX-License-Identifier: MIT
#include <span>

#include "database/import/bvh.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

/// A joint relative to its parent.
struct Local {
  Eigen::Vector3d position;
  Eigen::Quaterniond rotation;
};

/// position = OFFSET with its position channels in place; rotation = R1 R2 R3, of the rotation
/// channels in the file's order.
Local local_of(const BvhJoint& joint, std::span<const double> row) {
  Local local{joint.offset, Eigen::Quaterniond::Identity()};
  for (std::size_t i = 0; i < joint.channels.size(); ++i) {
    const double value = row[static_cast<std::size_t>(joint.first_channel) + i];
    const int channel = static_cast<int>(joint.channels[i]);
    if (channel < 3) {
      local.position[channel] = value;
    } else {
      local.rotation *= Eigen::Quaterniond(
          Eigen::AngleAxisd(motion::radians(value), Eigen::Vector3d::Unit(channel - 3)));
    }
  }
  return local;
}

/// Accumulates the transforms that `local(joint)` returns down the tree.
template <class LocalOf>
BvhFrame accumulate(const Bvh& bvh, LocalOf local) {
  BvhFrame frame;
  frame.position.reserve(bvh.joints.size());
  frame.orientation.reserve(bvh.joints.size());
  for (const BvhJoint& joint : bvh.joints) {
    const Local own = local(joint);
    if (joint.parent < 0) {
      frame.position.push_back(own.position);
      frame.orientation.push_back(own.rotation);
      continue;
    }
    const auto parent = static_cast<std::size_t>(joint.parent);
    const Eigen::Quaterniond& turn = frame.orientation[parent];
    const Eigen::Quaterniond orientation = turn * own.rotation;
    frame.position.push_back(frame.position[parent] + turn * own.position);
    frame.orientation.push_back(orientation);
  }
  return frame;
}

}  // namespace

BvhFrame forward_kinematics(const Bvh& bvh, int frame) {
  const auto width = static_cast<std::size_t>(bvh.channel_count);
  const auto row = std::span(bvh.values).subspan(static_cast<std::size_t>(frame) * width, width);
  return accumulate(bvh, [row](const BvhJoint& joint) { return local_of(joint, row); });
}

BvhFrame rest_frame(const Bvh& bvh) {
  return accumulate(bvh, [](const BvhJoint& joint) {
    return Local{joint.offset, Eigen::Quaterniond::Identity()};
  });
}

}  // namespace flinch::database
