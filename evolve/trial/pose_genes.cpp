// SPDX-License-Identifier: MIT
#include "evolve/trial/pose_genes.h"

#include <vector>

#include "database/author/evasion.h"
#include "motion/interpolation.h"
#include "motion/joint_limits.h"
#include "motion/limb_ik.h"
#include "motion/rotation.h"
#include "sim/figure/waist_up.h"

namespace flinch::evolve {
namespace {

using motion::Pose;
using motion::Role;
using motion::Side;

// Appendix A's x points to the left, y up and z forward: our y, z and x.
constexpr std::array<PoseGene, 6> kThesisMiddle{{{"trunk", 1, {-0.05, 0.05}},
                                                 {"trunk", 2, {-0.5, 0.5}},
                                                 {"trunk", 0, {-0.05, 0.05}},
                                                 {"neck", 1, {-0.5, 0.7}},
                                                 {"neck", 2, {-0.5, 0.5}},
                                                 {"neck", 0, {-0.4, 0.4}}}};

// About what knees, hips and balance allow.
constexpr std::array<PoseGene, 6> kPelvisGenes{{{kPelvisShift, 0, {-0.2, 0.2}},
                                                {kPelvisShift, 1, {-0.25, 0.25}},
                                                {kPelvisShift, 2, {-0.35, 0}},
                                                {kPelvisTurn, 0, {-0.3, 0.3}},
                                                {kPelvisTurn, 1, {-0.3, 0.8}},
                                                {kPelvisTurn, 2, {-0.5, 0.5}}}};

PoseGene human_gene(std::string_view joint, int axis) {
  const motion::JointLimits& limits = motion::joint_limits_named(joint);
  return {limits.name,
          axis,
          {static_cast<double>(limits.min[axis]), static_cast<double>(limits.max[axis])}};
}

void add_arms(std::vector<PoseGene>& genes) {
  for (const std::string_view side : {"left_", "right_"}) {
    const std::string prefix(side);
    for (const int axis : {0, 1, 2}) genes.push_back(human_gene(prefix + "shoulder", axis));
    for (const int axis : {1, 2}) genes.push_back(human_gene(prefix + "elbow", axis));
    for (const int axis : {0, 2}) genes.push_back(human_gene(prefix + "wrist", axis));
  }
}

std::vector<PoseGene> make_upper_body_genes() {
  std::vector<PoseGene> genes(kThesisMiddle.begin(), kThesisMiddle.end());
  add_arms(genes);
  return genes;
}

std::vector<PoseGene> make_whole_body_genes() {
  std::vector<PoseGene> genes(kPelvisGenes.begin(), kPelvisGenes.end());
  for (const std::string_view joint : {"trunk", "neck"})
    for (const int axis : {0, 1, 2}) genes.push_back(human_gene(joint, axis));
  add_arms(genes);
  return genes;
}

/// A table of genes and their values.
struct GeneValues {
  std::span<const PoseGene> genes;
  std::span<const Gene> values;
  GeneMap map;

  /// What a row's genes stand for; 0 for axes without a gene.
  Eigen::Vector3f of(std::string_view joint) const {
    Eigen::Vector3f found = Eigen::Vector3f::Zero();
    for (std::size_t i = 0; i < genes.size(); ++i)
      if (genes[i].joint == joint)
        found[genes[i].axis] = static_cast<float>(angle_of(values[i], genes[i].range, map));
    return found;
  }
  Eigen::Quaternionf rotation_of(std::string_view joint) const {
    return rotation_of_angles(motion::joint_limits_named(joint), of(joint));
  }
};

motion::PerSide<motion::FootPose> feet_of(const motion::Figure& figure, const Pose& start) {
  const motion::JointFrames frames = motion::forward_kinematics(figure.skeleton(), start);
  return {foot_pose(frames, Side::left), foot_pose(frames, Side::right)};
}

void set_pelvis(const motion::Figure& figure, Pose& pose, const GeneValues& values) {
  const float leg_m = motion::limb_length(figure.skeleton(), motion::Limb::left_leg);
  const Eigen::Quaternionf facing =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), motion::facing(pose));
  pose.root_position += facing * (leg_m * values.of(kPelvisShift));
  pose.rotation[Role::pelvis] =
      pose.rotation[Role::pelvis] * motion::rotation_from_vector(values.of(kPelvisTurn));
}

void set_arm_rotations(Pose& pose, bool is_left, const GeneValues& values) {
  const auto role = [&](Role left) { return is_left ? left : motion::mirrored(left); };
  // The table's shoulder is the upper arm relative to the chest; a clavicle lies between them.
  const Eigen::Quaternionf& clavicle = pose.rotation[role(Role::left_clavicle)];
  pose.rotation[role(Role::left_upper_arm)] =
      (clavicle.conjugate() * values.rotation_of(is_left ? "left_shoulder" : "right_shoulder"))
          .normalized();
  pose.rotation[role(Role::left_forearm)] =
      values.rotation_of(is_left ? "left_elbow" : "right_elbow");
  pose.rotation[role(Role::left_hand)] = values.rotation_of(is_left ? "left_wrist" : "right_wrist");
}

}  // namespace

std::span<const PoseGene> pose_genes() {
  static const std::vector<PoseGene> genes = make_upper_body_genes();
  return genes;
}

std::span<const PoseGene> whole_body_genes() {
  static const std::vector<PoseGene> genes = make_whole_body_genes();
  return genes;
}

Pose pose_of(const motion::Figure& figure, const Pose& start, std::span<const PoseGene> genes,
             std::span<const Gene> values, GeneMap map) {
  const GeneValues read{genes, values, map};
  const auto half = [](const Eigen::Quaternionf& whole) {
    return motion::slerp(Eigen::Quaternionf::Identity(), whole, 0.5F);
  };
  Pose pose = start;
  set_pelvis(figure, pose, read);
  pose.rotation[Role::abdomen] = pose.rotation[Role::chest] = half(read.rotation_of("trunk"));
  pose.rotation[Role::neck] = pose.rotation[Role::head] = half(read.rotation_of("neck"));
  set_arm_rotations(pose, true, read);
  set_arm_rotations(pose, false, read);
  return database::balanced(figure, feet_of(figure, start), pose);
}

std::span<const PoseGene> waist_up_genes() {
  static const std::vector<PoseGene> kGenes = [] {
    std::vector<PoseGene> genes;
    for (const sim::WaistUpJoint& joint : sim::waist_up_joints())
      for (int axis = 0; axis < 3; ++axis)
        if (joint.range.min[axis] < joint.range.max[axis])
          genes.push_back(
              {name_of(joint.body), axis, {joint.range.min[axis], joint.range.max[axis]}});
    return genes;
  }();
  return kGenes;
}

Pose waist_up_pose_of(const motion::Figure& figure, const Pose& start, std::span<const Gene> values,
                      GeneMap map) {
  Pose pose = sim::waist_up_pose(start);
  std::size_t gene = 0;
  for (const sim::WaistUpJoint& joint : sim::waist_up_joints()) {
    Eigen::Vector3d angles = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis)
      if (joint.range.min[axis] < joint.range.max[axis])
        angles[axis] =
            angle_of(values[gene++], {joint.range.min[axis], joint.range.max[axis]}, map);
    pose.rotation[role_of(joint.body)] = sim::joint_rotation(joint.range, angles).cast<float>();
  }
  return database::balanced(figure, feet_of(figure, start), pose);
}

}  // namespace flinch::evolve
