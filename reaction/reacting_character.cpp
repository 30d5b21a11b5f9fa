// SPDX-License-Identifier: MIT
#include "reaction/reacting_character.h"

#include <cmath>

namespace flinch::reaction {

std::shared_ptr<const ReactionData> make_reaction_data(const runtime::Library& library) noexcept {
  if (!library.is_loaded()) return nullptr;
  try {
    const database::ClipLibrary& clips = library.clip_library();
    return std::make_shared<const ReactionData>(
        ReactionData{make_figure_model(clips.character), {clips.character, clips.clips}});
  } catch (...) {
    return nullptr;
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
      before_(pose_) {}

ReactionStatus ReactingCharacter::react_to(const features::Ball& ball) noexcept {
  const ReactionStatus status = reaction_.begin(before_, pose_, double{step_s_}, &ball);
  if (status != ReactionStatus::ok) return status;
  // The simulation tracks the character's own motion, which the reaction clip does not follow.
  if (pose_source_ == PoseSource::reaction_clip) resume_from_shown_pose(step_s_);
  pose_source_ = PoseSource::physics;
  has_searched_ = false;
  match_.reset();
  return ReactionStatus::ok;
}

ReactionStatus ReactingCharacter::update(float dt_s) noexcept {
  if (pose_source_ == PoseSource::physics && !(dt_s <= kMaxReactionFrame_s))
    return ReactionStatus::bad_time;
  if (character_.update(dt_s) != runtime::Status::ok) return ReactionStatus::bad_time;
  before_ = pose_;
  step_s_ = dt_s;
  status_ = ReactionStatus::ok;
  switch (pose_source_) {
    case PoseSource::character:
      pose_ = character_.pose();
      break;
    case PoseSource::physics:
      update_from_physics(dt_s);
      break;
    case PoseSource::reaction_clip:
      update_from_clip(dt_s);
      break;
  }
  return status_;
}

// Searches for a clip once, before the return to the destination begins, if anything was hit.
void ReactingCharacter::update_from_physics(float dt_s) noexcept {
  match_age_s_ += dt_s;
  const motion::Pose wanted = character_.pose();
  const motion::Pose returning =
      match_ ? pose_of(library_->clip_library().clip(match_->clip), *match_, match_age_s_) : wanted;
  status_ = reaction_.advance(double{dt_s}, wanted, returning);
  pose_ = reaction_.pose();
  if (reaction_.phase() == ReactionPhase::recovering && !has_searched_) {
    has_searched_ = true;
    if (std::isfinite(reaction_.contact_s()))
      match_ = data_->clips.find(before_, pose_, dt_s, blow_mps());
    match_age_s_ = 0;
  }
  if (reaction_.phase() == ReactionPhase::over) {
    pose_source_ = match_ ? PoseSource::reaction_clip : PoseSource::character;
  }
}

Eigen::Vector2f ReactingCharacter::blow_mps() const noexcept {
  const double mass_kg = static_cast<double>(library_->clip_library().character.mass_kg);
  return (reaction_.ball_momentum().head<2>() / mass_kg).cast<float>();
}

void ReactingCharacter::update_from_clip(float dt_s) noexcept {
  match_age_s_ += dt_s;
  const motion::Clip& clip = library_->clip_library().clip(match_->clip);
  pose_ = pose_of(clip, *match_, match_age_s_);
  if (match_->time_s + match_age_s_ < clip.motion.duration_s()) return;
  resume_from_shown_pose(dt_s);
  match_.reset();
  pose_source_ = PoseSource::character;
}

void ReactingCharacter::resume_from_shown_pose(float dt_s) noexcept {
  character_.set_pose(before_, pose_, dt_s);
  character_.settle();
}

void ReactingCharacter::stop() noexcept {
  pose_source_ = PoseSource::character;
  match_.reset();
  pose_ = character_.pose();
  before_ = pose_;
}

std::optional<int> ReactingCharacter::reaction_clip() const noexcept {
  if (!match_) return std::nullopt;
  return match_->clip;
}

}  // namespace flinch::reaction
