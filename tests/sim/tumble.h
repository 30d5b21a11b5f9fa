// SPDX-License-Identifier: MIT
#pragma once

#include "sim/tree/tree_scene.h"

// A figure that tumbles through the air, for the test and the study of its angular momentum.
namespace flinch::scenes {

/// Angular momentum of all bodies about their common centre of mass, kg m^2/s, world.
inline Eigen::Vector3d angular_momentum(const sim::FigureModel& figure_model,
                                        const motion::PerBody<sim::BodyState>& figure) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  const auto mass_of = [&](motion::Body body) {
    return static_cast<double>(figure_model.model[body].mass_kg);
  };
  for (motion::Body body : motion::kBodies) {
    const sim::BodyState state = figure[body];
    centre += mass_of(body) / figure_model.mass_kg * state.position;
    momentum += mass_of(body) * state.velocity;
  }
  Eigen::Vector3d angular = -centre.cross(momentum);
  for (motion::Body body : motion::kBodies) {
    const sim::BodyState state = figure[body];
    const Eigen::Quaterniond& turn = state.orientation;
    const Eigen::Vector3d local = turn.conjugate() * state.angular_velocity;
    angular += mass_of(body) * state.position.cross(state.velocity) +
               turn * Eigen::Vector3d(figure_model.inertia[body] * local);
  }
  return angular;
}

/// A falling figure with the joints of a reaction. It starts in a pose, high above the ground, as
/// if it were rigid and turned with an angular velocity.
class Tumble {
 public:
  /// `figure_model` must outlive this.
  Tumble(const sim::FigureModel& figure_model, const motion::Pose& pose,
         const Eigen::Vector3d& angular_velocity)
      : figure_model_(figure_model),
        held_(sim::state_at_rest(figure_model.skeleton, figure_model.model, pose)),
        scene_(figure_model, turning(held_, angular_velocity), nullptr, features::kGravity_mps2) {
    drive_.strength = {kStiffness, kStiffness};
    drive_.is_falling = true;
  }

  void run(double duration_s, double step_s) {
    const auto steps = std::lround(duration_s / step_s);
    for (long i = 0; i < steps; ++i) {
      scene_.clear_contacts();
      scene_.step(held_, step_s, drive_);
    }
  }
  Eigen::Vector3d angular_momentum() const {
    return scenes::angular_momentum(figure_model_, scene_.bodies());
  }

 private:
  static constexpr double kStiffness = 1.0 / 16;  // default of reaction::ReactionOptions

  static sim::ReferenceState turning(sim::ReferenceState state, const Eigen::Vector3d& velocity) {
    const Eigen::Vector3d pelvis = state.body[motion::Body::pelvis].position;
    for (sim::BodyState& body : state.body) {
      body.velocity = velocity.cross(body.position - pelvis);
      body.angular_velocity = velocity;
      body.position.z() += 100;
    }
    return state;
  }

  const sim::FigureModel& figure_model_;
  sim::ReferenceState held_;
  sim::Drive drive_;
  sim::TreeScene scene_;
};

}  // namespace flinch::scenes
