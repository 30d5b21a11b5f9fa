// SPDX-License-Identifier: MIT
#include "runtime/character.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/interpolation.h"
#include "runtime/pose_blend.h"
#include "runtime/pose_check.h"
#include "runtime/response/brace.h"
#include "runtime/response/prepared_library.h"

namespace flinch::runtime {
namespace {

using motion::Pose;
using motion::Role;

constexpr double kMaxTime_s = 1e6;    // longer times are not told apart
constexpr float kDriftTime_s = 0.5F;  // over which the velocity of a character is averaged

bool is_time_step(float time_s) {
  return time_s > 0 && time_s <= kMaxTimeStep_s;  // false for NaN
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
