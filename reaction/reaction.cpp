// SPDX-License-Identifier: MIT
#include "reaction/reaction.h"

#include <cmath>
#include <limits>
#include <optional>

#include "motion/interpolation.h"
#include "reaction/reaction_simulation.h"
#include "reaction/recovery.h"

namespace flinch::reaction {
namespace {

constexpr double kMinRodInertia_kgm2 = 1e-7;  // of a rod of 1 g and 1 cm
// Longest wait for the ball's contact.
constexpr double kMaxWaitForContact_s = 0.3;

bool is_in_range(const ReactionOptions& options) {
  const double simulation_only_s = options.schedule.simulation_only_s;
  return simulation_only_s >= 0.05 && simulation_only_s <= 0.5 && options.stiffness > 0 &&
         options.stiffness <= 1;
}

bool is_frame_time(double dt_s) {
  return dt_s > 0 && dt_s <= kMaxReactionFrame_s;
}

bool is_in_range(const features::RodShape& rod) {
  const double length = rod.to_butt_m + rod.to_tip_m;
  return std::abs(rod.axis.norm() - 1) <= 1e-6 && length <= double{features::kMaxRodLength_m} &&
         rod.inertia_kgm2 >= kMinRodInertia_kgm2 && rod.to_pivot_m >= -length &&
         rod.to_pivot_m <= length && rod.angular_velocity.norm() * length <= kMaxBallSpeed_mps;
}

bool is_in_range(const SuddenPush& push) {
  return motion::is_push_place(push.place) && push.velocity.norm() <= kMaxBallSpeed_mps;
}

bool is_in_range(const features::Ball& ball) {
  return ball.position.allFinite() && ball.velocity.norm() <= kMaxBallSpeed_mps &&
         ball.radius >= kMinBallRadius_m && ball.radius <= kMaxBallRadius_m &&
         ball.mass_kg >= kMinBallMass_kg && ball.mass_kg <= kMaxBallMass_kg &&
         ball.gravity_mps2 >= 0 && ball.gravity_mps2 <= 1000 &&
         (!ball.is_rod() || is_in_range(ball.rod));
}

}  // namespace

/// State of a reaction in progress.
struct Reaction::State {
  std::shared_ptr<const sim::FigureModel> figure_model;
  ReactionOptions options;
  std::optional<ReactionSimulation> run;
  ReactionPhase phase = ReactionPhase::none;
  motion::Pose shown;
  features::Ball initial_ball;
  double time_s = 0;  ///< since begin()
  bool has_failed = false;
  bool is_returning = false;
  motion::Pose wanted_at_return;  ///< both motions at the time at which the return began
  motion::Pose returning_at_return;

  ReactionStatus check(const motion::Pose& before, const motion::Pose& now, double dt_s) const;
  ReactionStatus begin(const motion::Pose& before, const motion::Pose& now, double dt_s,
                       const features::Ball* ball, const std::optional<SuddenPush>& push) noexcept;
  void advance(double dt_s, const motion::Pose& wanted, const motion::Pose& returning);
  void simulate(double dt_s, const motion::Pose& destination, double weight);
  double since_contact_s() const;
  motion::Pose destination(const motion::Pose& wanted, const motion::Pose& returning,
                           double weight);
};

std::shared_ptr<const sim::FigureModel> make_figure_model(
    const motion::Physique& character) noexcept {
  try {
    return std::make_shared<const sim::FigureModel>(character);
  } catch (...) {
    return nullptr;
  }
}

/// Seconds since the contact; negative before it.
double Reaction::State::since_contact_s() const {
  return time_s - std::min(run->contact_s(), kMaxWaitForContact_s);
}

motion::Pose Reaction::State::destination(const motion::Pose& wanted, const motion::Pose& returning,
                                          double weight) {
  if (weight <= 0) return wanted;
  if (weight >= 1) return returning;
  if (!is_returning) {
    is_returning = true;
    wanted_at_return = wanted;
    returning_at_return = returning;
  }
  return motion::blend_along_initial_arc(wanted, returning, static_cast<float>(weight),
                                         wanted_at_return, returning_at_return);
}

ReactionStatus Reaction::State::check(const motion::Pose& before, const motion::Pose& now,
                                      double dt_s) const {
  if (!figure_model || !is_in_range(options)) return ReactionStatus::bad_options;
  if (!is_frame_time(dt_s)) return ReactionStatus::bad_time;
  return is_sound(before) && is_sound(now) ? ReactionStatus::ok : ReactionStatus::bad_pose;
}

ReactionStatus Reaction::State::begin(const motion::Pose& before, const motion::Pose& now,
                                      double dt_s, const features::Ball* ball,
                                      const std::optional<SuddenPush>& push) noexcept try {
  run.emplace(*figure_model, options, before, now, dt_s, ball, push);
  phase = push ? ReactionPhase::struck : ReactionPhase::waiting;
  shown = now;
  initial_ball = ball ? *ball : features::Ball{};
  time_s = 0;
  has_failed = false;
  is_returning = false;
  return ReactionStatus::ok;
} catch (...) {
  has_failed = true;
  phase = ReactionPhase::over;
  return ReactionStatus::failed;
}

void Reaction::State::advance(double dt_s, const motion::Pose& wanted,
                              const motion::Pose& returning) {
  time_s += dt_s;
  const RecoveryWeights weights = weights_at(options.schedule, since_contact_s());
  const motion::Pose aim = destination(wanted, returning, weights.returning);
  if (phase == ReactionPhase::knocked_over) {
    run->advance(dt_s, aim);
    shown = run->pose(aim);
    return;
  }
  if (weights.simulated > 0) {
    simulate(dt_s, aim, weights.simulated);
    return;
  }
  run->advance_ball(dt_s);
  shown = aim;
  phase = weights.returning < 1 ? ReactionPhase::returning : ReactionPhase::over;
}

void Reaction::State::simulate(double dt_s, const motion::Pose& aim, double weight) {
  run->advance(dt_s, aim);
  const motion::Pose simulated = run->pose(aim);
  shown = weight < 1 ? motion::blend(aim, simulated, static_cast<float>(weight)) : simulated;
  if (weight < 1) {
    phase = ReactionPhase::recovering;
    return;
  }
  if (since_contact_s() < 0) return;
  phase = ReactionPhase::struck;
  if (run->is_beyond_recovery()) {
    phase = ReactionPhase::knocked_over;
    run->start_falling();
  }
}

const char* message_of(ReactionStatus status) noexcept {
  switch (status) {
    case ReactionStatus::ok:
      return "ok";
    case ReactionStatus::not_begun:
      return "the reaction has not begun: call begin first";
    case ReactionStatus::bad_options:
      return "there is no figure, or an option is out of its range";
    case ReactionStatus::bad_time:
      return "the time step must be above 0 s and at most 0.1 s";
    case ReactionStatus::bad_pose:
      return "a pose is not finite, or a rotation is not of unit length";
    case ReactionStatus::bad_ball:
      return "the ball is not finite, or outside 1 mm to 10 m of radius, 1 g to 1000 kg and 1000 "
             "m/s";
    case ReactionStatus::bad_push:
      return "a push is at chest, neck, head or a shoulder, and at most 1000 m/s";
    case ReactionStatus::failed:
      break;
  }
  return "the simulation failed; the motion continues without it";
}

Reaction::Reaction(std::shared_ptr<const sim::FigureModel> figure,
                   const ReactionOptions& options) noexcept {
  try {
    state_ = std::make_unique<State>();
    state_->figure_model = std::move(figure);
    state_->options = options;
  } catch (...) {
  }
}

Reaction::~Reaction() = default;
Reaction::Reaction(Reaction&&) noexcept = default;
Reaction& Reaction::operator=(Reaction&&) noexcept = default;

ReactionStatus Reaction::begin(const motion::Pose& before, const motion::Pose& now, double dt_s,
                               const features::Ball* ball) noexcept {
  if (!state_) return ReactionStatus::bad_options;
  if (const auto status = state_->check(before, now, dt_s); status != ReactionStatus::ok)
    return status;
  if (ball && !is_in_range(*ball)) return ReactionStatus::bad_ball;
  return state_->begin(before, now, dt_s, ball, {});
}

ReactionStatus Reaction::begin_push(const motion::Pose& before, const motion::Pose& now,
                                    double dt_s, motion::Role place,
                                    const Eigen::Vector3d& velocity) noexcept {
  if (!state_) return ReactionStatus::bad_options;
  if (const auto status = state_->check(before, now, dt_s); status != ReactionStatus::ok)
    return status;
  const SuddenPush push{place, velocity};
  if (!is_in_range(push)) return ReactionStatus::bad_push;
  return state_->begin(before, now, dt_s, nullptr, push);
}

ReactionStatus Reaction::advance(double dt_s, const motion::Pose& wanted,
                                 const motion::Pose& returning) noexcept {
  if (!state_ || state_->phase == ReactionPhase::none) return ReactionStatus::not_begun;
  if (!is_frame_time(dt_s)) return ReactionStatus::bad_time;
  if (!is_sound(wanted) || !is_sound(returning)) return ReactionStatus::bad_pose;
  try {
    if (!state_->has_failed) {
      state_->advance(dt_s, wanted, returning);
      return ReactionStatus::ok;
    }
  } catch (...) {
    state_->has_failed = true;
  }
  state_->shown = returning;
  state_->phase = ReactionPhase::over;
  return ReactionStatus::failed;
}

const motion::Pose& Reaction::pose() const noexcept {
  static const motion::Pose none;
  return state_ ? state_->shown : none;
}

ReactionPhase Reaction::phase() const noexcept {
  return state_ ? state_->phase : ReactionPhase::none;
}

features::Ball Reaction::ball() const noexcept {
  if (!state_ || !state_->run) return state_ ? state_->initial_ball : features::Ball{};
  return state_->run->ball(state_->initial_ball);
}

double Reaction::contact_s() const noexcept {
  return state_ && state_->run ? state_->run->contact_s() : std::numeric_limits<double>::infinity();
}

motion::PerBody<double> Reaction::impulse() const noexcept {
  return state_ && state_->run ? state_->run->encounter().impulse() : motion::PerBody<double>{};
}

Eigen::Vector3d Reaction::ball_momentum() const noexcept {
  return state_ && state_->run ? state_->run->ball_momentum() : Eigen::Vector3d::Zero();
}

}  // namespace flinch::reaction
