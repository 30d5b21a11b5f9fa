// SPDX-License-Identifier: MIT
#include "reaction/reacting_character.h"

#include <cmath>

namespace flinch::reaction {

sim::Ball ball_of(const features::Threat& threat) noexcept {
  return {threat.position.cast<double>(), threat.velocity.cast<double>(), double{threat.radius},
          double{threat.mass_kg}};
}

std::shared_ptr<const ReactionKit> make_reaction_kit(const runtime::Library& library) noexcept {
  if (!library.is_loaded()) return nullptr;
  try {
    const database::Library& clips = library.clips();
    return std::make_shared<const ReactionKit>(
        ReactionKit{make_figure_plan(clips.character), {clips.character, clips.clips}});
  } catch (...) {
    return nullptr;
  }
}

const char* name_of(Mover mover) noexcept {
  switch (mover) {
    case Mover::character:
      return "character";
    case Mover::physics:
      return "physics";
    case Mover::reaction_clip:
      break;
  }
  return "reaction clip";
}

ReactingCharacter::ReactingCharacter(const runtime::Library& library,
                                     std::shared_ptr<const ReactionKit> kit,
                                     const ReactionOptions& options) noexcept
    : library_(&library),
      kit_(std::move(kit)),
      character_(library),
      reaction_(kit_ ? kit_->figure : nullptr, options),
      pose_(character_.pose()),
      before_(pose_) {}

ReactionStatus ReactingCharacter::meet(const sim::Ball& ball) noexcept {
  const ReactionStatus status = reaction_.begin(before_, pose_, double{step_s_}, &ball);
  if (status != ReactionStatus::ok) return status;
  // What is tracked is the character's motion, which the clip has left behind.
  if (mover_ == Mover::reaction_clip) stand_as_shown(step_s_);
  mover_ = Mover::physics;
  has_searched_ = false;
  match_.reset();
  return ReactionStatus::ok;
}

ReactionStatus ReactingCharacter::update(float dt_s) noexcept {
  if (mover_ == Mover::physics && !(dt_s <= kMostReactionFrame_s)) return ReactionStatus::bad_time;
  if (character_.update(dt_s) != runtime::Status::ok) return ReactionStatus::bad_time;
  before_ = pose_;
  step_s_ = dt_s;
  status_ = ReactionStatus::ok;
  switch (mover_) {
    case Mover::character:
      pose_ = character_.pose();
      break;
    case Mover::physics:
      follow_physics(dt_s);
      break;
    case Mover::reaction_clip:
      follow_clip(dt_s);
      break;
  }
  return status_;
}

// A clip is looked for once, before the way to what is returned to begins.
void ReactingCharacter::follow_physics(float dt_s) noexcept {
  since_match_s_ += dt_s;
  const motion::Pose wanted = character_.pose();
  const auto& clips = library_->clips().clips;
  const motion::Pose returning =
      match_ ? pose_of(clips[static_cast<std::size_t>(match_->clip)], *match_, since_match_s_)
             : wanted;
  status_ = reaction_.advance(double{dt_s}, wanted, returning);
  pose_ = reaction_.pose();
  if (reaction_.phase() == ReactionPhase::recovering && !has_searched_) {
    has_searched_ = true;
    match_ = kit_->clips.find(before_, pose_, dt_s);
    since_match_s_ = 0;
  }
  if (reaction_.phase() == ReactionPhase::over) {
    mover_ = match_ ? Mover::reaction_clip : Mover::character;
  }
}

void ReactingCharacter::follow_clip(float dt_s) noexcept {
  since_match_s_ += dt_s;
  const motion::Clip& clip = library_->clips().clips[static_cast<std::size_t>(match_->clip)];
  pose_ = pose_of(clip, *match_, since_match_s_);
  if (match_->time_s + since_match_s_ < clip.motion.duration_s()) return;
  stand_as_shown(dt_s);
  match_.reset();
  mover_ = Mover::character;
}

void ReactingCharacter::stand_as_shown(float dt_s) noexcept {
  character_.stand_in(before_, pose_, dt_s);
  character_.settle();
}

void ReactingCharacter::stop() noexcept {
  mover_ = Mover::character;
  match_.reset();
  pose_ = character_.pose();
  before_ = pose_;
}

std::optional<int> ReactingCharacter::reaction_clip() const noexcept {
  if (!match_) return std::nullopt;
  return match_->clip;
}

}  // namespace flinch::reaction
