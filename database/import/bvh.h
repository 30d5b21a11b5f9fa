// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace flinch::database {

/// What one column of a BVH file's motion moves. Rotations are about the joint's own axes.
enum class BvhChannel : std::uint8_t {
  x_position,
  y_position,
  z_position,
  x_rotation,
  y_rotation,
  z_rotation,
};

/// A joint as the file has it: its own name, units and axes.
struct BvhJoint {
  std::string name;
  int parent = -1;                                   ///< index into Bvh::joints; -1 for the root
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< from the parent, in the parent's frame
  std::vector<BvhChannel> channels;                  ///< in the file's order; may be empty
  int first_channel = 0;                             ///< column of the first of `channels`
  /// Offsets of its End Sites, in its own frame: none, one or several.
  std::vector<Eigen::Vector3d> end_sites;
};

/// A BVH file, read and checked: one tree of joints, and frames of finite numbers.
struct Bvh {
  std::string path;              ///< for messages
  std::vector<BvhJoint> joints;  ///< parents first; the root is joint 0
  double frame_time_s = 0;       ///< above 0
  int frame_count = 0;           ///< at least 1
  int channel_count = 0;         ///< columns of a frame, at least 1
  /// Frame after frame: frame_count * channel_count; positions in the file's units, rotations in
  /// degrees.
  std::vector<double> values;
  /// What was accepted but is odd, each "FILE:LINE: what".
  std::vector<std::string> warnings;

  double duration_s() const { return (frame_count - 1) * frame_time_s; }
};

/// Reads BVH text as it is found in the wild: any order of channels for each joint, position
/// channels on any joint, any blanks and line ends, frames broken over lines, scientific notation,
/// joints with no, one or several End Sites, keywords in any case, names with dots, colons or
/// blanks, a byte-order mark. The locale has no say. `path` is for messages only.
///
/// Throws Error "FILE:LINE: …" for anything that it would have to guess: text that is not BVH, no
/// ROOT or several, a missing OFFSET, numbers that are not finite, counts that do not agree with
/// what follows. Memory is bounded by the size of the text whatever its counts say.
Bvh parse_bvh(std::string_view text, const std::string& path);

/// The same from a file.
Bvh read_bvh(const std::string& path);

/// Where every joint is in the file's own space, units and axes.
struct BvhFrame {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Quaterniond> orientation;
};

/// The joints in one frame, 0 <= frame < frame_count.
///
/// A joint's rotation is the product of its rotation channels in the file's order, leftmost first.
/// A position channel replaces its component of OFFSET, on the root as on any joint. Readers differ
/// on the root: Blender and most research code replace, some viewers add. Files with a non-zero
/// root OFFSET are written both ways; nothing in them says which. The two readings differ by a
/// constant translation of the whole figure, so a caller must find the ground from the motion and
/// not take it to be at zero.
BvhFrame forward_kinematics(const Bvh& bvh, int frame);

/// The joints with all rotations zero and only the OFFSETs: the rest figure.
BvhFrame rest_frame(const Bvh& bvh);

}  // namespace flinch::database
