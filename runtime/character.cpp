// SPDX-License-Identifier: MIT
#include "runtime/character.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "features/feature_layout.h"
#include "features/impact_prediction.h"
#include "motion/interpolation.h"
#include "runtime/pose_blend.h"
#include "runtime/pose_check.h"
#include "runtime/response/brace.h"
#include "runtime/response/prepared_library.h"
#include "runtime/selection.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;

constexpr float kVelocityInterval_s =
    1.0F / 240;                        // interval over which velocities of responses are measured
constexpr double kMaxTime_s = 1e6;     // longer times are not told apart
constexpr float kDriftTime_s = 0.5F;   // over which the velocity of a character is averaged
constexpr double kMaxPoseAge_s = 0.1;  // of a pose after which the game's motion goes on
constexpr float kMinPoseInterval_s = 1e-4F;  // poses less far apart say nothing about velocities

bool is_time_step(float time_s) {
  return time_s > 0 && time_s <= kMaxTimeStep_s;  // false for NaN
}

/// Whether a call that returns this was not refused.
bool is_answer(Status status) {
  return status == Status::ok || status == Status::misses || status == Status::unnoticed;
}

bool is_time_to_impact(float time_s) {
  return time_s > 0 && time_s <= features::kMaxHorizon_s;
}

/// The impact on a character that keeps its pose and moves along the ground.
features::PredictedImpact predict_impact(const features::Threat& threat,
                                         const features::CollisionFigure& figure, const Pose& now,
                                         const Eigen::Vector3f& drift_mps) noexcept {
  const features::PredictionOptions options;
  const auto pose_at = [&](float time_s) {
    Pose pose = now;
    pose.root_position += time_s * drift_mps;
    return pose;
  };
  const Eigen::Vector3f way = options.horizon_s * drift_mps;
  const features::MotionBounds bounds{now.root_position + 0.5F * way, 0.5F * way.norm(),
                                      drift_mps.norm()};
  return features::predict_impact(threat, figure, features::PredictedMotion(pose_at, bounds),
                                  options);
}

/// Where the character sees from.
Eigen::Vector3f eye_of(const motion::Skeleton& skeleton, const Pose& pose) {
  constexpr std::array kToHead{Role::pelvis, Role::abdomen, Role::chest, Role::neck, Role::head};
  return motion::forward_kinematics(skeleton, pose, kToHead).position[Role::head];
}

}  // namespace

motion::PerRole<float> Mask::whole_body() {
  motion::PerRole<float> joint;
  std::fill(joint.begin(), joint.end(), 1.0F);
  return joint;
}

Character::Character(const Library& library) noexcept : library_(&library) {}

Status Character::place(const Eigen::Vector2f& position, float facing, float idle_time_s,
                        int stance) noexcept {
  const auto is_within = [](float x, float max) { return std::abs(x) <= max; };  // false for NaN
  if (!is_within(position.x(), kMaxPlace_m) || !is_within(position.y(), kMaxPlace_m) ||
      !is_within(facing, features::kMaxExtent) || !is_within(idle_time_s, features::kMaxExtent)) {
    return Status::bad_placement;
  }
  if (stance != 0 && !(library_->is_loaded() && library_->prepared().has_stance(stance)))
    return Status::bad_placement;
  state_ = {idle_time_s, position, facing, stance};
  time_s_ = 0;
  response_ = {};
  push_ = {};
  inertialization_ = {};
  delayed_clip_.reset();
  waiting_count_ = 0;
  return Status::ok;
}

Status Character::set_pose(const Pose& before, const Pose& now, float dt_s) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (!is_time_step(dt_s) || dt_s < kMinPoseInterval_s) return Status::bad_time;
  if (!is_usable(before) || !is_usable(now)) return Status::bad_pose;
  // The first pose that the game reports counts alone.
  const bool goes_on = !is_responding() && is_settling();
  const float share = goes_on ? 1 - std::exp(-dt_s / kDriftTime_s) : 1.0F;
  Eigen::Vector3f velocity_mps = (now.root_position - before.root_position) / dt_s;
  velocity_mps.z() = 0;
  drift_mps_ += share * (velocity_mps - drift_mps_);
  state_ = rest_state_at(library_->prepared(), now, state_.stance);
  inertialization_ = make_inertialization(library_->prepared(), state_, before, now, dt_s);
  time_s_ = 0;
  response_ = {};
  push_ = {};
  walk_ = {};
  waiting_count_ = 0;
  return Status::ok;
}

Status Character::move_to(const Pose& before, const Pose& now, float dt_s) noexcept {
  const Walk walk = walk_;
  const Status status = set_pose(before, now, dt_s);
  if (status == Status::ok) walk_ = walk;
  return status;
}

Status Character::settle() noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  walk_ = {};
  if (!is_responding() && !is_settling() && !is_pushed()) return Status::ok;
  delayed_clip_.reset();
  time_to_impact_s_ = std::numeric_limits<double>::infinity();
  return begin(library_->prepared().library->idle, 1);
}

Status Character::change_stance(int stance) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  const PreparedLibrary& library = library_->prepared();
  if (!library.has_stance(stance)) return Status::bad_placement;
  walk_ = {};
  if (!is_responding() && !is_settling() && state_.stance == stance) return Status::ok;
  const float now_s = static_cast<float>(time_s_);
  const float before_s = now_s - kVelocityInterval_s;
  const features::CharacterState state = rest_state_at(library, pose(), stance);
  const Inertialization inertialization = make_inertialization(
      library, state, pose_after(before_s), pose_after(now_s), kVelocityInterval_s);
  delayed_clip_.reset();
  time_to_impact_s_ = std::numeric_limits<double>::infinity();
  return begin(state, inertialization, library.library->idle, 1);
}

void Character::limit_perception(const PerceptionLimits& limits, std::uint64_t seed) noexcept {
  limits_ = limits;
  seed_ = seed;
}

void Character::perceive_as(const Character& other) noexcept {
  limits_ = other.limits_;
  seed_ = other.seed_;
  threats_ = other.threats_;
}

Status Character::predict(const features::Threat& threat, Perception& perception) const noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (!features::is_usable(threat)) return Status::bad_threat;
  const PreparedLibrary& library = library_->prepared();
  const Pose now = pose();
  const Eigen::Vector3f eye = eye_of(library.skeleton(), now);
  const Perceived seen = runtime::perceive(threat, eye, limits_, seed_, threats_);
  if (!seen.noticed) return Status::unnoticed;
  features::CharacterState state = current_state();
  const PreparedStance& stance = library.stance_of(state);
  const features::PredictedImpact impact =
      is_in_stance() ? features::predict_impact(seen.threat, library.figure(), stance.loop,
                                                stance.bounds, state)
                     : predict_impact(seen.threat, library.figure(), now, current_drift_mps());
  if (!is_in_stance() && stance.loop.travels()) state.stance = 0;  // where it comes to rest
  if (impact.outcome == features::Outcome::unusable) return Status::bad_threat;
  if (impact.outcome == features::Outcome::miss) return Status::misses;
  const float time_s = std::max(impact.time_to_impact_s, 1e-3F);
  if (!is_in_stance()) state.position += time_s * current_drift_mps().head<2>();
  perception = {{seen.threat, impact.aimed_at, time_s, state}, seen.delay_s};
  return Status::ok;
}

/// How a character goes on that walks or that the game animates; other characters come to rest.
Eigen::Vector3f Character::current_drift_mps() const noexcept {
  if (is_walking()) {
    const auto now_s = static_cast<float>(time_s_);
    const Eigen::Vector3f way =
        pose_after(now_s).root_position - pose_after(now_s - kVelocityInterval_s).root_position;
    return Eigen::Vector3f(way.x(), way.y(), 0) / kVelocityInterval_s;
  }
  const bool is_animated = !is_responding() && is_settling() && time_s_ < kMaxPoseAge_s;
  return is_animated ? drift_mps_ : Eigen::Vector3f(Eigen::Vector3f::Zero());
}

Status Character::notice(const features::Threat& threat, Perception& perception) noexcept {
  return counted(predict(threat, perception));
}

Notice Character::notice(std::span<const features::Threat> threats,
                         std::span<Perception> most_urgent) noexcept {
  if (!library_->is_loaded()) return {};
  Notice noticed{Status::misses};
  const std::uint64_t threats_before = threats_;
  for (const features::Threat& threat : threats) {
    Perception perception;
    const Status status = notice(threat, perception);
    if (!is_answer(status)) {
      threats_ = threats_before;
      return {status};
    }
    if (status == Status::unnoticed) noticed.status = status;
    if (status != Status::ok) continue;
    // Insertion into the most urgent so far; of equally urgent ones the first stays first.
    const auto first = most_urgent.begin();
    const auto end = first + static_cast<std::ptrdiff_t>(noticed.count);
    const auto at = std::upper_bound(
        first, end, perception, [](const Perception& sooner, const Perception& later) {
          return sooner.scenario.time_to_impact_s < later.scenario.time_to_impact_s;
        });
    const bool is_full = noticed.count == most_urgent.size();
    if (is_full) ++noticed.ignored;
    if (is_full && at == end) continue;
    std::move_backward(at, is_full ? end - 1 : end, is_full ? end : end + 1);
    *at = perception;
    if (!is_full) ++noticed.count;
  }
  if (noticed.count > 0) noticed.status = Status::ok;
  return noticed;
}

Status Character::perceive(std::span<const features::Threat> threats,
                           Workspace& workspace) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (workspace.memory().size() < library_->selection_bytes()) return Status::other_workspace;
  std::array<Perception, kMaxThreats> urgent{};
  const Notice noticed = notice(threats, urgent);
  if (noticed.count == 0) return noticed.status;
  std::array<Waiting, kMaxThreats - 1> waiting{};
  for (std::size_t i = 1; i < noticed.count; ++i) {
    std::array<models::Candidate, 1> best{};
    std::size_t count = 0;
    rank(urgent[i], workspace, best, count);
    waiting[i - 1] = {best[0].clip, urgent[i].scenario.target,
                      double{urgent[i].scenario.time_to_impact_s}};
  }
  const Status status = rank_and_answer(urgent[0], workspace);
  if (status != Status::ok) return status;
  waiting_ = waiting;
  waiting_count_ = noticed.count - 1;
  return Status::ok;
}

/// Begins the response to the next threat that leaves time for one.
void Character::answer_next() noexcept {
  while (waiting_count_ > 0) {
    const Waiting next = waiting_[0];
    std::move(waiting_.begin() + 1, waiting_.end(), waiting_.begin());
    const std::size_t left = --waiting_count_;
    if (next.time_to_impact_s < double{kMinBlend_s}) continue;
    if (begin(next.clip, static_cast<float>(next.time_to_impact_s)) != Status::ok) continue;
    waiting_count_ = left;
    target_ = next.target;
    time_to_impact_s_ = next.time_to_impact_s;
    return;
  }
}

Status Character::perceive(const features::Threat& threat, Workspace& workspace) noexcept {
  Perception perception;
  const Status status = predict(threat, perception);
  return counted(status == Status::ok ? rank_and_answer(perception, workspace) : status);
}

Status Character::perceive(const features::Threat& threat, motion::Target target,
                           float time_to_impact_s, Workspace& workspace) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (!features::is_usable(threat) || !is_time_to_impact(time_to_impact_s))
    return Status::bad_threat;
  const Eigen::Vector3f eye = eye_of(library_->prepared().skeleton(), pose());
  const Perceived seen = runtime::perceive(threat, eye, limits_, seed_, threats_);
  if (!seen.noticed) return counted(Status::unnoticed);
  const features::Scenario scenario{seen.threat, target, time_to_impact_s, current_state()};
  return counted(rank_and_answer({scenario, seen.delay_s}, workspace));
}

// A refused threat draws no random numbers: the next is perceived as if the call had not been made.
Status Character::counted(Status status) noexcept {
  if (is_answer(status)) ++threats_;
  return status;
}

Status Character::rank(const Perception& perception, Workspace& workspace,
                       std::span<models::Candidate> best, std::size_t& count) const noexcept {
  if (!library_->is_loaded() || library_->selector().clips.empty()) return Status::not_loaded;
  count = 0;
  if (best.empty()) return Status::ok;
  const features::FeatureVector x =
      features::feature_vector(library_->selector().layout, perception.scenario,
                               library_->prepared().figure_in(perception.scenario.state));
  const Selection selection =
      select(workspace, library_->selector(), x, perception.scenario.target, best);
  if (selection.status != SelectStatus::ok) return Status::other_workspace;
  count = selection.count;
  return Status::ok;
}

Response Character::plan(const Perception& perception, int clip) const noexcept {
  const float time_s = perception.scenario.time_to_impact_s - perception.delay_s;
  if (!library_->is_loaded() || !is_time_to_impact(time_s)) return {};
  features::CharacterState state = current_state();
  if (!is_responding() && !is_pushed())
    state = features::later(current_loop(), state, perception.delay_s);
  return make_response(library_->prepared(), state, clip, time_s, current_inertialization(state));
}

Status Character::answer(const Perception& perception, int clip,
                         std::span<const models::Candidate> candidates) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  const features::Scenario& scenario = perception.scenario;
  if (!is_time_to_impact(scenario.time_to_impact_s)) return Status::bad_threat;
  if (perception.delay_s > 0) {
    waiting_count_ = 0;
    delayed_clip_ = clip;
    delay_s_ = double{perception.delay_s};
  } else if (const Status status = begin(clip, scenario.time_to_impact_s); status != Status::ok) {
    return status;
  }
  candidate_count_ = std::min(candidates.size(), kMaxCandidates);
  std::copy_n(candidates.begin(), candidate_count_, candidates_.begin());
  target_ = scenario.target;
  time_to_impact_s_ = double{scenario.time_to_impact_s};
  return Status::ok;
}

Status Character::rank_and_answer(const Perception& perception, Workspace& workspace) noexcept {
  std::array<models::Candidate, kMaxCandidates> candidates{};
  std::size_t count = 0;
  const Status status = rank(perception, workspace, candidates, count);
  if (status != Status::ok) return status;
  return answer(perception, candidates[0].clip, std::span(candidates).first(count));
}

Status Character::respond(int clip, float time_to_impact_s) noexcept {
  if (!library_->is_loaded()) return Status::not_loaded;
  if (!is_time_to_impact(time_to_impact_s)) return Status::bad_threat;
  const Status status = begin(clip, time_to_impact_s);
  if (status == Status::ok) time_to_impact_s_ = double{time_to_impact_s};
  return status;
}

// The state of a character in its stance advances with it; that of any other is where its feet are.
features::CharacterState Character::current_state() const noexcept {
  if (is_pushed()) return rest_state_at(library_->prepared(), pose(), state_.stance);
  if (is_responding() && !is_in_stance()) {
    if (time_s_ < double{kMinPoseInterval_s}) return response_.state;
    return rest_state_at(library_->prepared(), pose(), response_.state.stance);
  }
  return features::later(current_loop(), state_, static_cast<float>(time_s_));
}

/// The motion of its stance or, for a character that settles, of that in which it comes to rest.
const motion::Loop& Character::current_loop() const noexcept {
  const PreparedLibrary& library = library_->prepared();
  return (is_settling() ? library.rest_of(state_) : library.stance_of(state_)).loop;
}

Inertialization Character::current_inertialization(
    const features::CharacterState& state) const noexcept {
  if (is_in_stance()) return {};
  if (time_s_ < double{kMinPoseInterval_s} && !is_pushed())
    return is_responding() ? response_.inertialization : inertialization_;
  const float now_s = static_cast<float>(time_s_);
  const float before_s =
      is_pushed() ? now_s - kVelocityInterval_s : std::max(now_s - kVelocityInterval_s, 0.0F);
  return make_inertialization(library_->prepared(), state, pose_after(before_s), pose_after(now_s),
                              now_s - before_s);
}

Status Character::begin(int clip, float time_to_impact_s) noexcept {
  const features::CharacterState state = current_state();
  return begin(state, current_inertialization(state), clip, time_to_impact_s);
}

Status Character::begin(const features::CharacterState& state,
                        const Inertialization& inertialization, int clip,
                        float time_to_impact_s) noexcept {
  const Response response =
      make_response(library_->prepared(), state, clip, time_to_impact_s, inertialization);
  if (!is_valid(response)) return Status::bad_clip;
  begin(response);
  return Status::ok;
}

void Character::begin(const Response& response) noexcept {
  response_ = response;
  push_ = {};
  state_ = response.state;
  inertialization_ = {};
  time_s_ = 0;
  delayed_clip_.reset();
  waiting_count_ = 0;
}

Response Character::plan_brace(const Perception& perception, bool startles) const noexcept {
  if (!library_->is_loaded()) return {};
  const features::Scenario& scenario = perception.scenario;
  const features::CharacterState state = current_state();
  const float time_s = scenario.time_to_impact_s;
  features::Threat threat = scenario.threat;
  if (threat.rod)
    threat = striking_ball(threat, time_s,
                           predict_character(library_->prepared().figure_in(state), state, time_s)
                               .target_centres[scenario.target]);
  return make_brace(library_->prepared(), state,
                    {threat, position_at(threat, time_s), time_s, perception.delay_s, startles},
                    current_inertialization(state));
}

Status Character::brace(const features::Threat& threat, bool startles) noexcept {
  Perception perception;
  const Status status = predict(threat, perception);
  if (status != Status::ok) return counted(status);
  const Response response = plan_brace(perception, startles);
  if (!is_valid(response)) return Status::bad_threat;
  begin(response);
  candidate_count_ = 0;
  target_ = perception.scenario.target;
  time_to_impact_s_ = double{perception.scenario.time_to_impact_s};
  return counted(Status::ok);
}

void Character::finish() noexcept {
  state_ = response_.home;
  state_.position += response_.idle_displacement.head<2>();
  if (response_.walk_on_s >= 0)
    time_s_ = double{home_time_s(response_, static_cast<float>(time_s_))};
  response_ = {};
}

Status Character::update(float dt_s) noexcept {
  if (!is_time_step(dt_s)) return Status::bad_time;
  if (!library_->is_loaded()) return Status::not_loaded;
  const double dt = double{dt_s};
  time_s_ = std::min(time_s_ + dt, kMaxTime_s);
  time_to_impact_s_ = std::max(time_to_impact_s_ - dt, -kMaxTime_s);
  if (delayed_clip_) {
    delay_s_ -= dt;
    // A threat that hits before the delay is over gets no response.
    if (time_to_impact_s_ <= 0) {
      delayed_clip_.reset();
    } else if (delay_s_ <= 0) {
      const std::size_t waiting = waiting_count_;
      begin(*delayed_clip_, static_cast<float>(time_to_impact_s_));
      waiting_count_ = waiting;
    }
  }
  for (Waiting& waiting : waiting_) waiting.time_to_impact_s -= dt;
  if (time_to_impact_s_ <= 0) answer_next();
  if (is_responding() && time_s_ >= double{duration_s(response_)}) finish();
  if (walk_.graph != nullptr) {
    walk_on();
  } else if (is_pushed() && time_s_ >= double{push_.duration_s}) {
    finish_push(dt_s);
  }
  if (!is_responding() && !is_pushed()) remove_periods();
  return Status::ok;
}

// Removing whole periods keeps the time small. Those of the idle clip change nothing; cycles of a
// walk move the state along. By then nothing is left of a difference.
void Character::remove_periods() noexcept {
  const motion::Loop& loop = current_loop();
  const double period_s = double{loop.period_s()};
  if (!(period_s > 0) || time_s_ < period_s) return;
  const double rest_s = std::fmod(time_s_, period_s);
  if (loop.has_cycles())
    state_ = features::later(loop, state_, static_cast<float>(time_s_ - rest_s));
  time_s_ = rest_s;
  if (!is_settling()) return;
  if (library_->prepared().stance_of(state_).loop.travels()) state_.stance = 0;
  inertialization_ = {};
}

Pose Character::pose() const noexcept {
  if (!library_->is_loaded()) return {};
  return pose_after(static_cast<float>(time_s_));
}

Pose Character::pose_after(float time_s) const noexcept {
  if (is_pushed()) return pose_at(push_, time_s);
  if (is_responding()) return pose_at(response_, time_s);
  return inertialized_pose(library_->prepared(), state_, inertialization_, time_s);
}

Pose Character::pose_over(const Pose& game, const Mask& mask) const noexcept {
  return blended(game, pose(), mask);
}

bool Character::is_responding() const noexcept {
  return is_valid(response_);
}

bool Character::is_settling() const noexcept {
  return !is_responding() && !inertialization_.is_zero;
}

bool Character::is_in_stance() const noexcept {
  if (is_pushed()) return false;
  if (is_responding()) return time_s_ < double{response_.leave_s};
  return inertialization_.is_zero;
}

Phase Character::phase() const noexcept {
  if (is_pushed() && !is_walking()) return Phase::pushed;
  if (delayed_clip_) return Phase::reacting;
  if (is_walking()) return Phase::walking;
  if (!is_responding()) return Phase::idle;
  const float t = response_time_s();
  if (response_.clip == library_->prepared().library->idle) return Phase::returning;
  if (t < response_.first_motion_s) return Phase::waiting;
  if (t < response_.begin_s) return Phase::shifting;
  if (t < response_.begin_s + response_.blend_duration_s) return Phase::blending;
  return t < response_.end_s ? Phase::protecting : Phase::returning;
}

int Character::clip() const noexcept {
  if (is_pushed()) return push_.clip;
  if (is_responding()) return response_.clip;
  return library_->is_loaded() ? library_->prepared().library->idle : 0;
}

std::span<const PushCandidate> Character::push_candidates() const noexcept {
  return {push_candidates_.data(), push_candidate_count_};
}

std::span<const models::Candidate> Character::candidates() const noexcept {
  return {candidates_.data(), candidate_count_};
}

float Character::time_to_impact_s() const noexcept {
  return static_cast<float>(time_to_impact_s_);
}

}  // namespace flinch::runtime
