// SPDX-License-Identifier: MIT
// Nothing depends on where a scene faces in the world.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/ode/ode_encounter.h"
#include "tests/sim/random_hits.h"

namespace flinch::sim {
namespace {

using motion::Body;

constexpr double kStep_s = 1.0 / 2000;
constexpr double kRestitution = 0.7;
constexpr double kFriction = 0.5;

Eigen::Quaterniond facing(double degrees) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(motion::radians(degrees), Eigen::Vector3d::UnitZ()));
}

features::Ball turned(features::Ball ball, const Eigen::Quaterniond& turn) {
  ball.position = turn * ball.position;
  ball.velocity = turn * ball.velocity;
  return ball;
}

ReferenceState turned(ReferenceState state, const Eigen::Quaterniond& turn) {
  for (BodyState& body : state.body) {
    body = {turn * body.position, turn * body.orientation, turn * body.velocity,
            turn * body.angular_velocity};
  }
  return state;
}

template <class Scene>
class TurnedScene : public testing::Test {
 protected:
  motion::Physique character_ = motion::default_character();
  FigureModel figure_model_{character_};
  ReferenceState standing_ = state_at_rest(figure_model_.skeleton, figure_model_.model,
                                           scenes::standing(figure_model_.skeleton));
  SimulationOptions options_;

  /// Velocity with which a ball that touches the ground leaves it, the figure being elsewhere.
  Eigen::Vector3d bounced(const Eigen::Vector3d& velocity,
                          const features::Bounce& bounce = {}) const {
    features::Ball ball;
    ball.bounce = bounce;
    ball.position = {5, 0, ball.radius};
    ball.velocity = velocity;
    ball.gravity_mps2 = 0;
    Scene scene(figure_model_, standing_, &ball, features::kGravity_mps2);
    scene.add_bounce();
    scene.step(standing_, kStep_s);
    return scene.flight()->velocity;
  }

  /// Impulses of a second in which the scene faces in a direction.
  motion::PerBody<double> impulses(const motion::Motion& motion, const features::Ball& ball,
                                   const Eigen::Quaterniond& turn) const {
    const Reference reference(figure_model_.skeleton, figure_model_.model, motion);
    const auto at = [&](double time_s) { return turned(reference.at(time_s), turn); };
    const features::Ball thrown = turned(ball, turn);
    Encounter<Scene> encounter(figure_model_, options_, 0, figure_model_, at(0), &thrown,
                               options_.gravity_mps2);
    while (encounter.time_s() < 1) {
      const ReferenceState now = at(encounter.time_s());
      const double step_s = encounter.begin_step(now, 1 - encounter.time_s());
      const ReferenceState target = at(encounter.time_s() + step_s);
      encounter.end_step(now, target, step_s);
    }
    return encounter.impulse();
  }
};

using Scenes = testing::Types<OdeScene, TreeScene>;
TYPED_TEST_SUITE(TurnedScene, Scenes);

// Two bounces in closed form, of a shell of I = 2/3 m r^2. With J = (1 + e) m w:
// - it slides throughout: the speed over the ground falls by f J / m;
// - it is rolling when it leaves: 3/5 of the speed is left.
TYPED_TEST(TurnedScene, ABallThrownAtTheGroundLeavesAlikeInEveryDirection) {
  for (const auto& [along, down, left] :
       {std::tuple{20.0, 5.0, 20 - kFriction * (1 + kRestitution) * 5}, {5.0, 10.0, 3.0}}) {
    for (double degrees = 0; degrees < 360; degrees += 22.5) {
      const Eigen::Vector3d direction = facing(degrees) * Eigen::Vector3d::UnitX();
      const Eigen::Vector3d leaving =
          this->bounced(along * direction - down * Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d expected =
          left * direction + kRestitution * down * Eigen::Vector3d::UnitZ();
      EXPECT_LT((leaving - expected).norm(), 1e-5) << degrees << " degrees";
    }
  }
}

TYPED_TEST(TurnedScene, ABallLeavesTheGroundWithItsOwnRestitutionAndFriction) {
  for (const features::Bounce bounce : {features::Bounce{0.2, 0.1}, {0.95, 0.3}, {0.5, 0}}) {
    const double along = 20 - bounce.friction * (1 + bounce.restitution) * 5;
    const Eigen::Vector3d leaving = this->bounced({20, 0, -5}, bounce);
    EXPECT_LT((leaving - Eigen::Vector3d(along, 0, bounce.restitution * 5)).norm(), 1e-5);
  }
}

// A ball that does not slide on the ground while a part strikes it from the side.
TYPED_TEST(TurnedScene, ABallHitWhileItStandsOnTheGroundLeavesAlike) {
  const auto leaving = [this](double degrees) {
    const Eigen::Quaterniond turn = facing(degrees);
    ReferenceState start = turned(this->standing_, turn);
    start.body[Body::left_foot].velocity = turn * Eigen::Vector3d(6, 1, -0.5);
    features::Ball ball;
    ball.position = turn * Eigen::Vector3d(0.4, 0.1, ball.radius);
    ball.velocity = {0, 0, -1};
    TypeParam scene(this->figure_model_, start, &ball, features::kGravity_mps2);
    const Eigen::Vector3d normal = turn * Eigen::Vector3d(0.9, -0.3, 0.2).normalized();
    scene.add_hit(Body::left_foot, {0, ball.position - ball.radius * normal, normal});
    scene.add_bounce();
    scene.step(turned(this->standing_, turn), kStep_s);
    return Eigen::Vector3d(turn.conjugate() * scene.flight()->velocity);
  };
  const Eigen::Vector3d expected = leaving(0);
  EXPECT_GT(expected.head<2>().norm(), 1);
  for (const double degrees : {22.5, 45.0, 100.0, 222.5}) {
    EXPECT_LT((leaving(degrees) - expected).norm(), 1e-9) << degrees << " degrees";
  }
}

TYPED_TEST(TurnedScene, ImpulsesAreThoseOfTheSceneThatIsNotTurned) {
  const auto motions = scenes::motions_by_rule(this->character_.skeleton);
  double most = 0;
  for (const scenes::Hit& hit : scenes::random_hits(this->character_, motions, 48, 3)) {
    const motion::Motion& motion = motions[hit.motion].motion;
    const auto straight = this->impulses(motion, hit.ball, facing(0));
    const auto other = this->impulses(motion, hit.ball, facing(22.5));
    for (Body body : motion::kBodies) {
      EXPECT_NEAR(straight[body], other[body], 1e-6)
          << motions[hit.motion].name << ", " << name_of(body);
      most = std::max(most, straight[body]);
    }
  }
  EXPECT_GT(most, 5);
}

}  // namespace
}  // namespace flinch::sim
