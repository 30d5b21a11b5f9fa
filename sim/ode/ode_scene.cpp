// SPDX-License-Identifier: MIT
#include "sim/ode/ode_scene.h"

namespace flinch::sim {

OdeScene::OdeScene(const FigureModel& figure_model, const ReferenceState& start,
                   const features::Ball* ball, double gravity_mps2)
    : contacts_(world_.id()), figure_(figure_model, world_.id(), start) {
  dWorldSetGravity(world_.id(), 0, 0, -gravity_mps2);
  if (ball) ball_.emplace(world_.id(), *ball);
}

std::optional<features::Ball> OdeScene::flight() const {
  return ball_ ? std::optional(ball_->flight()) : std::nullopt;
}

void OdeScene::place(const motion::PerBody<BodyState>& figure, const features::Ball& ball) {
  figure_.place(figure);
  if (ball_) ball_->place(ball);
}

void OdeScene::add_hit(motion::Body body, const motion::Clearance& at) {
  contacts_.add_hit(ball_->body(), figure_.body(body), body, at, ball_->flight().bounce);
}

void OdeScene::add_bounce() {
  ball_->add_ground_contact(contacts_, orientation_of(figure_.body(motion::Body::pelvis)));
}

void OdeScene::add_body_contact(motion::Body first, motion::Body second,
                                const motion::Clearance& at, double free_closing_mps,
                                bool measured) {
  contacts_.add_body_contact(figure_.body(first), first, figure_.body(second), second, at,
                             free_closing_mps, measured);
}

void OdeScene::add_supports(const ReferenceState& target, double step_s, const Drive& drive) {
  figure_.add_supports(contacts_, target, step_s, drive);
}

void OdeScene::step(const ReferenceState& target, double step_s, const Drive& drive) {
  figure_.drive(target, step_s, drive);
  if (ball_) {
    ball_->step(world_, step_s);
  } else {
    world_.step(step_s);
  }
}

void OdeScene::step_ball(double step_s) {
  if (!ball_) return;
  figure_.set_frozen(true);
  ball_->step(world_, step_s);
  figure_.set_frozen(false);
}

}  // namespace flinch::sim
