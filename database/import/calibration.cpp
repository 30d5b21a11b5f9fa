// SPDX-License-Identifier: MIT
#include "database/import/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "motion/limb_ik.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

using Eigen::Quaternionf;
using Eigen::Vector3f;
using motion::Limb;
using motion::Role;

constexpr std::array<motion::LimbRoles, 2> kFeet{
    {{Role::left_shin, Role::left_foot, Role::left_toes},
     {Role::right_shin, Role::right_foot, Role::right_toes}}};

// Quantile of a flat foot's heights over a take that is its planted height: nearly the lowest,
// without the glitches.
constexpr double kPlantedQuantile = 0.02;

float quantile(std::vector<float>& values, double fraction) {
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Returns the height of a foot's point while planted; nothing if the foot is never flat.
template <class Height>
std::optional<float> planted_height(const SourceMotion& motion, std::size_t side, Height height) {
  constexpr float kFlat = 0.9F;  // cosine of the foot's tilt: within 26 degrees
  std::vector<float> heights;
  for (const SourceFrame& frame : motion.frames) {
    const Vector3f up = frame.orientation[kFeet[side].lower] * Vector3f::UnitZ();
    if (up.z() > kFlat) heights.push_back(height(frame.foot[side]));
  }
  if (heights.empty()) return std::nullopt;
  return quantile(heights, kPlantedQuantile);
}

// Returns the planted heights of both feet. A foot that is never put down has the other's.
template <class Height>
std::array<float, 2> planted_heights(const SourceMotion& motion, Height height) {
  constexpr float kFeetDiffer = 0.05F;  // of the leg's length: more is not due to markers
  const std::optional<float> left = planted_height(motion, 0, height);
  const std::optional<float> right = planted_height(motion, 1, height);
  if (!left && !right) {
    float lowest = height(motion.frames.front().foot[0]);
    for (const SourceFrame& frame : motion.frames) {
      for (const SourceFoot& foot : frame.foot) lowest = std::min(lowest, height(foot));
    }
    return {lowest, lowest};
  }
  const float lower = std::min(left ? *left : *right, right ? *right : *left);
  const auto own = [&](const std::optional<float>& found) {
    return found && *found - lower < kFeetDiffer * motion.leg_length_m ? *found : lower;
  };
  return {own(left), own(right)};
}

// Returns the axis about which a limb bends in the motion, in the upper joint's frame, weighted by
// how much it bends; nothing where that is too little or the axis varies.
std::optional<Vector3f> hinge_in_motion(const SourceMotion& motion, Limb limb) {
  constexpr float kBent = 0.26F;    // sine of 15 degrees
  constexpr float kOneAxis = 0.9F;  // length of the mean of unit axes
  constexpr float kEnough = 0.02F;  // of the frames, weighted
  const motion::LimbRoles roles = motion::roles_of(limb);
  const bool is_arm = limb == Limb::left_arm || limb == Limb::right_arm;
  const float outward = limb == Limb::left_arm ? 1.0F : -1.0F;
  const Vector3f bone = is_arm ? Vector3f(0, outward, 0) : Vector3f(0, 0, -1);
  Vector3f sum = Vector3f::Zero();
  float weight = 0;
  for (const SourceFrame& frame : motion.frames) {
    const Quaternionf& upper = frame.orientation[roles.upper];
    const Vector3f axis = (upper * bone).cross(frame.orientation[roles.lower] * bone);
    if (axis.norm() < kBent) continue;
    sum += upper.conjugate() * axis;
    weight += axis.norm();
  }
  if (weight < kEnough * static_cast<float>(motion.frames.size())) return std::nullopt;
  if (sum.norm() < kOneAxis * weight) return std::nullopt;
  return sum.normalized();
}

// For legs that hardly bend: the knee's axis is perpendicular to the mean direction of the foot.
Vector3f hinge_across_foot(const SourceMotion& motion, std::size_t side) {
  const Limb leg = side == 0 ? Limb::left_leg : Limb::right_leg;
  Vector3f sum = Vector3f::Zero();
  for (const SourceFrame& frame : motion.frames) {
    const Vector3f across = frame.orientation[kFeet[side].lower] * Vector3f::UnitY();
    sum += frame.orientation[motion::roles_of(leg).upper].conjugate() * across;
  }
  sum.z() = 0;  // perpendicular to the bone
  return sum;
}

}  // namespace

void set_ground(SourceMotion& motion) {
  motion.ankle_height_m =
      planted_heights(motion, [](const SourceFoot& foot) { return foot.ankle.z(); });
  motion.ball_height_m =
      planted_heights(motion, [](const SourceFoot& foot) { return foot.ball.z(); });
  const float ground = std::min({motion.ankle_height_m[0], motion.ankle_height_m[1],
                                 motion.ball_height_m[0], motion.ball_height_m[1]});
  for (float& height : motion.ankle_height_m) height -= ground;
  for (float& height : motion.ball_height_m) height -= ground;
  for (SourceFrame& frame : motion.frames) {
    frame.hip_centre.z() -= ground;
    for (SourceFoot& foot : frame.foot) {
      foot.ankle.z() -= ground;
      foot.ball.z() -= ground;
    }
  }
}

void level_feet(SourceMotion& motion) {
  constexpr float kLowest = 0.01F;   // m above the planted height
  constexpr float kLargest = 0.94F;  // cosine of 20 degrees
  for (std::size_t side = 0; side < 2; ++side) {
    Vector3f up_in_foot = Vector3f::Zero();
    for (const SourceFrame& frame : motion.frames) {
      if (frame.foot[side].ankle.z() > motion.ankle_height_m[side] + kLowest) continue;
      up_in_foot += frame.orientation[kFeet[side].lower].conjugate() * Vector3f::UnitZ();
    }
    if (up_in_foot.normalized().z() < kLargest) continue;
    const Quaternionf correction = motion::rotation_between<float>(Vector3f::UnitZ(), up_in_foot);
    for (SourceFrame& frame : motion.frames) {
      for (Role role : {kFeet[side].lower, kFeet[side].end}) {
        frame.orientation[role] = (frame.orientation[role] * correction).normalized();
      }
    }
  }
}

void align_hinges(SourceMotion& motion) {
  for (Limb limb : motion::kLimbs) {
    std::optional<Vector3f> found = hinge_in_motion(motion, limb);
    if (!found && limb == Limb::left_leg) found = hinge_across_foot(motion, 0);
    if (!found && limb == Limb::right_leg) found = hinge_across_foot(motion, 1);
    if (!found) continue;
    const Quaternionf correction =
        motion::rotation_between<float>(motion::hinge_axis(limb), *found);
    const Role upper = motion::roles_of(limb).upper;
    for (SourceFrame& frame : motion.frames) {
      frame.orientation[upper] = (frame.orientation[upper] * correction).normalized();
    }
  }
}

}  // namespace flinch::database
