// SPDX-License-Identifier: MIT
#include "evolve/trial/pose_genes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "database/author/stance.h"
#include "motion/default_character.h"
#include "motion/joint_limits.h"
#include "motion/limb_ik.h"
#include "motion/rotation.h"
#include "motion/support_polygon.h"
#include "sim/figure/waist_up.h"
#include "tests/scenes/sample_count.h"

namespace flinch::evolve {
namespace {

using motion::Role;

class PoseGenesTest : public testing::Test {
 protected:
  motion::Figure figure_ = motion::make_figure(motion::default_character());
  motion::Pose start_ = database::standing_pose(figure_);
  features::Random random_{1, features::RandomStream::evolution, 0};

  Chromosome random_chromosome(std::span<const PoseGene> genes) {
    Chromosome chromosome(genes.size());
    for (Gene& gene : chromosome) gene = static_cast<Gene>(random_.index(65536));
    return chromosome;
  }
};

TEST_F(PoseGenesTest, AreTwentyAndTwentySixForTheWholeBody) {
  EXPECT_EQ(pose_genes().size(), 20U);
  EXPECT_EQ(whole_body_genes().size(), 26U);
}

TEST_F(PoseGenesTest, AreEighteenForTheThesisCharacterAndReachItsLimits) {
  const std::span<const PoseGene> genes = waist_up_genes();
  ASSERT_EQ(genes.size(), 18U);
  for (int k = 0; k < tests::samples(100); ++k) {
    Chromosome chromosome = random_chromosome(genes);
    if (k == 0) chromosome.assign(18, 0);
    if (k == 1) chromosome.assign(18, kMaxGene);
    const motion::Pose pose = waist_up_pose_of(figure_, start_, chromosome);
    for (std::size_t i = 0; i < genes.size(); ++i) {
      const auto joints = sim::waist_up_joints();
      const auto joint = std::ranges::find(
          joints, genes[i].joint, [](const sim::WaistUpJoint& at) { return name_of(at.body); });
      ASSERT_NE(joint, joints.end());
      const Eigen::Vector3d angles =
          joint_angles(joint->range, pose.rotation[role_of(joint->body)].cast<double>());
      EXPECT_NEAR(angles[genes[i].axis], value_of(chromosome[i], genes[i].range), 2e-3)
          << genes[i].joint << " " << genes[i].axis;
    }
    // The figure of the character can want exactly this pose.
    const motion::Pose held = sim::waist_up_pose(pose);
    for (const Role role : motion::kRoles)
      EXPECT_LT(held.rotation[role].angularDistance(pose.rotation[role]), 2e-3F);
  }
}

TEST_F(PoseGenesTest, EveryGeneTurnsItsOwnJointByItsAngleAndNoOther) {
  for (int k = 0; k < tests::samples(100); ++k) {
    const std::span<const PoseGene> genes = k % 2 == 0 ? pose_genes() : whole_body_genes();
    const Chromosome chromosome = random_chromosome(genes);
    const motion::JointFrames frames =
        forward_kinematics(figure_.skeleton(), pose_of(figure_, start_, genes, chromosome));
    for (std::size_t i = 0; i < genes.size(); ++i) {
      if (genes[i].joint == kPelvisShift || genes[i].joint == kPelvisTurn) continue;
      const motion::JointLimits& limits = motion::joint_limits_named(genes[i].joint);
      const Eigen::Vector3f angles =
          joint_angles(limits, relative_rotation(frames, limits.from, limits.to));
      EXPECT_NEAR(angles[genes[i].axis], value_of(chromosome[i], genes[i].range), 2e-3)
          << genes[i].joint << " " << genes[i].axis;
    }
  }
}

TEST_F(PoseGenesTest, WithEquation45EveryJointTurnsByTheAngleHeldAtItsLimits) {
  int held = 0;
  for (int k = 0; k < tests::samples(100); ++k) {
    const Chromosome chromosome = random_chromosome(pose_genes());
    const motion::JointFrames frames = forward_kinematics(
        figure_.skeleton(), pose_of(figure_, start_, pose_genes(), chromosome, GeneMap::full_turn));
    for (std::size_t i = 0; i < pose_genes().size(); ++i) {
      const PoseGene& gene = pose_genes()[i];
      const motion::JointLimits& limits = motion::joint_limits_named(gene.joint);
      const Eigen::Vector3f angles =
          joint_angles(limits, relative_rotation(frames, limits.from, limits.to));
      const double wanted = 2 * std::numbers::pi * chromosome[i] / 65535 - std::numbers::pi;
      const double expected = std::min(std::max(wanted, gene.range.min), gene.range.max);
      EXPECT_NEAR(angles[gene.axis], expected, 2e-3) << gene.joint << " " << gene.axis;
      held += expected != wanted ? 1 : 0;
    }
  }
  EXPECT_GT(held, tests::samples(100) * 10);  // most of the 20: a reason for the default map
}

TEST_F(PoseGenesTest, TheThesisCharacterReadsEquation45Too) {
  const std::span<const PoseGene> genes = waist_up_genes();
  Chromosome turned(genes.size());
  Chromosome direct(genes.size());
  for (std::size_t i = 0; i < genes.size(); ++i) {
    turned[i] = static_cast<Gene>(random_.index(65536));
    const GeneRange& range = genes[i].range;
    const double angle = angle_of(turned[i], range, GeneMap::full_turn);
    direct[i] =
        static_cast<Gene>(std::lround((angle - range.min) / (range.max - range.min) * kMaxGene));
  }
  const motion::Pose a = waist_up_pose_of(figure_, start_, turned, GeneMap::full_turn);
  const motion::Pose b = waist_up_pose_of(figure_, start_, direct);
  for (const Role role : motion::kRoles)
    EXPECT_LT(a.rotation[role].angularDistance(b.rotation[role]), 2e-3F);
}

TEST_F(PoseGenesTest, PosesKeepHumanLimitsAndStandBalancedOnTheSameFeet) {
  const motion::JointFrames before = forward_kinematics(figure_.skeleton(), start_);
  for (int k = 0; k < tests::samples(200); ++k) {
    const motion::Pose pose =
        pose_of(figure_, start_, pose_genes(), random_chromosome(pose_genes()));
    const motion::JointFrames frames = forward_kinematics(figure_.skeleton(), pose);
    for (const motion::JointLimits& limits : motion::human_joint_limits())
      EXPECT_LT(limit_excess(limits, relative_rotation(frames, limits.from, limits.to)), 2e-3F)
          << limits.name;
    for (const Role foot : {Role::left_foot, Role::right_foot})
      EXPECT_LT((frames.position[foot] - before.position[foot]).norm(), 1e-3F);
    EXPECT_GT(
        motion::signed_distance_inside(motion::support_polygon(figure_.skeleton(), frames, 0.005F),
                                       motion::centre_of_mass(figure_.bodies, frames).head<2>()),
        0.025F);
  }
}

// Turned and shifted so little that the balance and the legs' length ask for nothing more.
TEST_F(PoseGenesTest, ThePelvisMovesAndTurnsInTheStartsFrame) {
  const std::span<const PoseGene> genes = whole_body_genes();
  const float leg_m = motion::limb_length(figure_.skeleton(), motion::Limb::left_leg);
  start_ = motion::placed(start_, motion::radians(90.0F), {3, 4, 0});
  const auto gene_for = [&](std::size_t i, double value) {
    const GeneRange& range = genes[i].range;
    return static_cast<Gene>(std::lround((value - range.min) / (range.max - range.min) * kMaxGene));
  };
  Chromosome chromosome(genes.size());
  for (std::size_t i = 0; i < genes.size(); ++i) chromosome[i] = gene_for(i, 0);
  const motion::Pose straight = pose_of(figure_, start_, genes, chromosome);
  chromosome[1] = gene_for(1, 0.01);  // to the left
  chromosome[2] = gene_for(2, -0.1);  // down
  chromosome[5] = gene_for(5, 0.2);   // to the left
  const motion::Pose moved = pose_of(figure_, start_, genes, chromosome);
  const Eigen::Vector3f shift = moved.root_position - straight.root_position;
  EXPECT_NEAR(shift.x(), -0.01F * leg_m, 2e-3F);
  EXPECT_NEAR(shift.y(), 0, 2e-3F);
  EXPECT_NEAR(motion::facing(moved) - motion::facing(straight), 0.2F, 1e-3F);
  EXPECT_LT(shift.z(), -0.09F * leg_m);
}

}  // namespace
}  // namespace flinch::evolve
