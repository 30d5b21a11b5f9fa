// SPDX-License-Identifier: MIT
#include "database/import/loop_closing.h"

#include <cmath>
#include <cstdio>

#include "motion/error.h"
#include "motion/interpolation.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

using motion::Pose;
using motion::Role;

std::string number(float value, const char* format) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, double{value});
  return text.data();
}

void check_gap(const motion::LoopGap& gap, const std::string& where) {
  const float angle = motion::degrees(gap.angle);
  if (gap.height_m <= kMaxClosedGap_m && angle <= kMaxClosedGap_degrees) return;
  throw Error(where,
              "does not loop: between its end and its beginning the pelvis' height differs "
              "by " +
                  number(100 * gap.height_m, "%.1f") + " cm, and the " +
                  std::string(name_of(gap.joint)) + " by " + number(angle, "%.0f") +
                  " degrees; at most " + number(100 * kMaxClosedGap_m, "%.0f") + " cm and " +
                  number(kMaxClosedGap_degrees, "%.0f") +
                  " degrees are closed. Move start or end to the same moment of the "
                  "movement, such as the same foot's step");
}

/// Where the last pose belongs: the first one, moved along by what a cycle travels.
Pose next_beginning(const motion::Motion& motion) {
  const motion::PlanarMove travel = motion::Loop::in_cycles(motion).travel();
  const bool stays = travel.translation.norm() <= kMaxDrift_m &&
                     std::abs(travel.yaw) <= motion::radians(kMaxDrift_degrees);
  const Pose& first = motion.poses.front();
  return stays ? first : motion::placed(first, travel.yaw, travel.translation);
}

}  // namespace

motion::Motion closed_loop(const motion::Motion& motion, const std::string& where) {
  if (motion.poses.size() < 2) throw Error(where, "is too short for a stance: it has one pose");
  check_gap(motion::loop_gap(motion), where);
  const Pose end = next_beginning(motion);
  const Pose& last = motion.poses.back();
  motion::Motion closed = motion;
  for (std::size_t k = 0; k < closed.poses.size(); ++k) {
    const float share = static_cast<float>(k) / static_cast<float>(closed.poses.size() - 1);
    Pose& pose = closed.poses[k];
    pose.root_position += share * (end.root_position - last.root_position);
    for (Role role : motion::kRoles) {
      const Eigen::Quaternionf missing =
          motion::slerp(Eigen::Quaternionf::Identity(),
                        end.rotation[role] * last.rotation[role].conjugate(), share);
      pose.rotation[role] = (missing * pose.rotation[role]).normalized();
    }
  }
  closed.poses.back() = end;
  return closed;
}

}  // namespace flinch::database
