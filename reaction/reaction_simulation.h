// SPDX-License-Identifier: MIT
#pragma once

#include "reaction/live_reference.h"
#include "reaction/reaction.h"
#include "sim/encounter/encounter.h"

namespace flinch::reaction {

/// What sets a figure in motion when a reaction begins, beside its own motion.
struct SuddenPush {
  motion::Role place = motion::Role::chest;            ///< the pushed joint
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< that it gets, world, m/s
};

/// The simulated part of one reaction.
///
/// Its steps do not depend on the frames. The simulation runs ahead of the displayed time by less
/// than one step, towards the extrapolated motion, and the displayed pose is interpolated between
/// the last two states.
class ReactionSimulation {
 public:
  /// `figure_model` must outlive this.
  ReactionSimulation(const sim::FigureModel& figure_model, const ReactionOptions& options,
                     const motion::Pose& before, const motion::Pose& now, double dt_s,
                     const features::Ball* ball, const std::optional<SuddenPush>& push = {});

  /// Simulates for `dt_s` more, at the end of which the motion is at `wanted`. Throws Error if the
  /// figure's state is no longer finite.
  void advance(double dt_s, const motion::Pose& wanted);
  /// Simulates only the ball.
  void advance_ball(double dt_s);

  /// Returns the simulated figure at the displayed time; clavicles and toes come from `motion`.
  motion::Pose pose(const motion::Pose& motion) const;
  features::Ball ball(const features::Ball& initial_ball) const;
  /// Momentum that the ball has passed to the figure so far, world, N·s.
  const Eigen::Vector3d& ball_momentum() const { return ball_momentum_; }
  const sim::Encounter<sim::TreeScene>& encounter() const { return encounter_; }
  /// When the figure was first struck, s; 0 if it was pushed, infinite if nothing has hit it.
  double contact_s() const { return is_pushed_ ? 0 : encounter_.first_contact_s(); }

  /// Whether the blow has put the figure so far out of balance that no step can save it, and
  /// farther than the motion itself.
  bool is_beyond_recovery() const;
  /// Releases the pelvis and the feet for good.
  void start_falling() { is_falling_ = true; }

 private:
  struct Snapshot {
    double time_s = 0;
    motion::PerBody<sim::BodyState> body;
    sim::BodyState ball;
  };
  void step();
  sim::Drive drive() const;
  void step_ball();
  Snapshot snapshot() const;
  double share_of_last_step() const;

  const sim::FigureModel& figure_model_;
  bool is_pushed_;
  sim::MotorStrength struck_strength_;  // from the first contact on; until then the figure is as
                                        // stiff as the trainer's
  sim::Encounter<sim::TreeScene> encounter_;
  LiveReference wanted_;
  sim::ReferenceState feedforward_;  // reference state to which the steps so far have led
  bool is_falling_ = false;
  Snapshot before_;  // at the start and the end of the last step
  Snapshot after_;
  double shown_s_ = 0;
  double step_budget_ = 0;  // see step()
  Eigen::Vector3d ball_momentum_ = Eigen::Vector3d::Zero();
};

}  // namespace flinch::reaction
