// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "database/files/file_kind.h"

namespace flinch::database {

/// What one column of a BVH file's motion data changes. Rotations are about the joint's own axes.
enum class BvhChannel : std::uint8_t {
  x_position,
  y_position,
  z_position,
  x_rotation,
  y_rotation,
  z_rotation,
};

/// A joint as in the file, with its own name, units and axes.
struct BvhJoint {
  std::string name;                                  ///< see printable_text
  int parent = -1;                                   ///< index into Bvh::joints; -1 for the root
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< from the parent, in the parent's frame
  std::vector<BvhChannel> channels;                  ///< in the file's order; may be empty
  int first_channel = 0;                             ///< column of the first of `channels`
  /// Offsets of its End Sites, in its own frame; may be empty.
  std::vector<Eigen::Vector3d> end_sites;
};

/// A validated BVH file: one tree of joints, and frames of finite numbers.
struct Bvh {
  std::string path;               ///< for messages
  FileKind kind = FileKind::bvh;  ///< of the file: bvh, fbx or gltf
  std::vector<BvhJoint> joints;   ///< parents first; the root is joint 0
  double frame_time_s = 0;        ///< above 0
  int frame_count = 0;            ///< at least 1
  int first_frame = 0;            ///< frames of the file before these, see select_frames
  int channel_count = 0;          ///< columns of a frame, at least 1
  /// Frame after frame, frame_count * channel_count values: positions in the file's units,
  /// rotations in degrees.
  std::vector<double> values;
  /// Whether positions are known to be in metres, with Y up, as in files of other formats.
  bool is_metres_y_up = false;
  /// Unusual content that was accepted, each as "FILE:LINE: what".
  std::vector<std::string> warnings;

  /// Time of the first frame, from the beginning of the file.
  double start_s() const { return first_frame * frame_time_s; }
  double duration_s() const { return (frame_count - 1) * frame_time_s; }
};

/// Parses BVH text as found in practice: any channel order per joint, position channels on any
/// joint, any whitespace and line ends, frames that span several lines, scientific notation, joints
/// with no, one or several End Sites, `CHANNELS 0`, keywords in any case, names with dots, colons
/// or spaces, blank lines, comments (# or //), a byte-order mark. Where `Frames` is not the number
/// of rows, or the last row is cut short, the whole rows are read, with a warning. Does not depend
/// on the locale. `path` is for messages only.
///
/// Throws Error "FILE:LINE: …" for anything ambiguous or invalid: text that is not BVH, no ROOT or
/// several, a missing OFFSET, numbers that are not finite, rows that do not match the CHANNELS,
/// fewer than half of the declared rows. Memory is bounded by the size of the text, whatever its
/// counts say.
Bvh parse_bvh(std::string_view text, const std::string& path);

/// The same from a file.
Bvh read_bvh(const std::string& path);

/// Where every joint is, in the file's own space, units and axes.
struct BvhFrame {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Quaterniond> orientation;
};

/// Returns the joints in one frame, 0 <= frame < frame_count.
///
/// A joint's rotation is the product of its rotation channels in the file's order, leftmost first.
/// A position channel replaces its component of OFFSET, on the root as on any joint. Readers differ
/// for the root: Blender and most research code replace it, some viewers add it. Files with a
/// non-zero root OFFSET are written for either convention, and nothing in them says which. The two
/// differ by a constant translation of the whole figure, so callers must find the ground from the
/// motion and not assume that it is at zero.
BvhFrame forward_kinematics(const Bvh& bvh, int frame);

/// Returns the joints with all rotations zero and only the OFFSETs: the rest figure.
BvhFrame rest_frame(const Bvh& bvh);

}  // namespace flinch::database
