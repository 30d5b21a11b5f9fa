// SPDX-License-Identifier: MIT
#include "sim/ode/ball_flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "features/ball_clearance.h"

namespace flinch::sim {
namespace {

using motion::Body;

// High enough that scenes about something else do not reach the ground.
constexpr double kAboveGround_m = 20;

features::Ball with_gravity(features::Ball ball, double gravity_mps2) {
  ball.gravity_mps2 = gravity_mps2;
  return ball;
}

/// A ball and one free sphere, met by the rules that a figure is met by.
class FreeSphere {
 public:
  FreeSphere(const features::Ball& ball, const BodyState& state, double radius, double mass_kg,
             const SimulationOptions& options)
      : options_(options),
        contacts_(world_.id()),
        ball_(world_.id(), with_gravity(ball, options.gravity_mps2)),
        body_(dBodyCreate(world_.id())),
        radius_(radius) {
    dMass mass;
    dMassSetSphereTotal(&mass, mass_kg, radius);
    dBodySetMass(body_, &mass);
    dBodySetGravityMode(body_, 0);
    BodyState lifted = state;
    lifted.position.z() += kAboveGround_m;
    set_state(body_, lifted);
  }

  void run(double duration_s) {
    for (double time_s = 0; time_s < duration_s;) {
      const MovingShape shape = outline();
      contacts_.clear();
      const NextStep ahead = next_step(ball_.flight(), {&shape, 1}, options_);
      const motion::Clearance near = clearance(ball_.flight(), shape);
      if (hits(ball_.flight(), shape, near)) {
        contacts_.add_hit(ball_.body(), body_, Body::head, near, ball_.flight().bounce);
      }
      if (ahead.on_ground) ball_.add_ground_contact(contacts_, Eigen::Quaterniond::Identity());
      const double step_s = std::min(ahead.step_s, duration_s - time_s);
      ball_.step(world_, step_s);
      for (const ContactImpulse& hit : contacts_.impulses(step_s)) impulse_ += hit.impulse_ns;
      time_s += step_s;
    }
  }

  double impulse() const { return impulse_; }
  features::Ball ball() const { return ball_.flight(); }
  Eigen::Vector3d sphere_velocity() const { return velocity_of(body_); }

 private:
  MovingShape outline() const {
    MovingShape shape;
    shape.radius = radius_;
    shape.centre = position_of(body_);
    shape.velocity = velocity_of(body_);
    shape.angular_velocity = angular_velocity_of(body_);
    return shape;
  }

  SimulationOptions options_;
  OdeWorld world_;
  Contacts contacts_;
  BallFlight ball_;
  dBodyID body_;
  double radius_;
  double impulse_ = 0;
};

SimulationOptions weightless() {
  SimulationOptions options;
  options.gravity_mps2 = 0;
  return options;
}

features::Ball ball_at(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity) {
  features::Ball ball;
  ball.position = position + kAboveGround_m * Eigen::Vector3d::UnitZ();
  ball.velocity = velocity;
  return ball;
}

// J = (1 + e) v m1 m2 / (m1 + m2), for the one-dimensional collision of two free masses.
double head_on_impulse(double restitution, double speed_mps, double first_kg, double second_kg) {
  return (1 + restitution) * speed_mps * first_kg * second_kg / (first_kg + second_kg);
}

TEST(BallFlight, FollowsTheParabolaWhateverTheSteps) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> step(1e-6, 0.02);
  const features::Ball thrown = ball_at({1, 2, 30}, {-4, 3, 8});
  OdeWorld world;
  BallFlight ball(world.id(), thrown);
  double time_s = 0;
  for (int i = 0; i < 200; ++i) {
    const double step_s = step(generator);
    ball.step(world, step_s);
    time_s += step_s;
    const Eigen::Vector3d expected = thrown.position + time_s * thrown.velocity -
                                     0.5 * 9.81 * time_s * time_s * Eigen::Vector3d::UnitZ();
    ASSERT_LT((ball.flight().position - expected).norm(), 1e-9);
    ASSERT_NEAR(ball.flight().velocity.z(), 8 - 9.81 * time_s, 1e-9);
  }
}

TEST(BallFlight, ImpulseOnAFreeSphereMatchesTheClosedForm) {
  for (double mass_kg : {0.3, 1.0, 4.4, 30.0}) {
    for (double speed_mps : {5.0, 17.0, 30.0}) {
      const features::Ball ball = ball_at({3, 0, 0}, {-speed_mps, 0, 0});
      FreeSphere scene(ball, {}, 0.1, mass_kg, weightless());
      scene.run(1);
      const double expected = head_on_impulse(0.7, speed_mps, ball.mass_kg, mass_kg);
      EXPECT_NEAR(scene.impulse(), expected, 0.02 * expected) << mass_kg << " kg, " << speed_mps;
      EXPECT_NEAR(scene.sphere_velocity().x(), -expected / mass_kg, 0.02 * expected / mass_kg);
    }
  }
}

// Figures from biomechanics: a 4.4 kg head hit by a 0.27 kg volleyball at 22.8 to 29.7 m/s.
TEST(BallFlight, ImpulseOfAVolleyballOnAFreeHeadMatchesTheClosedForm) {
  for (const auto& [speed_mps, expected] : {std::pair{22.8, 9.86}, {29.7, 12.84}}) {
    FreeSphere scene(ball_at({3, 0, 0}, {-speed_mps, 0, 0}), {}, 0.1, 4.4, weightless());
    scene.run(0.5);
    EXPECT_NEAR(scene.impulse(), expected, 0.02 * expected);
  }
}

// What does not bounce stays at the sphere: J = v m1 m2 / (m1 + m2). It stops where its stroke
// ends.
TEST(BallFlight, ImpulseOfAFistMatchesTheClosedFormAndEndsWithItsStroke) {
  features::Ball fist = ball_at({3, 0, 0}, {-8, 0, 0});
  fist.radius = 0.05;
  fist.mass_kg = 2.9;
  fist.bounce = {0, 0};
  const double touches_s = (3 - 0.1 - fist.radius) / 8;
  fist.window = {0.1, touches_s + 0.05};
  FreeSphere scene(fist, {}, 0.1, 4.4, weightless());
  scene.run(1);
  const double expected = head_on_impulse(0, 8, 2.9, 4.4);
  EXPECT_NEAR(scene.impulse(), expected, 0.02 * expected);
  EXPECT_EQ(scene.ball().velocity, Eigen::Vector3d::Zero());
  for (const features::TouchWindow elsewhere :
       {features::TouchWindow{0.1, touches_s - 0.01}, {touches_s + 0.1, 1}}) {
    fist.window = elsewhere;
    FreeSphere missed(fist, {}, 0.1, 4.4, weightless());
    missed.run(1);
    EXPECT_EQ(missed.impulse(), 0);
  }
}

/// A rod that lies along Y when it is at `x_m`, and meets a sphere at `strikes_m` of its axis
/// there.
struct RodScene {
  features::Threat threat;
  double strikes_m = 0;
  double speed_mps = 0;  ///< of that point

  static RodScene of(double turn, float grip_mass_kg) {
    RodScene scene;
    features::Rod rod;
    rod.to_butt_m = 0.2F;
    rod.to_tip_m = 0.8F;
    scene.threat.radius = 0.03F;
    scene.threat.mass_kg = 0.9F;
    scene.threat.falls = false;
    scene.threat.bounce = {0.2, 0};
    const bool is_swung = grip_mass_kg > 0;
    if (is_swung) {
      rod.to_mass_m = 0.45F;
      rod.grip_mass_kg = grip_mass_kg;
      scene.threat.stroke = features::Stroke{0, 1};
    }
    constexpr float kTime_s = 0.1F;
    const auto angle = static_cast<float>(turn) * kTime_s;
    rod.axis = {std::sin(angle), std::cos(angle), 0};  // turns to Y, counter-clockwise
    rod.angular_velocity = {0, 0, static_cast<float>(turn)};
    scene.threat.rod = rod;
    scene.threat.velocity = {-6, 0, 0};
    scene.threat.position = {6 * kTime_s, 0, static_cast<float>(kAboveGround_m)};
    scene.strikes_m = 0.6;
    scene.speed_mps = 6 + turn * scene.strikes_m;
    return scene;
  }

  /// Returns the impulse on a sphere of that mass, which the rod meets when it lies along Y.
  double impulse_on(double sphere_kg) const {
    BodyState sphere;
    sphere.position = {-0.1 - 0.03, strikes_m, 0};
    FreeSphere scene(features::ball_of(threat), sphere, 0.1, sphere_kg, weightless());
    scene.run(0.2);
    return scene.impulse();
  }
};

// J = (1 + e) v / (1/M + 1/m + r^2 / I), with I = m L^2 / 12 of the whole length and r from the
// rod's middle.
TEST(BallFlight, ImpulseOfAThrownRodHasItsEffectiveMass) {
  for (const double turn : {0.0, 5.0, -4.0}) {
    RodScene scene = RodScene::of(turn, 0);
    scene.threat.rod->to_butt_m = 0.5F;
    scene.threat.rod->to_tip_m = 0.5F;
    scene.strikes_m = 0.4;
    const double speed = 6 + turn * 0.4;
    const double inertia = 0.9 * 1.06 * 1.06 / 12;
    for (const double sphere_kg : {0.5, 4.4, 1e6}) {
      const double expected = 1.2 * speed / (1 / sphere_kg + 1 / 0.9 + 0.4 * 0.4 / inertia);
      EXPECT_NEAR(scene.impulse_on(sphere_kg), expected, 0.005 * expected)
          << turn << ' ' << sphere_kg;
    }
  }
}

// A rod that is held as by a rock turns about its grip: J = (1 + e) v / (1/M + s^2 / I), with
// I = m L^2 / 12 + m x^2 about the grip and s from there. One held by hands of mass h is hit as a
// rod and a mass point that are one body, whose inertia follows from the parallel axes.
TEST(BallFlight, ImpulseOfASwungRodHasTheEffectiveMassOfItsGrip) {
  const double own = 0.9 * 1.06 * 1.06 / 12;
  for (const double turn : {3.0, 20.0}) {
    const RodScene rock = RodScene::of(turn, 1e5F);
    const double about_grip = own + 0.9 * 0.45 * 0.45;
    const double expected = 1.2 * rock.speed_mps / (1 / 4.4 + 0.6 * 0.6 / about_grip);
    EXPECT_NEAR(rock.impulse_on(4.4), expected, 0.005 * expected) << turn;
    const RodScene hands = RodScene::of(turn, 2);
    const double middle = 0.9 * 0.45 / 2.9;
    const double inertia = own + 0.9 * (0.45 - middle) * (0.45 - middle) + 2 * middle * middle;
    const double mobility = 1 / 4.4 + 1 / 2.9 + (0.6 - middle) * (0.6 - middle) / inertia;
    EXPECT_NEAR(hands.impulse_on(4.4), 1.2 * hands.speed_mps / mobility, 0.005 * expected) << turn;
  }
}

// ODE's own ball joint to a body that is driven on, in place of the formula for a common body: the
// grip of a rod that is held as by a rock.
TEST(BallFlight, ASwungRodIsHitAsOneThatOdeHoldsByAJoint) {
  const RodScene scene = RodScene::of(12, 1e5F);
  OdeWorld world;
  dBodyID rod = dBodyCreate(world.id());
  dBodyID hand = dBodyCreate(world.id());
  const double own = 0.9 * 1.06 * 1.06 / 12;
  dMass mass;
  dMassSetParameters(&mass, 0.9, 0, 0, 0, own, own, own, 0, 0, 0);
  dBodySetMass(rod, &mass);
  dBodySetKinematic(hand);
  BodyState state;  // when it lies along Y
  state.position = {0, 0.45, 20};
  state.velocity = {-6 - 12 * 0.45, 0, 0};
  state.angular_velocity = {0, 0, 12};
  set_state(rod, state);
  dBodySetPosition(hand, 0, 0, 20);
  dBodySetLinearVel(hand, -6, 0, 0);
  dJointID grip = dJointCreateBall(world.id(), nullptr);
  dJointAttach(grip, rod, hand);
  dJointSetBallAnchor(grip, 0, 0, 20);
  dBodyID sphere = dBodyCreate(world.id());
  dMassSetSphereTotal(&mass, 4.4, 0.1);
  dBodySetMass(sphere, &mass);
  dBodySetPosition(sphere, -0.13, 0.6, 20);
  for (dBodyID body : {rod, sphere}) dBodySetGravityMode(body, 0);
  Contacts contacts(world.id());
  contacts.add_hit(rod, sphere, Body::head,
                   {0, Eigen::Vector3d(-0.03, 0.6, 20), Eigen::Vector3d::UnitX()}, {0.2, 0});
  world.step(1e-4);
  const double held = contacts.impulses(1e-4)[0].impulse_ns;
  EXPECT_NEAR(scene.impulse_on(4.4), held, 0.01 * held);
}

TEST(BallFlight, ImpulseOnAMovingSphereFollowsFromTheRelativeVelocity) {
  BodyState state;
  state.velocity = {6, 0, 0};
  FreeSphere scene(ball_at({3, 0, 0}, {-14, 0, 0}), state, 0.1, 2, weightless());
  scene.run(1);
  const double expected = head_on_impulse(0.7, 20, 0.27, 2);
  EXPECT_NEAR(scene.impulse(), expected, 0.02 * expected);
}

TEST(BallFlight, ConservesTheMomentumOfBallAndSphere) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> offset(-0.15, 0.15);
  int hits = 0;
  for (int i = 0; i < 50; ++i) {
    const features::Ball ball = ball_at({2, offset(generator), offset(generator)}, {-20, 0, 0});
    FreeSphere scene(ball, {}, 0.1, 1.5, weightless());
    scene.run(0.4);
    const Eigen::Vector3d momentum =
        ball.mass_kg * scene.ball().velocity + 1.5 * scene.sphere_velocity();
    EXPECT_LT((momentum - ball.mass_kg * ball.velocity).norm(), 1e-9);
    // With friction, the impulse never exceeds what it takes to stop the ball and throw it back.
    EXPECT_LE(scene.impulse(), 1.01 * head_on_impulse(0.7, 20, 0.27, 1.5));
    if (scene.impulse() > 0) ++hits;
  }
  EXPECT_GT(hits, 25);
}

// If the hit is off-centre by s, the normal is at angle a with sin a = s / (r1 + r2). With friction
// inside its cone: J = J_n sqrt(1 + mu^2) if the ball slides throughout.
TEST(BallFlight, GlancingHitObeysCoulombFriction) {
  const double angle = 1.2;
  const double offset = 0.205 * std::sin(angle);
  FreeSphere scene(ball_at({2, offset, 0}, {-20, 0, 0}), {}, 0.1, 4.4, weightless());
  scene.run(0.5);
  const double normal = head_on_impulse(0.7, 20 * std::cos(angle), 0.27, 4.4);
  const double expected = normal * std::sqrt(1 + 0.5 * 0.5);
  EXPECT_NEAR(scene.impulse(), expected, 0.03 * expected);
}

TEST(BallFlight, NearMissGivesNoImpulse) {
  FreeSphere scene(ball_at({2, 0.21, 0}, {-20, 0, 0}), {}, 0.1, 1, weightless());
  scene.run(0.5);
  EXPECT_EQ(scene.impulse(), 0);
  EXPECT_EQ(scene.sphere_velocity().norm(), 0);
}

TEST(BallFlight, DoesNotTunnelThroughThinObjects) {
  for (double radius : {0.005, 0.02}) {
    const features::Ball ball = ball_at({3.017, 0, 0}, {-30, 0, 0});
    FreeSphere scene(ball, {}, radius, 1, weightless());
    scene.run(0.5);
    const double expected = head_on_impulse(0.7, 30, 0.27, 1);
    EXPECT_NEAR(scene.impulse(), expected, 0.02 * expected) << radius;
  }
}

// After a fall of 1 m the ball rises to e^2 = 0.49 m.
TEST(BallFlight, BouncesOffTheGround) {
  BodyState far;
  far.position = {50, 0, 1};
  FreeSphere scene(ball_at({0, 0, 1.105 - kAboveGround_m}, Eigen::Vector3d::Zero()), far, 0.1, 1,
                   {});
  const double fall_s = std::sqrt(2 / 9.81);
  scene.run(fall_s * 1.7);  // until the top of the first bounce
  EXPECT_NEAR(scene.ball().position.z(), 0.105 + 0.49, 0.005);
  EXPECT_NEAR(scene.ball().velocity.z(), 0, 0.05);
  EXPECT_EQ(scene.impulse(), 0);
  scene.run(20);
  EXPECT_NEAR(scene.ball().position.z(), 0.105, 0.002);  // at rest on the ground
}

TEST(BallFlight, ResultsDoNotDependOnTheSteps) {
  const features::Ball ball = ball_at({3, 0.05, 0.1}, {-25, 0, 1});
  const SimulationOptions coarse;
  SimulationOptions fine = coarse;
  fine.free_step_s /= 7;
  fine.contact_step_s /= 7;
  FreeSphere first(ball, {}, 0.1, 4.4, coarse);
  FreeSphere second(ball, {}, 0.1, 4.4, fine);
  first.run(0.5);
  second.run(0.5);
  EXPECT_NEAR(first.impulse(), second.impulse(), 0.005 * second.impulse());
}

}  // namespace
}  // namespace flinch::sim
