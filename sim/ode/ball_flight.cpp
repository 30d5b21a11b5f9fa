// SPDX-License-Identifier: MIT
#include "sim/ode/ball_flight.h"

#include "sim/contact/rod_step.h"

namespace flinch::sim {
namespace {

constexpr double kRollingInertia = 1e9;  // of a rod about its axis, relative to that across it

}  // namespace

BallFlight::BallFlight(dWorldID world, const features::Ball& ball)
    : body_(dBodyCreate(world)), thrown_(ball) {
  // A rod is created along X, so that its own orientation is the turn of its axis. It does not
  // roll: nothing that acts on it turns so much inertia. ODE's gyroscopic torque would, and is off.
  const double inertia = ball.is_rod() ? ball.rod.inertia_kgm2 : moment_of_inertia(ball);
  const double along = ball.is_rod() ? kRollingInertia * inertia : inertia;
  dMass mass;
  dMassSetParameters(&mass, ball.mass_kg, 0, 0, 0, along, inertia, inertia, 0, 0, 0);
  dBodySetMass(body_, &mass);
  dBodySetGravityMode(body_, 0);
  if (ball.is_rod()) dBodySetGyroscopicMode(body_, 0);
  set(ball);
}

void BallFlight::set(const features::Ball& ball) {
  thrown_ = ball;
  BodyState state = state_of(body_);
  state.position = ball.position;
  state.velocity = ball.velocity;
  if (ball.is_rod()) {
    state.orientation = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), ball.rod.axis);
    state.angular_velocity = ball.rod.angular_velocity;
  }
  set_state(body_, state);
}

features::Ball BallFlight::flight() const {
  features::Ball ball = thrown_;
  ball.position = position_of(body_);
  ball.velocity = velocity_of(body_);
  if (ball.is_rod()) {
    const Eigen::Vector3d turn = angular_velocity_of(body_);
    ball.rod.angular_velocity = turn - turn.dot(ball.rod.axis) * ball.rod.axis;
  }
  return ball;
}

void BallFlight::place(const features::Ball& ball) {
  features::Ball placed = thrown_;
  placed.position = ball.position;
  placed.velocity = ball.velocity;
  placed.window = ball.window;
  placed.rod = ball.rod;
  set(placed);
}

void BallFlight::add_ground_contact(Contacts& contacts, const Eigen::Quaterniond& frame) const {
  contacts.add_bounce(body_, frame, thrown_.bounce);
}

void BallFlight::apply_gravity(double time_s) const {
  const Eigen::Vector3d velocity = velocity_of(body_);
  dBodySetLinearVel(body_, velocity.x(), velocity.y(),
                    velocity.z() - thrown_.gravity_mps2 * time_s);
}

/// ODE moves bodies straight on; a rod moves about its grip.
void BallFlight::move_rod(const features::Ball& before, double step_s) {
  const Twist after{velocity_of(body_), flight().rod.angular_velocity};
  set(rod_after_step(before, after, step_s, !after.linear.isApprox(before.velocity, 0)));
}

void BallFlight::step(OdeWorld& world, double step_s) {
  apply_gravity(step_s / 2);
  const features::Ball before = flight();
  world.step(step_s);
  if (before.is_rod()) move_rod(before, step_s);
  apply_gravity(step_s / 2);
  if (before.is_rod()) return;
  thrown_.window = thrown_.window.at(step_s);
  if (thrown_.window.is_over()) dBodySetLinearVel(body_, 0, 0, 0);  // the stroke ends
}

}  // namespace flinch::sim
