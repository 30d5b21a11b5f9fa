// SPDX-License-Identifier: MIT
#include "database/import/source_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "database/import/calibration.h"
#include "database/import/ground_contact.h"
#include "motion/interpolation.h"

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

double standing_head_height(const SourceFigure& figure, const ReferencePose& reference) {
  double lowest = reference.position[Role::left_foot].z();
  for (Role foot : kFeet) {
    lowest = std::min(lowest, reference.position[foot].z());
    if (figure.end[foot]) lowest = std::min(lowest, reference.end[foot].z());
  }
  return reference.position[Role::head].z() - lowest;
}

// Fills in roles that the file does not have: a neck between chest and head, an abdomen between
// pelvis and chest, all others from their parents.
void fill_missing(const SourceFigure& figure, PerRole<Eigen::Quaternionf>& orientation) {
  for (Role role : kRoles) {
    if (figure.has(role)) continue;
    if (role == Role::neck) {
      orientation[role] = motion::slerp(orientation[Role::chest], orientation[Role::head], 0.5F);
    } else if (role == Role::abdomen) {
      orientation[role] = motion::slerp(orientation[Role::pelvis], orientation[Role::chest], 0.5F);
    } else if (const std::optional<Role> parent = motion::parent_of(role)) {
      orientation[role] = orientation[*parent];
    }
  }
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
    frame.foot[side].ball =
        source.figure.end[role] ? (scale * figure.end[role]).cast<float>() : frame.foot[side].ankle;
  }
  return frame;
}

std::string rounded(double value, const char* format) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void find_space(Source& source, const SourceOptions& options) {
  const UpEstimate found = estimate_up(source.bvh, source.figure);
  SourceReport& report = source.report;
  report.up = options.up.value_or(found.up);
  report.up_given = options.up.has_value();
  if (!options.up && found.certainty < 0.6) {
    report.warnings.push_back("up is taken to be " + std::string(name_of(found.up)) +
                              ", but the figure hardly stands in this file; say so with `up`");
  }
  source.to_world = to_world(report.up);
}

void find_unit(Source& source, const SourceOptions& options) {
  SourceReport& report = source.report;
  const double head_height = standing_head_height(source.figure, source.reference);
  report.unit = options.unit.value_or(likeliest_unit(head_height));
  report.unit_given = options.unit.has_value();
  source.metres_per_unit = metres_in(report.unit);
  report.head_height_m = head_height * source.metres_per_unit;
  if (!options.unit && std::abs(std::log(report.head_height_m / 1.5)) > std::log(1.25)) {
    report.warnings.push_back("units are taken to be " + std::string(name_of(report.unit)) +
                              ", which puts the head joint at " +
                              rounded(report.head_height_m, "%.2f") +
                              " m; say which they are with `units`");
  }
}

}  // namespace

Source analyse_source(Bvh bvh, const SourceOptions& options) {
  Source source;
  source.bvh = std::move(bvh);
  const RoleMap roles = map_roles(source.bvh, options.roles);
  source.figure = source_figure(source.bvh, roles);

  SourceReport& report = source.report;
  report.path = source.bvh.path;
  report.joint_count = static_cast<int>(source.bvh.joints.size());
  report.frame_count = source.bvh.frame_count;
  report.frame_time_s = source.bvh.frame_time_s;
  report.duration_s = source.bvh.duration_s();
  report.warnings = source.bvh.warnings;
  report.joint_source = roles.source;
  for (Role role : kRoles) {
    if (!source.figure.has(role)) continue;
    report.joint_name[role] =
        source.bvh.joints[static_cast<std::size_t>(source.figure.joint[role])].name;
  }

  find_space(source, options);
  source.reference = find_reference_pose(source.bvh, source.figure, report.up);
  report.reference_frame = source.reference.frame;
  if (source.reference.doubt > 0.5) {
    report.warnings.push_back(
        "neither the OFFSETs nor any frame is a standing figure: the reference pose is taken from "
        "frame " +
        std::to_string(source.reference.frame) + ", the most upright, and may be wrong");
  }
  find_unit(source, options);
  return source;
}

SourceMotion source_motion(const Source& source) {
  SourceMotion motion;
  motion.frame_time_s = source.bvh.frame_time_s;
  motion.leg_length_m = static_cast<float>(source.metres_per_unit * leg_length(source.reference));
  for (std::size_t side = 0; side < 2; ++side) {
    motion.has_ball[side] = source.figure.end[kFeet[side]].has_value();
  }
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
