// SPDX-License-Identifier: MIT
#include "database/import/source_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "database/import/calibration.h"
#include "database/import/ground_contact.h"
#include "database/import/human_ends.h"
#include "database/import/plausibility.h"
#include "database/import/position_channels.h"
#include "database/import/source_file.h"
#include "database/import/up_estimate.h"
#include "motion/error.h"
#include "motion/interpolation.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

using motion::kRoles;
using motion::PerRole;
using motion::Role;

constexpr std::array<Role, 2> kFeet{Role::left_foot, Role::right_foot};

double length(const ReferencePose& reference, Role from, Role to) {
  return (reference.position[to] - reference.position[from]).norm();
}

double leg_length(const ReferencePose& reference) {
  return 0.5 * (length(reference, Role::left_thigh, Role::left_shin) +
                length(reference, Role::left_shin, Role::left_foot) +
                length(reference, Role::right_thigh, Role::right_shin) +
                length(reference, Role::right_shin, Role::right_foot));
}

double standing_head_height(const ReferencePose& reference) {
  double lowest = reference.position[Role::left_foot].z();
  for (Role foot : kFeet) {
    lowest = std::min({lowest, reference.position[foot].z(), reference.end[foot].z()});
  }
  return reference.position[Role::head].z() - lowest;
}

// Halfway from one joint's orientation to another's, for a joint between them that the file does
// not have. Beyond a quarter turn the share falls from a half to nothing at half a turn, where the
// shorter way round changes sides.
Eigen::Quaternionf halfway(const Eigen::Quaternionf& from, const Eigen::Quaternionf& to) {
  constexpr float kQuarterTurn = std::numbers::pi_v<float> / 2;
  const Eigen::Vector3f way = motion::rotation_vector<float>(from.conjugate() * to);
  const float share = 0.5F - 0.5F * motion::ease_in_ease_out(way.norm() / kQuarterTurn - 1);
  return (from * motion::rotation_from_vector<float>(share * way)).normalized();
}

// Fills in roles that the file does not have: a neck between chest and head, an abdomen between
// pelvis and chest, all others from their parents.
void fill_missing(const SourceFigure& figure, PerRole<Eigen::Quaternionf>& orientation) {
  for (Role role : kRoles) {
    if (figure.has(role)) continue;
    if (role == Role::neck) {
      orientation[role] = halfway(orientation[Role::chest], orientation[Role::head]);
    } else if (role == Role::abdomen) {
      orientation[role] = halfway(orientation[Role::pelvis], orientation[Role::chest]);
    } else if (const std::optional<Role> parent = motion::parent_of(role)) {
      orientation[role] = orientation[*parent];
    }
  }
}

Eigen::Vector3d middle_of_shoulders(const ReferencePose& reference) {
  return 0.5 *
         (reference.position[Role::left_upper_arm] + reference.position[Role::right_upper_arm]);
}

SourceTrunk trunk_of(const Source& source, const PerRole<Eigen::Vector3d>& position,
                     const Eigen::Quaterniond& chest_turn) {
  const ReferencePose& reference = source.reference;
  const Eigen::Vector3d hips = 0.5 * (position[Role::left_thigh] + position[Role::right_thigh]);
  const auto from_hips = [&](const Eigen::Vector3d& point) -> Eigen::Vector3f {
    return (source.metres_per_unit * (point - hips)).cast<float>();
  };
  SourceTrunk trunk;
  if (source.figure.has(Role::abdomen)) trunk.abdomen = from_hips(position[Role::abdomen]);
  trunk.chest = from_hips(position[Role::chest]);
  trunk.shoulders =
      from_hips(position[Role::chest] +
                chest_turn * (middle_of_shoulders(reference) - reference.position[Role::chest]));
  trunk.left_shoulder = from_hips(position[Role::left_upper_arm]);
  trunk.right_shoulder = from_hips(position[Role::right_upper_arm]);
  trunk.head = from_hips(position[Role::head]);
  return trunk;
}

SourceFrame source_frame(const Source& source, int number) {
  const FigureFrame figure =
      figure_frame(source.figure, forward_kinematics(source.bvh, number), source.to_world);
  SourceFrame frame;
  for (Role role : kRoles) {
    frame.orientation[role] =
        (figure.orientation[role] * source.reference.orientation[role].conjugate())
            .normalized()
            .cast<float>();
  }
  fill_missing(source.figure, frame.orientation);
  const double scale = source.metres_per_unit;
  frame.hip_centre = (scale * hip_centre(figure)).cast<float>();
  for (std::size_t side = 0; side < 2; ++side) {
    const Role role = kFeet[side];
    frame.foot[side].ankle = (scale * figure.position[role]).cast<float>();
    frame.foot[side].ball = (scale * figure.end[role]).cast<float>();
  }
  const Eigen::Quaterniond chest_turn =
      figure.orientation[Role::chest] * source.reference.orientation[Role::chest].conjugate();
  frame.trunk = trunk_of(source, figure.position, chest_turn);
  return frame;
}

void take_y_up(Source& source, const UpEstimate& found) {
  source.report.up = UpAxis::y;
  source.to_world = to_world(UpAxis::y);
  if (found.up == UpAxis::y || found.certainty < 0.6) return;
  source.report.warnings.push_back("the file says which way is up, but its figure stands along " +
                                   std::string(name_of(found.up)) +
                                   " then; if the figure is right, say so with --up");
}

void find_space(Source& source, const SourceOptions& options) {
  const UpEstimate found = estimate_up(source.bvh, source.figure);
  SourceReport& report = source.report;
  if (source.bvh.is_metres_y_up && !options.up) return take_y_up(source, found);
  report.up = options.up.value_or(found.up);
  report.up_given = options.up.has_value();
  const std::string taken = "up is taken to be " + std::string(name_of(found.up));
  if (!options.up && found.rival) {
    report.warnings.push_back(taken + ", but it may be " + std::string(name_of(*found.rival)) +
                              ": the OFFSETs stand along another axis than the motion; say which "
                              "with --up");
  } else if (!options.up && found.certainty < 0.6) {
    report.warnings.push_back(taken +
                              ", but the figure hardly stands in this file; say so with --up");
  }
  source.to_world = to_world(report.up);
}

void find_reference(Source& source, const SourceOptions& options) {
  SourceReport& report = source.report;
  std::string looked_at = "the OFFSETs";
  if (options.rest) {
    SourceOptions of_rest = options;
    of_rest.rest.reset();
    of_rest.frames = {};
    const Source rest = analyse_source(read_source_file(*options.rest), of_rest);
    if (!has_same_skeleton(source, rest)) {
      throw Error(*options.rest, "its skeleton is not that of " + report.path +
                                     ": a rest file needs the same joints and OFFSETs");
    }
    adopt_reference(source, rest);
    looked_at += " of " + *options.rest;
  } else {
    const StandingPose standing = find_standing_pose(source.bvh, source.figure, report.up);
    const bool is_backward = feet_point_backward(source.figure, standing);
    source.figure = with_human_ends(source.figure, standing);
    source.reference = make_reference_pose(source.figure, standing);
    source.reference.feet_point_backward = is_backward;
  }
  for (Role role : {Role::left_toes, Role::right_toes}) {
    if (report.joint_name[role].empty() || source.figure.has(role)) continue;
    report.warnings.push_back(report.joint_name[role] +
                              " is not at the ball of the foot and does not bend the toes");
  }
  report.reference_frame = source.reference.frame;
  if (source.reference.doubt > 0.5) {
    report.warnings.push_back("neither " + looked_at +
                              " nor any frame is a standing figure: the reference pose is taken "
                              "from frame " +
                              std::to_string(report.first_frame + source.reference.frame) +
                              ", the most upright, and may be wrong; name a file in which it "
                              "stands with --rest");
  }
}

void find_unit(Source& source, const SourceOptions& options) {
  SourceReport& report = source.report;
  const double head_height = standing_head_height(source.reference);
  // A format that says its unit is believed while the figure is not twice or half a human's size.
  const bool is_in_metres =
      source.bvh.is_metres_y_up && std::abs(std::log(head_height / 1.5)) < std::log(2.0);
  const LengthUnit likeliest = is_in_metres ? LengthUnit::metre : likeliest_unit(head_height);
  report.unit = options.unit.value_or(likeliest);
  report.unit_given = options.unit.has_value();
  source.metres_per_unit = metres_in(report.unit);
  report.head_height_m = head_height * source.metres_per_unit;
}

}  // namespace

SourceOptions merged(SourceOptions options, const SourceOptions& stronger) {
  if (stronger.unit) options.unit = stronger.unit;
  if (stronger.up) options.up = stronger.up;
  if (stronger.rest) options.rest = stronger.rest;
  if (stronger.frames.rate_hz) options.frames.rate_hz = stronger.frames.rate_hz;
  if (stronger.frames.range) options.frames.range = stronger.frames.range;
  if (stronger.frames.skip_first) options.frames.skip_first = stronger.frames.skip_first;
  for (const auto& [role, joint] : stronger.roles) options.roles[role] = joint;
  return options;
}

double bone_length_m(const Source& source, Role role) {
  if (!source.figure.end[role]) return std::numeric_limits<double>::quiet_NaN();
  return source.metres_per_unit *
         (source.reference.end[role] - source.reference.position[role]).norm();
}

Source analyse_source(Bvh bvh, const SourceOptions& options) {
  Source source;
  source.bvh = std::move(bvh);
  select_frames(source.bvh, options.frames);
  const std::optional<std::string> positions = unify_position_channels(source.bvh);
  const RoleMap roles = map_roles(source.bvh, options.roles);
  source.figure = source_figure(source.bvh, roles);

  SourceReport& report = source.report;
  report.path = source.bvh.path;
  report.kind = source.bvh.kind;
  report.joint_count = static_cast<int>(source.bvh.joints.size());
  report.first_frame = source.bvh.first_frame + 1;
  report.frame_count = source.bvh.frame_count;
  report.frame_time_s = source.bvh.frame_time_s;
  report.duration_s = source.bvh.duration_s();
  report.warnings = source.bvh.warnings;
  if (positions) report.warnings.push_back(*positions);
  report.joint_source = roles.source;
  for (Role role : kRoles) {
    if (!source.figure.has(role)) continue;
    report.joint_name[role] =
        source.bvh.joints[static_cast<std::size_t>(source.figure.joint[role])].name;
  }

  find_space(source, options);
  find_reference(source, options);
  find_unit(source, options);
  std::ranges::copy(judge_figure(source), std::back_inserter(report.warnings));
  std::ranges::copy(judge_angles(source, options), std::back_inserter(report.warnings));
  return source;
}

bool has_same_skeleton(const Source& one, const Source& other) {
  constexpr double kSame = 1e-3;
  const std::vector<BvhJoint>& joints = one.bvh.joints;
  return one.report.joint_name == other.report.joint_name &&
         std::equal(joints.begin(), joints.end(), other.bvh.joints.begin(), other.bvh.joints.end(),
                    [](const BvhJoint& a, const BvhJoint& b) {
                      return a.name == b.name && a.parent == b.parent &&
                             (a.offset - b.offset).norm() <= kSame * a.offset.norm();
                    });
}

void adopt_reference(Source& source, const Source& from) {
  source.reference = from.reference;
  source.figure = from.figure;
}

SourceMotion source_motion(const Source& source) {
  SourceMotion motion;
  motion.start_s = source.bvh.start_s();
  motion.frame_time_s = source.bvh.frame_time_s;
  motion.leg_length_m = static_cast<float>(source.metres_per_unit * leg_length(source.reference));
  motion.trunk_at_rest =
      trunk_of(source, source.reference.position, Eigen::Quaterniond::Identity());
  motion.frames.reserve(static_cast<std::size_t>(source.bvh.frame_count));
  for (int number = 0; number < source.bvh.frame_count; ++number) {
    motion.frames.push_back(source_frame(source, number));
  }
  set_ground(motion);
  level_feet(motion);
  align_hinges(motion);
  snap_feet_to_ground(motion);
  return motion;
}

}  // namespace flinch::database
