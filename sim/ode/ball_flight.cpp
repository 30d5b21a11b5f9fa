// SPDX-License-Identifier: MIT
#include "sim/ode/ball_flight.h"

namespace flinch::sim {
BallFlight::BallFlight(dWorldID world, const features::Ball& ball)
    : body_(dBodyCreate(world)), thrown_(ball) {
  const double inertia = moment_of_inertia(ball);
  dMass mass;
  dMassSetParameters(&mass, ball.mass_kg, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
  dBodySetMass(body_, &mass);
  dBodySetGravityMode(body_, 0);
  BodyState state;
  state.position = ball.position;
  state.velocity = ball.velocity;
  set_state(body_, state);
}

features::Ball BallFlight::flight() const {
  features::Ball ball = thrown_;
  ball.position = position_of(body_);
  ball.velocity = velocity_of(body_);
  return ball;
}

void BallFlight::place(const features::Ball& ball) {
  BodyState state = state_of(body_);
  state.position = ball.position;
  state.velocity = ball.velocity;
  set_state(body_, state);
  thrown_.window = ball.window;
}

void BallFlight::add_ground_contact(Contacts& contacts, const Eigen::Quaterniond& frame) const {
  contacts.add_bounce(body_, frame, thrown_.bounce);
}

void BallFlight::apply_gravity(double time_s) const {
  const Eigen::Vector3d velocity = velocity_of(body_);
  dBodySetLinearVel(body_, velocity.x(), velocity.y(),
                    velocity.z() - thrown_.gravity_mps2 * time_s);
}

void BallFlight::step(OdeWorld& world, double step_s) {
  apply_gravity(step_s / 2);
  world.step(step_s);
  apply_gravity(step_s / 2);
  thrown_.window = thrown_.window.at(step_s);
  if (thrown_.window.is_over()) dBodySetLinearVel(body_, 0, 0, 0);  // the stroke ends
}

}  // namespace flinch::sim
