// SPDX-License-Identifier: MIT
#include "evolve/trial/pose_genes.h"

#include <vector>

#include "database/author/evasion.h"
#include "motion/interpolation.h"
#include "motion/joint_limits.h"

namespace flinch::evolve {
namespace {

using motion::Pose;
using motion::Role;
using motion::Side;

// Appendix A's x points to the left, y up and z forward: our y, z and x.
constexpr std::array<PoseGene, 6> kMiddleGenes{{{"trunk", 1, {-0.05, 0.05}},
                                                {"trunk", 2, {-0.5, 0.5}},
                                                {"trunk", 0, {-0.05, 0.05}},
                                                {"neck", 1, {-0.5, 0.7}},
                                                {"neck", 2, {-0.5, 0.5}},
                                                {"neck", 0, {-0.4, 0.4}}}};

PoseGene human_gene(std::string_view joint, int axis) {
  const motion::JointLimits& limits = motion::joint_limits_named(joint);
  return {limits.name,
          axis,
          {static_cast<double>(limits.min[axis]), static_cast<double>(limits.max[axis])}};
}

std::vector<PoseGene> make_genes() {
  std::vector<PoseGene> genes(kMiddleGenes.begin(), kMiddleGenes.end());
  for (const std::string_view side : {"left_", "right_"}) {
    const std::string prefix(side);
    for (const int axis : {0, 1, 2}) genes.push_back(human_gene(prefix + "shoulder", axis));
    for (const int axis : {1, 2}) genes.push_back(human_gene(prefix + "elbow", axis));
    for (const int axis : {0, 2}) genes.push_back(human_gene(prefix + "wrist", axis));
  }
  return genes;
}

/// Returns the rotation of a row's joint that the genes stand for; angles without a gene are 0.
Eigen::Quaternionf rotation_of(std::string_view joint, const Chromosome& chromosome) {
  const std::span<const PoseGene> genes = pose_genes();
  Eigen::Vector3f angles = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < genes.size(); ++i) {
    if (genes[i].joint != joint) continue;
    angles[genes[i].axis] = static_cast<float>(value_of(chromosome[i], genes[i].range));
  }
  return rotation_of_angles(motion::joint_limits_named(joint), angles);
}

void set_arm_rotations(Pose& pose, bool is_left, const Chromosome& chromosome) {
  const auto role = [&](Role left) { return is_left ? left : motion::mirrored(left); };
  // The table's shoulder is the upper arm relative to the chest; a clavicle lies between them.
  const Eigen::Quaternionf& clavicle = pose.rotation[role(Role::left_clavicle)];
  pose.rotation[role(Role::left_upper_arm)] =
      (clavicle.conjugate() * rotation_of(is_left ? "left_shoulder" : "right_shoulder", chromosome))
          .normalized();
  pose.rotation[role(Role::left_forearm)] =
      rotation_of(is_left ? "left_elbow" : "right_elbow", chromosome);
  pose.rotation[role(Role::left_hand)] =
      rotation_of(is_left ? "left_wrist" : "right_wrist", chromosome);
}

}  // namespace

std::span<const PoseGene> pose_genes() {
  static const std::vector<PoseGene> genes = make_genes();
  return genes;
}

Pose pose_of(const motion::Figure& figure, const Pose& start, const Chromosome& chromosome) {
  const motion::JointFrames frames = motion::forward_kinematics(figure.skeleton(), start);
  const motion::PerSide<motion::FootPose> feet{foot_pose(frames, Side::left),
                                               foot_pose(frames, Side::right)};
  const auto half = [](const Eigen::Quaternionf& whole) {
    return motion::slerp(Eigen::Quaternionf::Identity(), whole, 0.5F);
  };
  Pose pose = start;
  pose.rotation[Role::abdomen] = pose.rotation[Role::chest] =
      half(rotation_of("trunk", chromosome));
  pose.rotation[Role::neck] = pose.rotation[Role::head] = half(rotation_of("neck", chromosome));
  set_arm_rotations(pose, true, chromosome);
  set_arm_rotations(pose, false, chromosome);
  return database::balanced(figure, feet, pose);
}

}  // namespace flinch::evolve
