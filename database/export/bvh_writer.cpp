// SPDX-License-Identifier: MIT
#include "database/export/bvh_writer.h"

#include <array>
#include <charconv>

#include "database/export/euler_angles.h"
#include "database/export/export_check.h"
#include "database/export/y_up.h"
#include "database/files/file_io.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

using motion::kRoles;
using motion::Role;

constexpr double kUnitsPerMetre = 100;

// Six decimals, without a sign on zero. The longest finite float in centimetres has 41 digits.
void append(double number, std::string& text) {
  std::array<char, 64> digits{};
  const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                  std::chars_format::fixed, 6)
                        .ptr;
  const std::string_view written(digits.data(), static_cast<std::size_t>(end - digits.data()));
  text += written == "-0.000000" ? written.substr(1) : written;
}

void append(const Eigen::Vector3d& vector, std::string& text) {
  for (const double number : vector) {
    text += ' ';
    append(number, text);
  }
}

Eigen::Vector3d in_file(const Eigen::Vector3f& metres) {
  return kUnitsPerMetre * to_y_up(Eigen::Vector3d(metres.cast<double>()));
}

// Appends a joint and its descendants. Roles are in the order of this recursion, so the columns of
// the frames match it.
void append_joint(const motion::Skeleton& skeleton, Role joint, const std::string& indent,
                  std::string& text) {
  const bool is_root = !motion::parent_of(joint);
  text += indent + (is_root ? "ROOT " : "JOINT ") + std::string(motion::name_of(joint)) + '\n';
  text += indent + "{\n" + indent + "\tOFFSET";
  append(is_root ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : in_file(skeleton.offset[joint]),
         text);
  text += '\n' + indent + (is_root ? "\tCHANNELS 6 Xposition Yposition Zposition" : "\tCHANNELS 3");
  text += " Zrotation Xrotation Yrotation\n";
  bool is_end = true;
  for (const Role role : kRoles) {
    if (motion::parent_of(role) != joint) continue;
    append_joint(skeleton, role, indent + '\t', text);
    is_end = false;
  }
  if (is_end) {
    text += indent + "\tEnd Site\n" + indent + "\t{\n" + indent + "\t\tOFFSET";
    append(in_file(skeleton.tip[joint]), text);
    text += '\n' + indent + "\t}\n";
  }
  text += indent + "}\n";
}

void append_frame(const motion::Pose& pose, motion::PerRole<Eigen::Vector3d>& angles,
                  std::string& text) {
  std::string line;
  append(in_file(pose.root_position), line);
  for (const Role role : kRoles) {
    const Eigen::Quaterniond rotation = pose.rotation[role].cast<double>().normalized();
    angles[role] = euler_zxy(to_y_up(rotation), angles[role]);
    append(Eigen::Vector3d(
               angles[role].unaryExpr([](double angle) { return motion::degrees(angle); })),
           line);
  }
  text.append(line, 1);  // without the first space
  text += '\n';
}

}  // namespace

std::string bvh_text(const motion::Physique& character, const motion::Motion& motion) {
  check_exportable(character, motion);
  std::string text = "HIERARCHY\n";
  append_joint(character.skeleton, Role::pelvis, "", text);

  std::array<char, 32> frame_time{};
  char* const end = std::to_chars(frame_time.data(), frame_time.data() + frame_time.size(),
                                  1 / double{motion.rate_hz})
                        .ptr;
  text += "MOTION\nFrames: " + std::to_string(motion.poses.size()) + "\nFrame Time: ";
  text.append(frame_time.data(), end);
  text += '\n';
  motion::PerRole<Eigen::Vector3d> angles;
  for (Eigen::Vector3d& angle : angles) angle.setZero();
  for (const motion::Pose& pose : motion.poses) append_frame(pose, angles, text);
  return text;
}

void write_bvh(const std::string& path, const motion::Physique& character,
               const motion::Motion& motion) {
  write_file_atomically(path, bvh_text(character, motion));
}

}  // namespace flinch::database
