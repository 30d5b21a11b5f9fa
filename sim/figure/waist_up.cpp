// SPDX-License-Identifier: MIT
#include "sim/figure/waist_up.h"

#include <array>
#include <cmath>
#include <numbers>

#include "motion/rotation.h"

namespace flinch::sim {
namespace {

using Eigen::Vector3d;
using motion::Body;
using motion::Role;

// Beyond a limit both gains rise so that the damping ratio stays.
constexpr double kHardLimitRatio = 20;
// Of the hips, which the thesis holds: ten times the frequency of people's pelvis.
constexpr double kHipsStiffness = 100;

JointRange range_about(const Vector3d& bone, const Vector3d& min, const Vector3d& max) {
  return {Eigen::Quaterniond::Identity(), bone, min, max};
}

/// Of the right side: under reflection in the XZ plane, angles about X and Z change sign.
WaistUpJoint mirrored(WaistUpJoint joint, Body body) {
  const auto [min, max] = std::pair(joint.range.min, joint.range.max);
  joint.body = body;
  joint.range.bone.y() = -joint.range.bone.y();
  joint.range.min = {-max.x(), min.y(), -max.z()};
  joint.range.max = {-min.x(), max.y(), -min.z()};
  return joint;
}

std::array<WaistUpJoint, 8> make_joints() {
  const Vector3d up = Vector3d::UnitZ();
  const Vector3d left = Vector3d::UnitY();
  const WaistUpJoint chest{Body::abdomen,
                           JointKind::ball,
                           range_about(up, {-0.05, -0.05, -0.5}, {0.05, 0.05, 0.5}),
                           {5000, 100}};
  const WaistUpJoint head{
      Body::neck, JointKind::ball, range_about(up, {-0.4, -0.5, -0.5}, {0.4, 0.7, 0.5}), {100, 10}};
  const WaistUpJoint upper_arm{Body::left_upper_arm,
                               JointKind::ball,
                               range_about(left, {-1.2, -1.2, -2.2}, {1.2, 1.2, 1.2}),
                               {400, 10}};
  const WaistUpJoint forearm{
      Body::left_forearm, JointKind::hinge, range_about(left, {0, 0, -2.4}, {0, 0, 0}), {300, 5}};
  const WaistUpJoint hand{
      Body::left_hand, JointKind::saddle, range_about(left, {-1, 0, -0.5}, {1, 0, 0.5}), {100, 1}};
  return {chest,     head,
          upper_arm, mirrored(upper_arm, Body::right_upper_arm),
          forearm,   mirrored(forearm, Body::right_forearm),
          hand,      mirrored(hand, Body::right_hand)};
}

double volume_of(const motion::Shape& shape) {
  if (shape.kind == motion::Shape::Kind::box) return 8 * double{shape.half_extents.prod()};
  const double radius = double{shape.radius};
  return std::numbers::pi * radius * radius * (2 * double{shape.half_length} + 4.0 / 3.0 * radius);
}

/// The rotation of a joint whose angles are truncated.
Eigen::Quaternionf truncated(const WaistUpJoint& joint, const Eigen::Quaternionf& rotation) {
  const Vector3d angles = joint_angles(joint.range, rotation.cast<double>());
  return joint_rotation(joint.range, angles.cwiseMax(joint.range.min).cwiseMin(joint.range.max))
      .cast<float>();
}

}  // namespace

std::span<const WaistUpJoint> waist_up_joints() {
  static const std::array<WaistUpJoint, 8> kJoints = make_joints();
  return kJoints;
}

motion::BodyModel with_uniform_density(motion::BodyModel model) {
  double mass_kg = 0;
  double volume = 0;
  for (const motion::BodyProperties& body : model) {
    mass_kg += double{body.mass_kg};
    volume += volume_of(body.shape);
  }
  for (motion::BodyProperties& body : model) {
    body.mass_kg = static_cast<float>(mass_kg / volume * volume_of(body.shape));
    body.centre_of_mass = body.shape.centre;
  }
  return model;
}

void make_waist_up(FigureModel& figure_model) {
  for (const Body body : motion::kBodies) {
    figure_model.kinds[body] = JointKind::fixed;
    figure_model.laws[body] = {.follows_velocity = false};
  }
  const motion::JointFrames rest =
      forward_kinematics(figure_model.skeleton, rest_pose(figure_model.skeleton));
  const Gains& shoulder = waist_up_joints()[2].gains;
  const double unit = 4 * shoulder.stiffness *
                      composite_inertia(figure_model, rest, Body::left_upper_arm) /
                      (shoulder.damping * shoulder.damping);
  for (const WaistUpJoint& joint : waist_up_joints()) {
    figure_model.kinds[joint.body] = joint.kind;
    figure_model.limits[joint.body] = joint.range;
    if (joint.kind == JointKind::hinge) figure_model.hinge[joint.body] = Vector3d::UnitZ();
    Gains& gains = figure_model.gains[joint.body];
    gains = {unit * joint.gains.stiffness, unit * joint.gains.damping};
    ServoLaw& law = figure_model.laws[joint.body];
    law.limit_stiffness = kHardLimitRatio * gains.stiffness;
    law.limit_damping = (std::sqrt(1 + kHardLimitRatio) - 1) * gains.damping;
    if (joint.kind == JointKind::ball) law.twist_share = kThesisTwistShare;
  }
  for (Gains* hips : {&figure_model.gains[Body::pelvis], &figure_model.pelvis_gains})
    *hips = scaled_gains(*hips, kHipsStiffness);
  for (const Body body : {Body::pelvis, Body::left_thigh, Body::left_shin, Body::left_foot,
                          Body::right_thigh, Body::right_shin, Body::right_foot})
    figure_model.ball_meets &= ~set_of(body);
}

motion::Pose waist_up_pose(const motion::Pose& pose) {
  motion::Pose held = pose;
  const auto& turn = pose.rotation;
  const std::array<Eigen::Quaternionf, 8> wanted{
      turn[Role::abdomen] * turn[Role::chest],
      turn[Role::neck] * turn[Role::head],
      turn[Role::left_clavicle] * turn[Role::left_upper_arm],
      turn[Role::right_clavicle] * turn[Role::right_upper_arm],
      turn[Role::left_forearm],
      turn[Role::right_forearm],
      turn[Role::left_hand],
      turn[Role::right_hand]};
  for (const Role none : {Role::chest, Role::head, Role::left_clavicle, Role::right_clavicle})
    held.rotation[none] = Eigen::Quaternionf::Identity();
  for (std::size_t i = 0; i < wanted.size(); ++i)
    held.rotation[role_of(waist_up_joints()[i].body)] = truncated(waist_up_joints()[i], wanted[i]);
  return held;
}

motion::Motion waist_up_motion(motion::Motion motion) {
  for (motion::Pose& pose : motion.poses) pose = waist_up_pose(pose);
  return motion;
}

}  // namespace flinch::sim
