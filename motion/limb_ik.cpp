// SPDX-License-Identifier: MIT
#include "motion/limb_ik.h"

#include <algorithm>
#include <cmath>

#include "motion/interpolation.h"
#include "motion/rotation.h"

namespace flinch::motion {
namespace {

Eigen::Vector3f rejection_from(const Eigen::Vector3f& vector, const Eigen::Vector3f& line) {
  return vector - vector.dot(line) * line;
}

// An arbitrary but fixed direction perpendicular to the line.
Eigen::Vector3f any_perpendicular_to(const Eigen::Vector3f& line) {
  const Eigen::Vector3f axis =
      std::abs(line.x()) < 0.9F ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitZ();
  return rejection_from(axis, line).normalized();
}

// Returns the direction, perpendicular to the line from upper joint to end, in which the middle
// joint lies. In a bent limb the middle joint shows it. In a straight limb it does not, and in a
// hyperextended one it shows the opposite; there the direction is the one in which the hinge bends,
// line x hinge. Between the two the result is interpolated, so that a limb that straightens does
// not spin about its length.
Eigen::Vector3f bending_direction(const Eigen::Vector3f& to_middle, const Eigen::Vector3f& to_end,
                                  const Eigen::Vector3f& hinge) {
  constexpr float kStraight =
      0.01F;                      // middle joint's distance from the line over the line's length
  constexpr float kBent = 0.05F;  // about 11 degrees at the hinge
  const float length = to_end.norm();
  if (length <= 0) return any_perpendicular_to(hinge);
  const Eigen::Vector3f line = to_end / length;
  const Eigen::Vector3f across = line.cross(hinge);
  if (across.norm() <= 0) return any_perpendicular_to(line);
  const Eigen::Vector3f by_hinge = across.normalized();
  const Eigen::Vector3f off_line = rejection_from(to_middle, line);
  const float bend = off_line.norm() / length;
  const float weight = ease_in_ease_out((bend - kStraight) / (kBent - kStraight));
  if (weight <= 0) return by_hinge;
  return ((1 - weight) * by_hinge + weight * off_line.normalized()).normalized();
}

// The rotation that takes the orthonormal pair `line`, `perpendicular` to the other pair.
Eigen::Quaternionf rotation_between_pairs(const Eigen::Vector3f& line,
                                          const Eigen::Vector3f& perpendicular,
                                          const Eigen::Vector3f& to_line,
                                          const Eigen::Vector3f& to_perpendicular) {
  Eigen::Matrix3f from;
  from << line, perpendicular, line.cross(perpendicular);
  Eigen::Matrix3f to;
  to << to_line, to_perpendicular, to_line.cross(to_perpendicular);
  return Eigen::Quaternionf(to * from.transpose()).normalized();
}

// Bend of a limb with bones a and b: the angle between their components perpendicular to the hinge.
float bend_angle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& hinge) {
  const Eigen::Vector3f a_perpendicular = rejection_from(a, hinge);
  const Eigen::Vector3f b_perpendicular = rejection_from(b, hinge);
  return std::atan2(hinge.dot(a_perpendicular.cross(b_perpendicular)),
                    a_perpendicular.dot(b_perpendicular));
}

// The hinge angle that brings the limb's end to a given distance from its upper joint.
//
// Split the bones a (upper) and b (lower) into components along the hinge (h) and perpendicular to
// it (s), and let beta be the angle from a_s to the rotated b_s. Then
//     d^2 = |a|^2 + |b|^2 + 2 a_h b_h + 2 |a_s| |b_s| cos(beta).
// beta is 0 for a straight limb, and beta = angle + beta_rest, where beta_rest is the angle between
// the bones at rest. Where beta need not be clamped, the end is at the distance.
struct HingeBend {
  float angle;    // of the lower joint's rotation
  bool in_reach;  // false: beta had to be clamped to the limits
};

// The constants of that equation: d^2 = rigid + 2 product cos(beta).
struct BendTerms {
  float rigid, product;
};

BendTerms bend_terms(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                     const Eigen::Vector3f& hinge) {
  const float along = a.dot(hinge) * b.dot(hinge);
  return {a.squaredNorm() + b.squaredNorm() + 2 * along,
          rejection_from(a, hinge).norm() * rejection_from(b, hinge).norm()};
}

HingeBend bend_for_distance(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                            const Eigen::Vector3f& hinge, float rest_bend, float distance,
                            const HingeLimits& limits) {
  const auto [rigid, product] = bend_terms(a, b, hinge);
  if (product <= 0) return {0, false};  // a bone of zero length

  const float cosine = (distance * distance - rigid) / (2 * product);
  const float wanted = std::acos(std::clamp(cosine, -1.0F, 1.0F));
  const float bend = std::clamp(wanted, limits.min, limits.max);
  if (std::abs(cosine) <= 1 && bend == wanted) return {bend - rest_bend, true};
  constexpr float kReachTolerance = 1e-4F;  // m
  const float found = std::sqrt(std::max(rigid + 2 * product * std::cos(bend), 0.0F));
  return {bend - rest_bend, std::abs(found - distance) <= kReachTolerance};
}

// The axis about which a limb bends: perpendicular to its bones where it is bent, its hinge where
// it is too straight for the bones to define one or is bent the wrong way, and interpolated in
// between.
Eigen::Vector3f bending_axis(const Eigen::Vector3f& upper_bone, const Eigen::Vector3f& lower_bone,
                             const Eigen::Vector3f& hinge) {
  constexpr float kStraight = 0.03F;  // sine of the bend
  constexpr float kBent = 0.15F;
  constexpr float kAnatomical = 0.5F;  // cosine between the bend's axis and the hinge
  const Eigen::Vector3f perpendicular = upper_bone.cross(lower_bone);
  const float size = perpendicular.norm();
  const float sine = size / std::max(upper_bone.norm() * lower_bone.norm(), 1e-9F);
  const float cosine = perpendicular.dot(hinge) / std::max(size, 1e-9F);
  const float weight = ease_in_ease_out((sine - kStraight) / (kBent - kStraight)) *
                       ease_in_ease_out(cosine / kAnatomical);
  if (weight <= 0) return hinge;
  const Eigen::Vector3f axis = (1 - weight) * hinge + weight / size * perpendicular;
  return axis.norm() > 1e-3F ? Eigen::Vector3f(axis.normalized()) : hinge;
}

}  // namespace

LimbRoles roles_of(Limb limb) {
  switch (limb) {
    case Limb::left_arm:
      return {Role::left_upper_arm, Role::left_forearm, Role::left_hand};
    case Limb::right_arm:
      return {Role::right_upper_arm, Role::right_forearm, Role::right_hand};
    case Limb::left_leg:
      return {Role::left_thigh, Role::left_shin, Role::left_foot};
    case Limb::right_leg:
      break;
  }
  return {Role::right_thigh, Role::right_shin, Role::right_foot};
}

Limb arm_of(Side side) {
  return side == Side::left ? Limb::left_arm : Limb::right_arm;
}

Limb leg_of(Side side) {
  return side == Side::left ? Limb::left_leg : Limb::right_leg;
}

float limb_length(const Skeleton& skeleton, Limb limb) {
  const LimbRoles roles = roles_of(limb);
  return skeleton.offset[roles.lower].norm() + skeleton.offset[roles.end].norm();
}

float max_upper_height(const Eigen::Vector3f& upper_position, const Eigen::Vector3f& end_position,
                       float reach) {
  const float across = (upper_position - end_position).head<2>().squaredNorm();
  return end_position.z() + std::sqrt(std::max(reach * reach - across, 0.0F));
}

float folded_limb_length(const Skeleton& skeleton, Limb limb, const HingeLimits& limits) {
  const LimbRoles roles = roles_of(limb);
  const auto [rigid, product] =
      bend_terms(skeleton.offset[roles.lower], skeleton.offset[roles.end], hinge_axis(limb));
  return std::sqrt(std::max(rigid + 2 * product * std::cos(limits.max), 0.0F));
}

Eigen::Vector3f hinge_axis(Limb limb) {
  if (limb == Limb::left_arm) return -Eigen::Vector3f::UnitZ();
  if (limb == Limb::right_arm) return Eigen::Vector3f::UnitZ();
  return Eigen::Vector3f::UnitY();
}

LimbSolution solve_limb(const Skeleton& skeleton, Limb limb, const Eigen::Vector3f& upper_position,
                        const Eigen::Vector3f& end_position, const Eigen::Vector3f& pole_vector,
                        float swivel, const HingeLimits& limits) {
  const LimbRoles roles = roles_of(limb);
  const Eigen::Vector3f& upper_bone = skeleton.offset[roles.lower];
  const Eigen::Vector3f& lower_bone = skeleton.offset[roles.end];
  const Eigen::Vector3f hinge = hinge_axis(limb);
  const Eigen::Vector3f to_target = end_position - upper_position;
  const float distance = to_target.norm();

  const HingeBend bend = bend_for_distance(
      upper_bone, lower_bone, hinge, bend_angle(upper_bone, lower_bone, hinge), distance, limits);
  const Eigen::Quaternionf lower_local = rotation_about(hinge, bend.angle);
  const Eigen::Vector3f to_end = upper_bone + lower_local * lower_bone;  // in the upper frame

  const Eigen::Vector3f line =
      distance > 0 ? Eigen::Vector3f(to_target / distance) : -Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f pole_off_line = rejection_from(pole_vector, line);
  constexpr float kParallel = 1e-6F;
  const Eigen::Vector3f perpendicular = pole_off_line.norm() > kParallel * pole_vector.norm()
                                            ? Eigen::Vector3f(pole_off_line.normalized())
                                            : any_perpendicular_to(line);

  LimbSolution solution;
  solution.upper =
      rotation_between_pairs(to_end.normalized(), bending_direction(upper_bone, to_end, hinge),
                             line, rotation_about(line, swivel) * perpendicular);
  solution.lower = (solution.upper * lower_local).normalized();
  solution.reached = bend.in_reach;
  return solution;
}

Eigen::Vector3f pole_vector(const JointFrames& frames, Limb limb) {
  const LimbRoles roles = roles_of(limb);
  const Eigen::Vector3f& upper = frames.position[roles.upper];
  return bending_direction(frames.position[roles.lower] - upper, frames.position[roles.end] - upper,
                           frames.orientation[roles.upper] * hinge_axis(limb));
}

bool move_limb_end(const JointFrames& frames, Limb limb, const Eigen::Vector3f& end_position,
                   const Eigen::Quaternionf& end_orientation, Pose& pose,
                   const HingeLimits& limits) {
  const LimbRoles roles = roles_of(limb);
  const Eigen::Vector3f& root = frames.position[roles.upper];
  const Eigen::Vector3f upper_bone = frames.position[roles.lower] - root;
  const Eigen::Vector3f lower_bone = frames.position[roles.end] - frames.position[roles.lower];
  const Eigen::Vector3f axis =
      bending_axis(upper_bone, lower_bone, frames.orientation[roles.upper] * hinge_axis(limb));
  const float now = bend_angle(upper_bone, lower_bone, axis);
  const HingeBend bend =
      bend_for_distance(upper_bone, lower_bone, axis, now, (end_position - root).norm(),
                        {std::min(limits.min, now), std::max(limits.max, now)});
  const Eigen::Quaternionf flex = rotation_about(axis, bend.angle);
  const Eigen::Quaternionf swing =
      rotation_between<float>(upper_bone + flex * lower_bone, end_position - root);
  const Eigen::Quaternionf& parent = frames.orientation[*parent_of(roles.upper)];
  const Eigen::Quaternionf upper = swing * frames.orientation[roles.upper];
  const Eigen::Quaternionf lower = swing * flex * frames.orientation[roles.lower];
  pose.rotation[roles.upper] = (parent.conjugate() * upper).normalized();
  pose.rotation[roles.lower] = (upper.conjugate() * lower).normalized();
  pose.rotation[roles.end] = (lower.conjugate() * end_orientation).normalized();
  return bend.in_reach;
}

Pose with_limb_end(const Skeleton& skeleton, const Pose& pose, Limb limb,
                   const Eigen::Vector3f& end_position, const Eigen::Quaternionf& end_orientation,
                   bool* reached) {
  const LimbRoles roles = roles_of(limb);
  const JointFrames frames = forward_kinematics(skeleton, pose);
  const LimbSolution solution = solve_limb(skeleton, limb, frames.position[roles.upper],
                                           end_position, pole_vector(frames, limb), 0);
  const Eigen::Quaternionf& parent = frames.orientation[*parent_of(roles.upper)];
  Pose result = pose;
  result.rotation[roles.upper] = (parent.conjugate() * solution.upper).normalized();
  result.rotation[roles.lower] = (solution.upper.conjugate() * solution.lower).normalized();
  result.rotation[roles.end] = (solution.lower.conjugate() * end_orientation).normalized();
  if (reached != nullptr) *reached = solution.reached;
  return result;
}

}  // namespace flinch::motion
