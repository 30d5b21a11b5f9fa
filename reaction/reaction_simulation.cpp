// SPDX-License-Identifier: MIT
#include "reaction/reaction_simulation.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "reaction/balance.h"

namespace flinch::reaction {
namespace {

using motion::Body;
using motion::Role;

// The free step is half of the one in training, because soft joints swing far and the swing is
// visible. The contact step is twice the one in training, because a frame has a time limit.
constexpr double kFreeStep_s = 1.0 / 120;
constexpr double kContactStep_s = 1.0 / 1000;
constexpr double kMaxStepRate_hz = 180;
constexpr double kMaxSavedSteps = 2;
constexpr double kNegligibleStep_s = 1e-6;  // remainders below this are not simulated
constexpr double kImpactStiffnessShare = 1e-4;
// Largest force that pulls the figure back, as a share of its weight.
constexpr double kPelvisForceShare = 0.7;
constexpr double kPushTaper = 1;  // of the velocities of a push over the body, 1/m^2

sim::SimulationOptions simulation_options() {
  sim::SimulationOptions options;
  options.free_step_s = kFreeStep_s;
  options.contact_step_s = kContactStep_s;
  options.contact_search = sim::ContactSearch::by_short_steps;
  return options;
}

sim::BodyState between(const sim::BodyState& from, const sim::BodyState& to, double share) {
  return {(1 - share) * from.position + share * to.position,
          from.orientation.slerp(share, to.orientation),
          (1 - share) * from.velocity + share * to.velocity,
          (1 - share) * from.angular_velocity + share * to.angular_velocity};
}

sim::ReferenceState pushed(sim::ReferenceState state, const motion::Skeleton& skeleton,
                           const motion::Pose& pose, const std::optional<SuddenPush>& push) {
  if (!push) return state;
  const Eigen::Vector3d place =
      motion::forward_kinematics(skeleton, pose).position[push->place].cast<double>();
  for (sim::BodyState& body : state.body) {
    const double share = std::exp(-kPushTaper * (body.position - place).squaredNorm());
    body.velocity += share * push->velocity;
  }
  return state;
}

}  // namespace

ReactionSimulation::ReactionSimulation(const sim::FigureModel& figure_model,
                                       const ReactionOptions& options, const motion::Pose& before,
                                       const motion::Pose& now, double dt_s,
                                       const features::Ball* ball,
                                       const std::optional<SuddenPush>& push)
    : figure_model_(figure_model),
      is_pushed_(push.has_value()),
      struck_strength_{
          options.stiffness, options.stiffness,
          kPelvisForceShare * simulation_options().gravity_mps2 * figure_model.mass_kg},
      encounter_(figure_model, simulation_options(), 0, figure_model,
                 pushed(LiveReference(figure_model, before, now, dt_s).at(0), figure_model.skeleton,
                        now, push),
                 ball, simulation_options().gravity_mps2),
      wanted_(figure_model, before, now, dt_s),
      feedforward_(wanted_.at(0)),
      before_(snapshot()),
      after_(before_),
      step_budget_(kMaxSavedSteps) {}

void ReactionSimulation::advance(double dt_s, const motion::Pose& wanted) {
  wanted_.add(wanted, dt_s, after_.time_s);
  shown_s_ += dt_s;
  while (after_.time_s < shown_s_ - kNegligibleStep_s) step();
}

// Steps cost time, so they have a budget: a rate, and a reserve for the first contacts. When the
// budget is spent, steps are as long as the rate allows, whatever is in contact.
void ReactionSimulation::step() {
  const sim::ReferenceState now = wanted_.at(encounter_.time_s());
  const double step_s =
      encounter_.begin_step(now, kFreeStep_s, (1 - step_budget_) / kMaxStepRate_hz);
  step_budget_ = std::min(step_budget_ + kMaxStepRate_hz * step_s - 1, kMaxSavedSteps);
  const sim::ReferenceState target = wanted_.at(encounter_.time_s() + step_s);
  const std::optional<features::Ball> flight = encounter_.scene().flight();
  encounter_.end_step(now, target, step_s, drive());
  feedforward_ = target;
  before_ = after_;
  after_ = snapshot();
  if (encounter_.is_ball_hit())
    ball_momentum_ += flight->mass_kg * (flight->velocity_at(step_s) - after_.ball.velocity);
  for (const sim::BodyState& body : after_.body) {
    if (!body.position.allFinite() || !body.orientation.coeffs().allFinite()) {
      throw Error("reaction", "the position of the simulated figure is not finite");
    }
  }
}

// A blow is instantaneous, so the force that holds the figure to the ground has no time to oppose
// it. Gains computed from the velocity before the blow would oppose it.
sim::Drive ReactionSimulation::drive() const {
  const double to_ground = encounter_.is_ball_hit() ? kImpactStiffnessShare : 1;
  sim::Drive drive;
  if (std::isfinite(contact_s())) drive.strength = struck_strength_;
  drive.strength.pelvis *= to_ground;
  drive.is_falling = is_falling_;
  if (!is_falling_) {
    drive.feedforward_from = &feedforward_;
    drive.foot_hold = to_ground;
  }
  return drive;
}

void ReactionSimulation::advance_ball(double dt_s) {
  shown_s_ += dt_s;
  while (after_.time_s < shown_s_ - kNegligibleStep_s) step_ball();
}

void ReactionSimulation::step_ball() {
  encounter_.step_ball_alone();
  before_ = after_;
  after_ = snapshot();
}

ReactionSimulation::Snapshot ReactionSimulation::snapshot() const {
  Snapshot snapshot;
  snapshot.time_s = encounter_.time_s();
  snapshot.body = encounter_.scene().bodies();
  snapshot.ball = encounter_.scene().ball_state();
  return snapshot;
}

double ReactionSimulation::share_of_last_step() const {
  const double length_s = after_.time_s - before_.time_s;
  return length_s > 0 ? std::clamp((shown_s_ - before_.time_s) / length_s, 0.0, 1.0) : 1;
}

motion::Pose ReactionSimulation::pose(const motion::Pose& motion) const {
  const double share = share_of_last_step();
  motion::JointFrames frames;
  for (Role role : motion::kRoles) {
    const Body body = body_of(role);
    if (role_of(body) == role) {
      frames.orientation[role] = before_.body[body]
                                     .orientation.slerp(share, after_.body[body].orientation)
                                     .cast<float>()
                                     .normalized();
    } else {
      frames.orientation[role] = frames.orientation[*parent_of(role)] * motion.rotation[role];
    }
  }
  const sim::BodyState pelvis =
      between(before_.body[Body::pelvis], after_.body[Body::pelvis], share);
  const Eigen::Vector3d joint =
      pelvis.position -
      pelvis.orientation * figure_model_.model[Body::pelvis].centre_of_mass.cast<double>();
  frames.position[Role::pelvis] = joint.cast<float>();
  return pose_from_frames(frames);
}

features::Ball ReactionSimulation::ball(const features::Ball& initial_ball) const {
  features::Ball ball = initial_ball;
  const auto flight = encounter_.scene().flight();
  if (!flight) return ball;
  if (flight->is_rod()) {
    const features::Ball rod = flight->at(shown_s_ - after_.time_s);
    return rod.at(std::max(rod.window.from_s, 0.0));  // it waits there
  }
  const double share = share_of_last_step();
  const sim::BodyState state = between(before_.ball, after_.ball, share);
  ball.position = state.position;
  ball.velocity = after_.ball.velocity;
  ball.window = flight->window;
  if (ball.window.from_s > 0)
    ball.position += ball.window.from_s * ball.velocity;  // it waits there
  return ball;
}

bool ReactionSimulation::is_beyond_recovery() const {
  const sim::ReferenceState wanted = wanted_.at(after_.time_s);
  const double out_m = out_of_balance_m(figure_model_, after_.body);
  return is_beyond_a_step(figure_model_, out_m - out_of_balance_m(figure_model_, wanted.body));
}

}  // namespace flinch::reaction
