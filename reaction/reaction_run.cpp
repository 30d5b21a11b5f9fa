// SPDX-License-Identifier: MIT
#include "reaction/reaction_run.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "reaction/balance.h"

namespace flinch::reaction {
namespace {

using motion::Body;
using motion::Role;

// The free step is half the trainer's, as what is soft swings far and is seen; the contact step
// twice the trainer's, as a frame must end.
constexpr double kFreeStep_s = 1.0 / 120;
constexpr double kContactStep_s = 1.0 / 1000;
constexpr double kMostSteps_hz = 180;
constexpr double kMostStepsSaved = 2;
constexpr double kSliver_s = 1e-6;  // not worth a step
constexpr double kDuringBlow = 1e-4;
constexpr double kPelvisGrip = 0.7;  // share of the figure's weight that pulls it back

sim::SimulationOptions simulation_options() {
  sim::SimulationOptions options;
  options.free_step_s = kFreeStep_s;
  options.contact_step_s = kContactStep_s;
  return options;
}

sim::BodyState between(const sim::BodyState& from, const sim::BodyState& to, double share) {
  return {(1 - share) * from.position + share * to.position,
          from.orientation.slerp(share, to.orientation),
          (1 - share) * from.velocity + share * to.velocity,
          (1 - share) * from.angular_velocity + share * to.angular_velocity};
}

}  // namespace

ReactionRun::ReactionRun(const sim::FigurePlan& plan, const ReactionOptions& options,
                         const motion::Pose& before, const motion::Pose& now, double dt_s,
                         const sim::Ball* ball)
    : plan_(plan),
      struck_{options.stiffness, options.stiffness,
              kPelvisGrip * simulation_options().gravity_mps2 * plan.mass_kg},
      encounter_(plan, simulation_options(), LiveReference(plan, before, now, dt_s).at(0), ball),
      feet_(plan, encounter_.world(), encounter_.figure()),
      wanted_(plan, before, now, dt_s),
      carried_(wanted_.at(0)),
      before_(moment()),
      after_(before_),
      steps_left_(kMostStepsSaved) {}

void ReactionRun::advance(double dt_s, const motion::Pose& wanted) {
  wanted_.add(wanted, dt_s, after_.time_s);
  shown_s_ += dt_s;
  while (after_.time_s < shown_s_ - kSliver_s) step();
}

// Steps cost, so there is a budget of them: a rate, and some saved up for the first touches. Beyond
// it steps are as long as the rate allows, whatever is touched.
void ReactionRun::step() {
  const sim::ReferenceState now = wanted_.at(encounter_.time_s());
  const double step_s = encounter_.begin_step(now, kFreeStep_s, (1 - steps_left_) / kMostSteps_hz);
  steps_left_ = std::min(steps_left_ + kMostSteps_hz * step_s - 1, kMostStepsSaved);
  const sim::ReferenceState target = wanted_.at(encounter_.time_s() + step_s);
  drive(target, step_s);
  encounter_.end_step(now, target, step_s);
  before_ = after_;
  after_ = moment();
  for (const sim::BodyState& body : after_.body) {
    if (!body.position.allFinite() || !body.orientation.coeffs().allFinite()) {
      throw Error("reaction", "the simulated figure is nowhere");
    }
  }
}

// A blow lasts no time: what holds the figure to the ground has none to answer it, while gains set
// for the velocity before it would.
void ReactionRun::drive(const sim::ReferenceState& target, double step_s) {
  const double to_ground = encounter_.is_blow() ? kDuringBlow : 1;
  sim::Drive drive = std::isfinite(encounter_.first_contact_s()) ? struck_ : sim::Drive{};
  drive.pelvis *= to_ground;
  sim::Figure& figure = encounter_.figure();
  if (!figure.is_fallen()) {
    figure.carry(carried_, target, step_s);
    feet_.hold(target, step_s, to_ground);
  }
  carried_ = target;
  figure.drive(target, step_s, drive);
}

void ReactionRun::advance_ball(double dt_s) {
  shown_s_ += dt_s;
  while (after_.time_s < shown_s_ - kSliver_s) step_ball();
}

void ReactionRun::step_ball() {
  encounter_.step_ball_alone();
  before_ = after_;
  after_ = moment();
}

ReactionRun::Moment ReactionRun::moment() const {
  Moment moment;
  moment.time_s = encounter_.time_s();
  for (Body body : motion::kBodies) {
    moment.body[body] = sim::state_of(encounter_.figure().body(body));
  }
  if (encounter_.ball()) moment.ball = sim::state_of(encounter_.ball()->body());
  return moment;
}

double ReactionRun::share_of_last_step() const {
  const double length_s = after_.time_s - before_.time_s;
  return length_s > 0 ? std::clamp((shown_s_ - before_.time_s) / length_s, 0.0, 1.0) : 1;
}

motion::Pose ReactionRun::pose(const motion::Pose& motion) const {
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
      pelvis.orientation * plan_.model[Body::pelvis].centre_of_mass.cast<double>();
  frames.position[Role::pelvis] = joint.cast<float>();
  return pose_from_frames(frames);
}

sim::Ball ReactionRun::ball(const sim::Ball& given) const {
  sim::Ball ball = given;
  if (!encounter_.ball()) return ball;
  const double share = share_of_last_step();
  const sim::BodyState state = between(before_.ball, after_.ball, share);
  ball.position = state.position;
  ball.velocity = after_.ball.velocity;
  return ball;
}

bool ReactionRun::is_beyond_recovery() const {
  const sim::ReferenceState wanted = wanted_.at(after_.time_s);
  const double out_m = out_of_balance_m(plan_, after_.body);
  return is_beyond_a_step(plan_, out_m - out_of_balance_m(plan_, wanted.body));
}

void ReactionRun::let_fall() {
  encounter_.figure().let_fall();
  feet_.let_go();
}

}  // namespace flinch::reaction
