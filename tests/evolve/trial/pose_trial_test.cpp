// SPDX-License-Identifier: MIT
#include "evolve/trial/pose_trial.h"

#include <gtest/gtest.h>

#include <cstring>

#include "database/author/stance.h"
#include "database/quality/quality.h"
#include "motion/default_character.h"
#include "motion/error.h"
#include "motion/joint_limits.h"
#include "motion/rotation.h"
#include "tests/scenes/error_of.h"

namespace flinch::evolve {
namespace {

using motion::Role;

class PoseTrialTest : public testing::Test {
 protected:
  motion::Physique character_ = motion::default_character();
  motion::Motion idle_ = database::idle_motion(motion::make_figure(character_), 60);
  features::Random random_{2, features::RandomStream::evolution, 0};

  TrialOptions options(Style style = Style::free) const {
    TrialOptions options;
    options.style = style;
    options.thrown =
        throw_at(character_, idle_, motion::Target::head, motion::radians(20.0), 0, 25, 0.5);
    return options;
  }
  std::vector<Chromosome> chromosomes(std::size_t count, std::size_t genes = pose_genes().size()) {
    std::vector<Chromosome> all(count, Chromosome(genes));
    for (Chromosome& chromosome : all)
      for (Gene& gene : chromosome) gene = static_cast<Gene>(random_.index(65536));
    return all;
  }
  /// One simulation of 36 at a time, by the reference solver from the start on.
  void expect_mean_of_reference(const PoseTrial& trial) {
    const std::vector<Chromosome> poses = chromosomes(2, trial.genes().size());
    const auto scores = trial.test(poses, 5, 1);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      double fast = 0;
      double slow = 0;
      for (const JointFailure failure : kJointFailures) {
        for (const features::Ball& ball : trial.balls(5)) {
          const std::span<const features::Ball> one(&ball, 1);
          fast += trial.mean_pain(trial.simulate(poses[i], failure, one)) / 36;
          slow += trial.mean_pain(trial.simulate_by_reference(poses[i], failure, one)) / 36;
        }
      }
      EXPECT_NEAR((*scores)[i].pain, fast, 1e-9 * fast);
      EXPECT_NEAR((*scores)[i].pain, slow, 0.03 * slow);
      EXPECT_GT(slow, 1);
    }
  }
};

TEST_F(PoseTrialTest, IsTheMeanOfThirtySixSimulationsOfTheReferenceSolver) {
  expect_mean_of_reference(PoseTrial(character_, idle_, options()));
}

TEST_F(PoseTrialTest, TheThesisCharacterWithLimpShouldersIsTestedAsByTheReferenceSolver) {
  TrialOptions thesis = options();
  thesis.simulation.figure = sim::FigureKind::waist_up;
  thesis.are_limp = true;
  const PoseTrial trial(character_, idle_, thesis);
  EXPECT_EQ(trial.genes().size(), 18U);
  expect_mean_of_reference(trial);
}

TEST_F(PoseTrialTest, LimpArmsHurtOtherwiseThanThoseThatIdle) {
  TrialOptions limp = options();
  limp.are_limp = true;
  const PoseTrial trial(character_, idle_, limp);
  const std::vector<Chromosome> poses = chromosomes(6);
  const auto scores = *trial.test(poses, 1, 1);
  const auto idling = *PoseTrial(character_, idle_, options()).test(poses, 1, 1);
  int differ = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    differ += std::abs(scores[i].pain - idling[i].pain) > 1e-6 * idling[i].pain ? 1 : 0;
    EXPECT_EQ(scores[i].overlap, idling[i].overlap);
  }
  EXPECT_GT(differ, 3);
}

TEST_F(PoseTrialTest, TermsOfFutureWorkAreOffUnlessAskedFor) {
  const std::vector<Chromosome> poses = chromosomes(24);
  const auto plain = *PoseTrial(character_, idle_, options()).test(poses, 1, 2);
  TrialOptions asked = options();
  asked.limit_weight_per_rads = 10;
  asked.extension_weight = 2;
  const auto with_terms = *PoseTrial(character_, idle_, asked).test(poses, 1, 2);
  int exceeded = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(plain[i].limits, 0);
    EXPECT_NEAR(plain[i].pain, with_terms[i].pain, 0.02 * plain[i].pain);
    EXPECT_GE(with_terms[i].energy, plain[i].energy);
    EXPECT_GE(with_terms[i].limits, 0);
    EXPECT_DOUBLE_EQ(with_terms[i].fitness(), with_terms[i].pain + with_terms[i].energy +
                                                  with_terms[i].overlap + with_terms[i].limits);
    exceeded += with_terms[i].limits > 0 ? 1 : 0;
  }
  EXPECT_GT(exceeded, 3);
}

// The joint-limit term is what the reference solver measures, too.
TEST_F(PoseTrialTest, LimitsAreExceededAsInTheReferenceSimulation) {
  TrialOptions asked = options();
  asked.limit_weight_per_rads = 1;
  const PoseTrial trial(character_, idle_, asked);
  double fast = 0;
  double slow = 0;
  for (const Chromosome& pose : chromosomes(6)) {
    const auto balls = trial.balls(3);
    for (const auto& result : trial.simulate(pose, JointFailure::none, balls))
      fast += result.limit_excess_rads;
    for (const auto& result : trial.simulate_by_reference(pose, JointFailure::none, balls))
      slow += result.limit_excess_rads;
  }
  EXPECT_GT(fast, 0.001);
  EXPECT_NEAR(fast, slow, 0.15 * slow);
}

TEST_F(PoseTrialTest, GivesTheSameBitsForAnyNumberOfThreadsAndCompany) {
  const PoseTrial trial(character_, idle_, options(Style::far));
  const std::vector<Chromosome> poses = chromosomes(10);
  const auto one = trial.test(poses, 1, 1);
  const auto three = trial.test(poses, 1, 3);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(std::memcmp(one->data(), three->data(), 10 * sizeof(PoseScore)), 0);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto alone = trial.test({&poses[i], 1}, 1, 1);
    EXPECT_EQ(std::memcmp(&(*alone)[0], &(*one)[i], sizeof(PoseScore)), 0);
  }
}

// The slow twin remembers nothing. A memory of three has room for few, and a pose appears twice.
TEST_F(PoseTrialTest, RememberedRehearsalsChangeNoBit) {
  for (const bool limp : {false, true}) {
    TrialOptions tried = options(Style::near);
    tried.are_limp = limp;
    const PoseTrial trial(character_, idle_, tried);
    const std::vector<Chromosome> first = chromosomes(7);
    std::vector<Chromosome> second = chromosomes(5);
    for (const std::size_t k : {6U, 0U, 3U, 3U}) second.insert(second.begin() + 2, first[k]);
    const auto expected = trial.test(second, 8, 2);
    for (const std::size_t room : {0U, 3U, 512U}) {
      RehearsedPoses remembered(room);
      ASSERT_TRUE(trial.test(first, 7, 2, nullptr, &remembered));
      EXPECT_EQ(remembered.find(first[0]) != nullptr, room > 0);
      EXPECT_EQ(remembered.find(first[6]) != nullptr, room > 6);
      remembered.keep_only(second);
      EXPECT_EQ(remembered.find(first[1]), nullptr);
      const auto before = remembered.find(first[3]);
      EXPECT_EQ(before != nullptr, room > 3);
      const auto found = trial.test(second, 8, 3, nullptr, &remembered);
      EXPECT_EQ(std::memcmp(found->data(), expected->data(), 9 * sizeof(PoseScore)), 0);
      if (before) {  // it was rehearsed once
        EXPECT_EQ(remembered.find(first[3]), before);
      }
    }
  }
}

TEST_F(PoseTrialTest, AFailedShoulderStaysAsItIdles) {
  const PoseTrial trial(character_, idle_, options());
  const motion::Pose goal = trial.pose(chromosomes(1)[0]);
  for (const JointFailure failure : kJointFailures) {
    const motion::Motion motion = trial.motion_to(goal, failure);
    const motion::Pose& last = motion.poses.back();
    const motion::Pose idle =
        sample_ping_pong(idle_, static_cast<float>(motion.poses.size() - 1) / motion.rate_hz);
    const auto differs = [&](Role role, const motion::Pose& from) {
      return last.rotation[role].angularDistance(from.rotation[role]) > 1e-3F;
    };
    const bool left_fails =
        failure == JointFailure::left_shoulder || failure == JointFailure::both_shoulders;
    const bool right_fails =
        failure == JointFailure::right_shoulder || failure == JointFailure::both_shoulders;
    EXPECT_EQ(differs(Role::left_upper_arm, idle), !left_fails);
    EXPECT_EQ(differs(Role::right_upper_arm, idle), !right_fails);
    EXPECT_EQ(differs(Role::left_upper_arm, goal), left_fails);
    for (const Role role : {Role::left_forearm, Role::right_hand, Role::head})
      EXPECT_FALSE(differs(role, goal));
  }
}

TEST_F(PoseTrialTest, APoseBeginsAfterTheDelayAndKeepsHumanPeakSpeeds) {
  const PoseTrial trial(character_, idle_, options());
  for (const Chromosome& chromosome : chromosomes(20)) {
    const motion::Pose goal = trial.pose(chromosome);
    const motion::Motion motion = trial.motion_to(goal, JointFailure::none);
    const auto frames = [&](std::size_t k) {
      return forward_kinematics(character_.skeleton, motion.poses[k]);
    };
    for (const motion::JointLimits& limits : motion::human_joint_limits()) {
      const auto speed_dps = [&](std::size_t k) {
        return 60 * motion::degrees(relative_rotation(frames(k), limits.from, limits.to)
                                        .angularDistance(relative_rotation(
                                            frames(k - 1), limits.from, limits.to)));
      };
      for (std::size_t k = 1; k < motion.poses.size(); ++k) {
        EXPECT_LT(speed_dps(k), 1.05F * database::peak_human_speed_dps(limits.name)) << limits.name;
        if (k <= 13) {  // 0.22 s at 60 Hz
          EXPECT_LT(speed_dps(k), 10) << limits.name;
        }
      }
    }
  }
}

TEST_F(PoseTrialTest, HandsStyleLetsTheBallPassTheArms) {
  const PoseTrial trial(character_, idle_, options(Style::hands));
  const sim::BodySet meets = trial.simulator().options().ball_meets;
  for (const motion::Body body : motion::kBodies) {
    const std::string_view name = motion::name_of(body);
    const bool is_arm = name.ends_with("upper_arm") || name.ends_with("forearm");
    EXPECT_EQ(sim::contains(meets, body), !is_arm) << name;
  }
}

TEST_F(PoseTrialTest, NearAndFarCountTheDistanceOfTheFirstContactWithOppositeSigns) {
  const PoseTrial near(character_, idle_, options(Style::near));
  const PoseTrial far(character_, idle_, options(Style::far));
  const PoseTrial free(character_, idle_, options());
  const std::vector<Chromosome> poses = chromosomes(6);
  const auto with_near = *near.test(poses, 1, 1);
  const auto with_far = *far.test(poses, 1, 1);
  const auto without = *free.test(poses, 1, 1);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_GT(with_near[i].distance, 0);
    EXPECT_EQ(with_near[i].distance, -with_far[i].distance);
    EXPECT_EQ(without[i].distance, 0);
    EXPECT_EQ(without[i].pain, with_near[i].pain);
    EXPECT_GT(without[i].energy, 0);
  }
}

// 5 % of the pain of standing still, and 20 times that pain per metre.
TEST_F(PoseTrialTest, ArmsInsideTheBodyOrEachOtherCostTheirDepth) {
  const PoseTrial trial(character_, idle_, options());
  const std::vector<Chromosome> poses = chromosomes(12);
  const auto scores = trial.test(poses, 1, 2).value();
  int overlapping = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double depth_m = overlap_depth_m(trial.figure(), trial.pose(poses[i]));
    const double expected = depth_m > 0 ? trial.idle_pain() * (0.05 + 20 * depth_m) : 0;
    EXPECT_NEAR(scores[i].overlap, expected, 1e-9 * expected);
    overlapping += depth_m > 0 ? 1 : 0;
  }
  EXPECT_GT(overlapping, 2);
  EXPECT_LT(overlapping, 10);
  EXPECT_EQ(overlap_depth_m(trial.figure(), trial.start()), 0);
}

TEST_F(PoseTrialTest, ReadsChromosomesByItsMapOfGenes) {
  TrialOptions turned = options();
  turned.gene_map = GeneMap::full_turn;
  const PoseTrial trial(character_, idle_, turned);
  const Chromosome chromosome = chromosomes(1)[0];
  const motion::Pose expected =
      pose_of(trial.figure(), trial.start(), pose_genes(), chromosome, GeneMap::full_turn);
  const motion::Pose other = PoseTrial(character_, idle_, options()).pose(chromosome);
  float moved = 0;
  for (const Role role : motion::kRoles) {
    EXPECT_EQ(trial.pose(chromosome).rotation[role].coeffs(), expected.rotation[role].coeffs());
    moved = std::max(moved, other.rotation[role].angularDistance(expected.rotation[role]));
  }
  EXPECT_GT(moved, 0.1F);
}

TEST_F(PoseTrialTest, RefusesThrowsThatNoPoseCanAnswer) {
  TrialOptions slow = options();
  slow.thrown.speed_mps = 3;
  EXPECT_NE(tests::error_of([&] { PoseTrial(character_, idle_, slow); }), "");
  TrialOptions soon = options();
  soon.thrown.time_to_impact_s = 0.2;
  EXPECT_NE(tests::error_of([&] { PoseTrial(character_, idle_, soon); }), "");
}

}  // namespace
}  // namespace flinch::evolve
