// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "database/import/frame_selection.h"
#include "database/import/reference_pose.h"
#include "database/import/role_map.h"
#include "database/import/source_space.h"

namespace flinch::database {

/// What a user may specify instead of having it detected.
struct SourceOptions {
  std::optional<LengthUnit> unit;
  std::optional<UpAxis> up;
  RoleOverrides roles;
  FrameOptions frames;
  /// File with the same skeleton in which the figure stands: the reference pose is taken from it.
  std::optional<std::string> rest;
};

/// Returns the options, with those that `stronger` specifies in their place.
SourceOptions merged(SourceOptions options, const SourceOptions& stronger);

/// One foot of a source in one frame, m.
struct SourceFoot {
  Eigen::Vector3f ankle = Eigen::Vector3f::Zero();
  Eigen::Vector3f ball = Eigen::Vector3f::Zero();  ///< see with_human_ends
};

/// Points of a source's trunk, relative to the middle between the hips, m. Zero where the file has
/// no such joint.
struct SourceTrunk {
  Eigen::Vector3f abdomen = Eigen::Vector3f::Zero();
  Eigen::Vector3f chest = Eigen::Vector3f::Zero();
  /// The middle between the shoulders of the reference pose, fixed to the chest.
  Eigen::Vector3f shoulders = Eigen::Vector3f::Zero();
  Eigen::Vector3f left_shoulder = Eigen::Vector3f::Zero();  ///< the upper arm's joint
  Eigen::Vector3f right_shoulder = Eigen::Vector3f::Zero();
  Eigen::Vector3f head = Eigen::Vector3f::Zero();
};

/// One frame of a source in the library's terms: X forward, Y left, Z up, m, the ground at 0.
struct SourceFrame {
  /// Orientation of every role relative to the reference pose; roles that the file does not have
  /// follow their neighbours.
  motion::PerRole<Eigen::Quaternionf> orientation;
  Eigen::Vector3f hip_centre = Eigen::Vector3f::Zero();
  SourceTrunk trunk;
  std::array<SourceFoot, 2> foot;  ///< left, right
};

/// A source's motion and measurements, ready for retargeting. Its yaw and its position on the
/// ground are the file's own.
struct SourceMotion {
  double start_s = 0;  ///< of its first frame, from the beginning of the file
  double frame_time_s = 0;
  std::vector<SourceFrame> frames;
  SourceTrunk trunk_at_rest;              ///< in the reference pose
  float leg_length_m = 0;                 ///< hip to knee to ankle, mean of both
  std::array<float, 2> ankle_height_m{};  ///< of each ankle while its foot is flat on the ground
  std::array<float, 2> ball_height_m{};   ///< of each ball, likewise

  double duration_s() const { return static_cast<double>(frames.size() - 1) * frame_time_s; }
};

/// What was detected in a file.
struct SourceReport {
  std::string path;
  FileKind kind = FileKind::bvh;  ///< of the file: bvh, fbx or gltf
  int joint_count = 0;
  int first_frame = 1;  ///< of those used, as the file numbers them from 1
  int frame_count = 0;  ///< of those used
  double frame_time_s = 0;
  double duration_s = 0;
  LengthUnit unit = LengthUnit::metre;
  bool unit_given = false;
  UpAxis up = UpAxis::y;
  bool up_given = false;
  double head_height_m = 0;  ///< of the standing head joint
  int reference_frame =
      -1;  ///< frame that the reference pose was taken from, from 0; -1: the OFFSETs
  /// "joint name" and how it was found, for each role; empty where there is none.
  motion::PerRole<std::string> joint_name;
  motion::PerRole<RoleSource> joint_source{};
  std::vector<std::string> warnings;
};

/// A file that was read and analysed.
struct Source {
  SourceReport report;
  Bvh bvh;
  SourceFigure figure;
  ReferencePose reference;
  double metres_per_unit = 1;
  Eigen::Quaterniond to_world = Eigen::Quaterniond::Identity();
};

/// The length of a role's segment in the reference pose, m; not a number where its end is unknown.
double bone_length_m(const Source& source, motion::Role role);

/// Maps the roles, and detects up axis, units and reference pose. Throws Error, also for a rest
/// file with another skeleton.
Source analyse_source(Bvh bvh, const SourceOptions& options = {});

/// Returns whether two files have the same joints, with OFFSETs equal to 0.1 %, in the same roles.
bool has_same_skeleton(const Source& one, const Source& other);

/// Takes the reference pose from a file with the same skeleton, and the figure's ends, which were
/// judged in that pose.
void adopt_reference(Source& source, const Source& from);

/// Returns all frames of a source in the library's terms, calibrated by the motion itself (see
/// calibration.h and ground_contact.h): the ground is where the feet are lowest, planted feet are
/// flat and on it, and elbows and knees bend about their hinges.
SourceMotion source_motion(const Source& source);

}  // namespace flinch::database
