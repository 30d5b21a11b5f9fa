// SPDX-License-Identifier: MIT
#include "database/author/static_balance.h"

#include <gmock/gmock.h>
#include <lbfgs.h>

#include <cmath>
#include <limits>

#include "author_scene.h"
#include "motion/error.h"
#include "tests/scenes/error_of.h"

namespace flinch::database {
namespace {

using motion::JointFrames;
using motion::Pose;
using motion::radians;
using motion::Side;
using motion::Target;
using test::AuthorScene;
using testing::HasSubstr;

const RuleControls kControls{0.5F, 0.4F, 0.5F, {0.5F, 0.5F}, {0.5F, 0.5F}};

Pose rules_only(const AuthorScene& scene, const AimedThreat& threat, const RuleControls& controls) {
  return apply_rules(scene.figure, scene.start, threat_geometry(scene.figure, scene.start, threat),
                     controls,
                     {foot_pose(scene.frames, Side::left), foot_pose(scene.frames, Side::right)});
}

Eigen::Vector2f centre_of(const AuthorScene& scene, const Pose& pose) {
  return motion::centre_of_mass(scene.figure.bodies,
                                motion::forward_kinematics(scene.figure.skeleton(), pose))
      .head<2>();
}

TEST(StaticBalance, MovesTheCentreOfMassTenCentimetresTowardTheThreatWithFeetPlanted) {
  const AuthorScene scene;
  for (float azimuth : {0.0F, 40.0F, 80.0F, 130.0F, 180.0F, -60.0F}) {
    const AimedThreat threat = scene.threat(Target::head, azimuth, 0.5F);
    const BalancedPose balanced = balanced_pose(scene.figure, scene.start, threat, kControls);
    const Eigen::Vector2f moved =
        centre_of(scene, balanced.pose) - centre_of(scene, rules_only(scene, threat, kControls));
    const Eigen::Vector2f toward(std::cos(radians(azimuth)), std::sin(radians(azimuth)));
    EXPECT_NEAR(moved.dot(toward), 0.1F, 0.025F) << azimuth;
    EXPECT_LT((moved - 0.1F * toward).norm(), 0.03F) << azimuth;
    EXPECT_TRUE(balanced.feet_reach);
    EXPECT_GT(balanced.iterations, 0);
    const JointFrames frames = motion::forward_kinematics(scene.figure.skeleton(), balanced.pose);
    for (Side side : motion::kSides) {
      EXPECT_LT((foot_pose(frames, side).ankle - foot_pose(scene.frames, side).ankle).norm(),
                2e-3F);
    }
  }
}

TEST(StaticBalance, ReducesTheError) {
  const AuthorScene scene;
  for (Target target : {Target::head, Target::trunk, Target::pelvis}) {
    for (float azimuth : {0.0F, 70.0F, -110.0F}) {
      const AimedThreat threat = scene.threat(target, azimuth, 0.5F);
      const BalanceProblem problem(scene.figure, scene.start, threat, kControls, kBraceDistance);
      const Pose before = problem.pose_of({Eigen::Vector3f::Zero(), kControls});
      // all other terms are 0
      EXPECT_NEAR(problem.error_of(before).total(), kBraceDistance, 1e-4F);
      const Pose after = balanced_pose(scene.figure, scene.start, threat, kControls).pose;
      EXPECT_LT(problem.error_of(after, kSmoothing).total(),
                0.95F * problem.error_of(before, kSmoothing).total())
          << motion::name_of(target) << " from " << azimuth;
    }
  }
}

// Compares with the five-point stencil, whose error is of fourth order.
TEST(StaticBalance, GradientMatchesFiniteDifferences) {
  const AuthorScene scene;
  const BalanceProblem problem(scene.figure, scene.start, scene.threat(Target::head, 35, 0.5F),
                               kControls, kBraceDistance);
  BalanceVariables variables{{0.05F, 0.03F, -0.02F}, kControls};
  variables.controls.lean = 0.6F;
  variables.controls.turn = 0.5F;
  const std::array<float, 10> gradient = problem.gradient(variables, 0.005F);
  const std::array<float, 10> middle = to_array(variables);
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const auto error_at = [&](double offset) {
      std::array<float, 10> values = middle;
      values[i] += static_cast<float>(offset);
      return double{problem.error_of(problem.pose_of(from_array(values)), kSmoothing).total()};
    };
    constexpr double kStep = 0.004;
    const double reference =
        (error_at(-2 * kStep) - 8 * error_at(-kStep) + 8 * error_at(kStep) - error_at(2 * kStep)) /
        (12 * kStep);
    EXPECT_NEAR(gradient[i], reference, 0.03 + 0.05 * std::abs(reference)) << i;
  }
}

TEST(StaticBalance, DistinguishesTheThreeCasesOfFigure310) {
  const AuthorScene scene;
  const AimedThreat threat = scene.threat(Target::head, 0);
  EXPECT_EQ(balanced_pose(scene.figure, scene.start, threat, kControls, 0.02F).balance,
            BalanceCase::balanced);
  EXPECT_EQ(balanced_pose(scene.figure, scene.start, threat, kControls, 0.3F).balance,
            BalanceCase::braced);
  Pose falling = scene.start;
  falling.root_position.x() -= 0.3F;
  falling.root_position.z() -= 0.1F;
  falling = with_feet(scene.figure.skeleton(), falling,
                      {foot_pose(scene.frames, Side::left), foot_pose(scene.frames, Side::right)});
  EXPECT_EQ(balanced_pose(scene.figure, falling, threat, kControls, 0.02F).balance,
            BalanceCase::beyond_balance);
}

TEST(StaticBalance, PutsARaisedFootDownAndLeavesOneThatCannotReach) {
  const AuthorScene scene;
  const AimedThreat threat = scene.threat(Target::head, 0);
  motion::PerSide<motion::FootPose> feet{foot_pose(scene.frames, Side::left),
                                         foot_pose(scene.frames, Side::right)};
  feet[motion::Side::left].ankle.z() += 0.2F;
  const Pose raised = with_feet(scene.figure.skeleton(), scene.start, feet);
  const JointFrames down = motion::forward_kinematics(
      scene.figure.skeleton(), balanced_pose(scene.figure, raised, threat, kControls).pose);
  EXPECT_NEAR(foot_pose(down, Side::left).ankle.z(), foot_pose(scene.frames, Side::left).ankle.z(),
              1e-3F);

  Pose jumping = scene.start;
  jumping.root_position.z() += 0.5F;
  const BalancedPose in_the_air = balanced_pose(scene.figure, jumping, threat, kControls);
  EXPECT_TRUE(test::is_finite(in_the_air.pose));
}

TEST(StaticBalance, IsReproducibleBitForBit) {
  const AuthorScene scene;
  const AimedThreat threat = scene.threat(Target::head, 25, 1);
  const BalancedPose once = balanced_pose(scene.figure, scene.start, threat, kControls);
  const BalancedPose twice = balanced_pose(scene.figure, scene.start, threat, kControls);
  EXPECT_EQ(to_array(once.variables), to_array(twice.variables));
}

TEST(StaticBalance, RefusesNumbersThatGiveNoFiniteError) {
  const AuthorScene scene;
  const AimedThreat threat = scene.threat(Target::head, 0);
  const auto message = [&](const Pose& pose, const RuleControls& controls) {
    return tests::error_of([&] { balanced_pose(scene.figure, pose, threat, controls); });
  };
  RuleControls no_number = kControls;
  no_number.turn = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(message(scene.start, no_number), HasSubstr("not a finite number"));
  Pose far = scene.start;
  far.root_position.y() = 1e30F;  // its square overflows
  EXPECT_THAT(message(far, kControls), HasSubstr("not a finite number"));
  EXPECT_EQ(message(scene.start, kControls), "");
}

TEST(StaticBalance, RefusesCodesOfTheOptimiserThatLeaveNoBestPoint) {
  for (const int code : {LBFGS_SUCCESS, LBFGS_STOP, LBFGS_ALREADY_MINIMIZED})
    EXPECT_NO_THROW(check_optimiser_code(code));
  for (const int code :
       {LBFGSERR_MAXIMUMITERATION, LBFGSERR_MAXIMUMLINESEARCH, LBFGSERR_ROUNDING_ERROR,
        LBFGSERR_OUTOFINTERVAL, LBFGSERR_WIDTHTOOSMALL, LBFGSERR_INCREASEGRADIENT})
    EXPECT_NO_THROW(check_optimiser_code(code));
  for (const int code : {LBFGSERR_UNKNOWNERROR, LBFGSERR_OUTOFMEMORY, LBFGSERR_INVALID_N_SSE,
                         LBFGSERR_INVALID_ORTHANTWISE_END, LBFGSERR_INVALIDPARAMETERS})
    EXPECT_THROW(check_optimiser_code(code), Error) << code;
}

TEST(StaticBalance, RefusesAThreatWithoutSpeed) {
  const AuthorScene scene;
  AimedThreat still = scene.threat(Target::head, 0);
  still.threat.velocity.setZero();
  EXPECT_THROW(balanced_pose(scene.figure, scene.start, still, kControls), Error);
}

}  // namespace
}  // namespace flinch::database
