// SPDX-License-Identifier: MIT
#include "database/import/position_channels.h"

#include <algorithm>
#include <vector>

namespace flinch::database {
namespace {

using Eigen::Vector3d;

constexpr int kFramesForMedian = 500;

// What the position channels of a joint that is a bone hold, in every component that has one.
struct Bone {
  std::size_t joint = 0;
  Vector3d channels = Vector3d::Zero();     // medians; zero where there is no channel
  Vector3d has_channel = Vector3d::Zero();  // 1 or 0
};

bool is_position(BvhChannel channel) {
  return channel < BvhChannel::x_rotation;
}

// Median of a column of the motion, and the median distance from it.
struct Spread {
  double median = 0;
  double deviation = 0;
};

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Spread spread_of(const Bvh& bvh, int column) {
  const int step = std::max(1, bvh.frame_count / kFramesForMedian);
  std::vector<double> values;
  for (int frame = 0; frame < bvh.frame_count; frame += step) {
    values.push_back(
        bvh.values[static_cast<std::size_t>(frame) * static_cast<std::size_t>(bvh.channel_count) +
                   static_cast<std::size_t>(column)]);
  }
  Spread spread{median_of(values)};
  for (double& value : values) value = std::abs(value - spread.median);
  spread.deviation = median_of(values);
  return spread;
}

// Returns the inner joints with position channels that hardly change.
std::vector<Bone> bones_with_positions(const Bvh& bvh) {
  constexpr double kConstant = 0.05;  // median deviation over the bone's length
  std::vector<Bone> bones;
  for (std::size_t i = 0; i < bvh.joints.size(); ++i) {
    const BvhJoint& joint = bvh.joints[i];
    if (joint.parent < 0) continue;
    Bone bone{i};
    double deviation = 0;
    for (std::size_t k = 0; k < joint.channels.size(); ++k) {
      if (!is_position(joint.channels[k])) continue;
      const Spread spread = spread_of(bvh, joint.first_channel + static_cast<int>(k));
      const int axis = static_cast<int>(joint.channels[k]);
      bone.channels[axis] = spread.median;
      bone.has_channel[axis] = 1;
      deviation += spread.deviation;
    }
    const double length = std::max(joint.offset.norm(), bone.channels.norm());
    if (bone.has_channel.sum() > 0 && deviation <= kConstant * length) bones.push_back(bone);
  }
  return bones;
}

// Returns whether bones have the lengths of their OFFSETs only if the channels are added to them.
bool are_displacements(const Bvh& bvh, const std::vector<Bone>& bones) {
  double from_offset = 0;
  double from_zero = 0;
  for (const Bone& bone : bones) {
    const Vector3d offset = bvh.joints[bone.joint].offset.cwiseProduct(bone.has_channel);
    from_offset += (bone.channels - offset).norm();
    from_zero += bone.channels.norm();
  }
  return from_zero < 0.5 * from_offset;
}

void add_offsets(Bvh& bvh) {
  for (const BvhJoint& joint : bvh.joints) {
    if (joint.parent < 0) continue;
    for (std::size_t k = 0; k < joint.channels.size(); ++k) {
      if (!is_position(joint.channels[k])) continue;
      const double offset = joint.offset[static_cast<int>(joint.channels[k])];
      for (std::size_t at = static_cast<std::size_t>(joint.first_channel) + k;
           at < bvh.values.size(); at += static_cast<std::size_t>(bvh.channel_count)) {
        bvh.values[at] += offset;
      }
    }
  }
}

}  // namespace

std::optional<std::string> unify_position_channels(Bvh& bvh) {
  constexpr double kSame = 1e-3;  // of the bone's length: exporters round
  std::vector<Bone> bones = bones_with_positions(bvh);
  const bool added = are_displacements(bvh, bones);
  if (added) add_offsets(bvh);
  for (const Bone& bone : bones) {
    Vector3d& offset = bvh.joints[bone.joint].offset;
    const Vector3d ones = Vector3d::Ones();
    Vector3d position = bone.channels;
    position += offset.cwiseProduct(added ? ones : Vector3d(ones - bone.has_channel));
    if ((position - offset).norm() > kSame * offset.norm()) offset = position;
  }
  if (!added) return std::nullopt;
  return "the position channels of " + std::to_string(bones.size()) +
         " joints are near zero where OFFSETs are not, and are added to them";
}

}  // namespace flinch::database
