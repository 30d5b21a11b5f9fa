// SPDX-License-Identifier: MIT
#include "evolve/trial/pose_genes.h"

#include <gtest/gtest.h>

#include "database/author/stance.h"
#include "motion/default_character.h"
#include "motion/joint_limits.h"
#include "motion/support_polygon.h"
#include "tests/scenes/sample_count.h"

namespace flinch::evolve {
namespace {

using motion::Role;

class PoseGenesTest : public testing::Test {
 protected:
  motion::Figure figure_ = motion::make_figure(motion::default_character());
  motion::Pose start_ = database::standing_pose(figure_);
  features::Random random_{1, features::RandomStream::evolution, 0};

  Chromosome random_chromosome() {
    Chromosome chromosome(pose_genes().size());
    for (Gene& gene : chromosome) gene = static_cast<Gene>(random_.index(65536));
    return chromosome;
  }
};

TEST_F(PoseGenesTest, AreTwenty) {
  EXPECT_EQ(pose_genes().size(), 20U);
}

TEST_F(PoseGenesTest, EveryGeneTurnsItsOwnJointByItsAngleAndNoOther) {
  const std::span<const PoseGene> genes = pose_genes();
  for (int k = 0; k < tests::samples(50); ++k) {
    const Chromosome chromosome = random_chromosome();
    const motion::JointFrames frames =
        forward_kinematics(figure_.skeleton(), pose_of(figure_, start_, chromosome));
    for (std::size_t i = 0; i < genes.size(); ++i) {
      const motion::JointLimits& limits = motion::joint_limits_named(genes[i].joint);
      const Eigen::Vector3f angles =
          joint_angles(limits, relative_rotation(frames, limits.from, limits.to));
      EXPECT_NEAR(angles[genes[i].axis], value_of(chromosome[i], genes[i].range), 2e-3)
          << genes[i].joint << " " << genes[i].axis;
    }
  }
}

TEST_F(PoseGenesTest, PosesKeepHumanLimitsAndStandBalancedOnTheSameFeet) {
  const motion::JointFrames before = forward_kinematics(figure_.skeleton(), start_);
  for (int k = 0; k < tests::samples(200); ++k) {
    const motion::Pose pose = pose_of(figure_, start_, random_chromosome());
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

}  // namespace
}  // namespace flinch::evolve
