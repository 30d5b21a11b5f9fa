// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "database/import/plausibility.h"
#include "database/import/source_character.h"
#include "motion/default_character.h"

namespace flinch::database {
namespace {

using Eigen::Vector3d;
using motion::mirrored;
using motion::Role;

using Notes = std::vector<std::string>;

// By what factor the stature may differ from the default character's.
constexpr double kMaxStatureFactor = 1.25;
// By what factor the length of a bone may differ from that of its mirror image.
constexpr double kMaxSideFactor = 1.15;
// Frame rates that motion capture usually has, Hz.
constexpr double kMinUsualRate_hz = 10;
constexpr double kMaxUsualRate_hz = 1000;

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char line[200];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

double factor_between(double one, double other) {
  return std::max(one, other) / std::min(one, other);
}

// A length that is compared with the thigh's.
struct Proportion {
  const char* name;
  double of_thigh;
  double max_factor;  // by which it may differ from the default character's
};

// `tip(role)` is the length of a bone, `place(role)` the position of its joint in the rest pose.
template <class Length, class Place>
std::array<Proportion, 6> proportions(Length length, Place place) {
  const auto middle = [&](Role left) -> Vector3d {
    return 0.5 * (place(left) + place(mirrored(left)));
  };
  const auto breadth = [&](Role left) -> double {
    return (place(left) - place(mirrored(left))).norm();
  };
  const double trunk = (middle(Role::left_upper_arm) - middle(Role::left_thigh)).norm();
  const double thigh = length(Role::left_thigh);
  return {{{"shin", length(Role::left_shin) / thigh, 1.6},
           {"upper arm", length(Role::left_upper_arm) / thigh, 1.6},
           {"forearm", length(Role::left_forearm) / thigh, 1.6},
           {"trunk from hips to shoulders", trunk / thigh, 1.6},
           {"breadth of the hips", breadth(Role::left_thigh) / thigh, 2.0},
           {"breadth of the shoulders", breadth(Role::left_upper_arm) / thigh, 2.0}}};
}

void judge_proportions(const Source& source, Notes& notes) {
  const motion::Skeleton human = motion::default_character().skeleton;
  const motion::JointFrames rest = forward_kinematics(human, motion::rest_pose(human));
  const auto usual =
      proportions([&](Role role) -> double { return human.tip[role].norm(); },
                  [&](Role role) -> Vector3d { return rest.position[role].cast<double>(); });
  const auto own = proportions(
      [&](Role role) {
        return 0.5 * (bone_length_m(source, role) + bone_length_m(source, mirrored(role)));
      },
      [&](Role role) -> Vector3d {
        return source.metres_per_unit * source.reference.position[role];
      });
  for (std::size_t i = 0; i < own.size(); ++i) {
    const bool is_odd = factor_between(own[i].of_thigh, usual[i].of_thigh) > own[i].max_factor;
    if (!is_odd) continue;
    notes.push_back(
        formatted("the %s is %.2f thighs long, a human's %.2f; look at the roles with info "
                  "and correct them with --roles",
                  own[i].name, own[i].of_thigh, usual[i].of_thigh));
  }
}

void judge_sides(const Source& source, Notes& notes) {
  for (Role left : {Role::left_thigh, Role::left_shin, Role::left_upper_arm, Role::left_forearm}) {
    const double own = bone_length_m(source, left);
    const double other = bone_length_m(source, mirrored(left));
    const bool is_odd = factor_between(own, other) > kMaxSideFactor;
    if (!is_odd) continue;
    notes.push_back(
        formatted("%s is %.3f m long and %s %.3f m; look at the roles with info and correct "
                  "them with --roles",
                  std::string(name_of(left)).c_str(), own,
                  std::string(name_of(mirrored(left))).c_str(), other));
  }
}

void judge_stature(const Source& source, Notes& notes) {
  const motion::Physique character = character_of(source);
  const auto stature = static_cast<double>(motion::stature(character.skeleton));
  const auto usual = static_cast<double>(motion::stature(motion::default_character().skeleton));
  if (factor_between(stature, usual) <= kMaxStatureFactor) return;
  notes.push_back(
      formatted("the figure is %.2f m tall, with a mass of %.0f kg, in %s; say the unit with "
                "--unit, or correct the roles with --roles",
                stature, static_cast<double>(character.mass_kg),
                std::string(name_of(source.report.unit)).c_str()));
}

void judge_rate(const Source& source, Notes& notes) {
  if (source.bvh.frame_count < 2) return;
  const double rate_hz = 1 / source.bvh.frame_time_s;
  if (rate_hz >= kMinUsualRate_hz && rate_hz <= kMaxUsualRate_hz) return;
  notes.push_back(
      formatted("a frame lasts %.4g s, which is %.4g Hz; say the right rate with "
                "--rate-of-file",
                source.bvh.frame_time_s, rate_hz));
}

}  // namespace

std::vector<std::string> judge_figure(const Source& source) {
  Notes notes;
  judge_stature(source, notes);
  judge_proportions(source, notes);
  judge_sides(source, notes);
  if (source.reference.feet_point_backward) {
    notes.emplace_back(
        "both feet point backward: the file is left-handed, or left and right are exchanged; "
        "exchange left and right with --roles");
  }
  judge_rate(source, notes);
  return notes;
}

}  // namespace flinch::database
