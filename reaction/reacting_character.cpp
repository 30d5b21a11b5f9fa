// SPDX-License-Identifier: MIT
#include "reaction/reacting_character.h"

#include <algorithm>
#include <cmath>

#include "runtime/pose_check.h"

namespace flinch::reaction {
namespace {

/// Whether the push was a usable one to which there is no recorded answer.
bool is_without_answer(runtime::Status status) {
  return status == runtime::Status::no_good_answer || status == runtime::Status::without_pushes ||
         status == runtime::Status::without_realism;
}

}  // namespace

std::shared_ptr<const ReactionData> make_reaction_data(const runtime::Library& library) noexcept {
  if (!library.is_loaded()) return nullptr;
  try {
    return std::make_shared<const ReactionData>(
        ReactionData{make_figure_model(library.clip_library().character)});
  } catch (...) {
    return nullptr;
  }
}

std::optional<motion::Role> push_place_of(motion::Body body) noexcept {
  using motion::Body;
  using motion::Role;
  switch (body) {
    case Body::pelvis:
    case Body::abdomen:
    case Body::chest:
      return Role::chest;
    case Body::neck:
      return Role::neck;
    case Body::head:
      return Role::head;
    case Body::left_upper_arm:
    case Body::left_forearm:
    case Body::left_hand:
      return Role::left_upper_arm;
    case Body::right_upper_arm:
    case Body::right_forearm:
    case Body::right_hand:
      return Role::right_upper_arm;
    default:
      return std::nullopt;
  }
}

const char* name_of(PoseSource pose_source) noexcept {
  switch (pose_source) {
    case PoseSource::character:
      return "character";
    case PoseSource::physics:
      return "physics";
    case PoseSource::reaction_clip:
      break;
  }
  return "reaction clip";
}

ReactingCharacter::ReactingCharacter(const runtime::Library& library,
                                     std::shared_ptr<const ReactionData> data,
                                     const ReactionOptions& options) noexcept
    : library_(&library),
      data_(std::move(data)),
      character_(library),
      reaction_(data_ ? data_->figure : nullptr, options),
      pose_(character_.pose()),
      before_(pose_) {
  workspace_.reserve_memory(
      library.selection_bytes());  // push() reports a workspace without memory
}

ReactionStatus ReactingCharacter::react_to(const features::Ball& ball) noexcept {
  const ReactionStatus status = reaction_.begin(before_, pose_, double{step_s_}, &ball);
  if (status == ReactionStatus::ok) begin_physics(Cause::ball);
  return status;
}

void ReactingCharacter::begin_physics(Cause cause) noexcept {
  pose_source_ = PoseSource::physics;
  cause_ = cause;
  has_answered_ = false;
  answer_.reset();
}

runtime::Status ReactingCharacter::push(motion::Role place,
                                        const Eigen::Vector3f& velocity) noexcept {
  const bool is_physical = pose_source_ == PoseSource::physics;
  if (is_physical && reaction_.phase() == ReactionPhase::knocked_over)
    return runtime::Status::no_good_answer;
  runtime::Character moved = is_physical ? at_shown_pose() : character_;
  const runtime::Status status = moved.push(place, velocity, workspace_);
  if (!is_without_answer(status) && status != runtime::Status::ok) return status;
  character_ = moved;
  if (status == runtime::Status::ok) {
    if (is_physical) pose_source_ = PoseSource::reaction_clip;
    answer_.reset();
    return status;
  }
  const Eigen::Vector3d level(double{velocity.x()}, double{velocity.y()}, 0);
  if (reaction_.begin_push(before_, pose_, double{step_s_}, place, level) != ReactionStatus::ok)
    return status;
  begin_physics(Cause::push);
  return runtime::Status::ok;
}

ReactionStatus ReactingCharacter::update(float dt_s) noexcept {
  if (pose_source_ == PoseSource::physics && !(dt_s <= kMaxReactionFrame_s))
    return ReactionStatus::bad_time;
  if (character_.update(dt_s) != runtime::Status::ok) return ReactionStatus::bad_time;
  before_ = pose_;
  step_s_ = dt_s;
  status_ = ReactionStatus::ok;
  if (pose_source_ == PoseSource::physics) {
    update_from_physics(dt_s);
    return status_;
  }
  pose_ = character_.pose();
  if (character_.phase() != runtime::Phase::pushed) pose_source_ = PoseSource::character;
  return status_;
}

// Decides once, before the return begins, where it leads.
void ReactingCharacter::update_from_physics(float dt_s) noexcept {
  if (answer_) answer_->update(dt_s);
  const motion::Pose wanted = character_.pose();
  status_ = reaction_.advance(double{dt_s}, wanted, answer_ ? answer_->pose() : wanted);
  pose_ = reaction_.pose();
  if (reaction_.phase() == ReactionPhase::recovering && !has_answered_) {
    has_answered_ = true;
    answer_ = cause_ == Cause::ball ? answer_to_blow() : pushed_away();
  }
  if (reaction_.phase() != ReactionPhase::over) return;
  if (answer_) {
    answer_->perceive_as(character_);
    character_ = *answer_;
  }
  answer_.reset();
  pose_source_ = character_.phase() == runtime::Phase::pushed ? PoseSource::reaction_clip
                                                              : PoseSource::character;
}

runtime::Character ReactingCharacter::at_shown_pose() const noexcept {
  runtime::Character character = character_;
  character.move_to(before_, pose_, std::max(step_s_, runtime::kMinPoseInterval_s));
  return character;
}

/// A pushed body does not come back to where it was: it stays, or walks on, where it now is.
runtime::Character ReactingCharacter::pushed_away() const noexcept {
  runtime::Character character = at_shown_pose();
  if (!character.walks()) character.settle();
  return character;
}

std::optional<runtime::Character> ReactingCharacter::answer_to_blow() noexcept {
  if (!data_->continues_by_clips || !std::isfinite(reaction_.contact_s())) return std::nullopt;
  const motion::PerBody<double> impulse = reaction_.impulse();
  const auto struck = std::ranges::max_element(motion::kBodies, {},
                                               [&](motion::Body body) { return impulse[body]; });
  const std::optional<motion::Role> place = push_place_of(*struck);
  if (!place) return std::nullopt;
  runtime::Character answer = at_shown_pose();
  const Eigen::Vector2f blow = blow_mps();
  if (answer.push(*place, {blow.x(), blow.y(), 0}, workspace_) != runtime::Status::ok)
    return std::nullopt;
  return answer;
}

Eigen::Vector2f ReactingCharacter::blow_mps() const noexcept {
  const double mass_kg = static_cast<double>(library_->clip_library().character.mass_kg);
  return (reaction_.ball_momentum().head<2>() / mass_kg).cast<float>();
}

void ReactingCharacter::stop() noexcept {
  pose_source_ = PoseSource::character;
  answer_.reset();
  pose_ = character_.pose();
  before_ = pose_;
}

std::optional<int> ReactingCharacter::reaction_clip() const noexcept {
  if (answer_ && answer_->phase() == runtime::Phase::pushed) return answer_->clip();
  if (pose_source_ == PoseSource::reaction_clip) return character_.clip();
  return std::nullopt;
}

}  // namespace flinch::reaction
