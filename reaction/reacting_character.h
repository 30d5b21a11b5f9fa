// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "features/threat.h"
#include "reaction/reaction.h"
#include "reaction/reaction_clips.h"
#include "runtime/character.h"

namespace flinch::reaction {

/// What a library's characters react with: their physical figure, and their clips of purpose `push`
/// to go on with after a blow. Made once after loading, shared on any threads, never changes.
struct ReactionData {
  std::shared_ptr<const sim::FigureModel> figure;
  ReactionClips clips;
};

/// Of a loaded library, which is not needed afterwards. Nothing if memory ran out or nothing is
/// loaded.
std::shared_ptr<const ReactionData> make_reaction_data(const runtime::Library& library) noexcept;

/// The ball that a threat is, as it flies when `threat` holds: features::advanced tells of later.
sim::Ball ball_of(const features::Threat& threat) noexcept;

/// Who moves a character's body.
enum class PoseSource : std::uint8_t {
  character,      ///< runtime::Character: it idles, or answers a threat
  physics,        ///< Reaction: from react_to() on
  reaction_clip,  ///< the clip that physics gave it back to, until it is over
};
const char* name_of(PoseSource pose_source) noexcept;

/// A character that can be hit: runtime::Character until a ball is about to touch it, physics then,
/// and after the double blend runtime::Character again, which has gone on meanwhile; or, where
/// the kit has a clip near enough to how physics moves it, that clip, and then idle.
/// docs/reaction.md tells how and why.
///
/// One object must not be called by two threads at a time. Nothing throws; after react_to, nothing
/// of ours allocates.
class ReactingCharacter {
 public:
  /// The library must be loaded and outlive this.
  ReactingCharacter(const runtime::Library& library, std::shared_ptr<const ReactionData> data,
                    const ReactionOptions& options = {}) noexcept;

  /// What anticipates: threats are perceived and places set here, and time passes in update().
  runtime::Character& character() noexcept { return character_; }
  const runtime::Character& character() const noexcept { return character_; }

  /// A ball is about to hit: physics takes the body over, with the pose and the velocities that
  /// are shown. At the contact, or up to 0.3 s before it, which lets a ball hit early; then update
  /// moves the ball too. Also while physics or a clip moves the body. Failure changes nothing.
  ReactionStatus react_to(const sim::Ball& ball) noexcept;

  /// Lets `dt_s` pass: above 0, and at most kMaxReactionFrame_s while physics moves the body.
  /// Failure changes nothing, but for `failed`: then the character goes on without physics.
  ReactionStatus update(float dt_s) noexcept;

  /// The character has its body, where it is, at once: to be called when the game has placed it or
  /// has moved it itself, as one that was knocked over and helped up.
  void stop() noexcept;

  /// The pose now, world.
  const motion::Pose& pose() const noexcept { return pose_; }
  PoseSource pose_source() const noexcept { return pose_source_; }
  /// The last reaction: its phase, ball, contact and impulse.
  const Reaction& reaction() const noexcept { return reaction_; }
  /// Index in the library of the clip that the body was given back to, until that is over.
  std::optional<int> reaction_clip() const noexcept;

 private:
  void update_from_physics(float dt_s) noexcept;
  void update_from_clip(float dt_s) noexcept;
  void resume_from_shown_pose(float dt_s) noexcept;

  const runtime::Library* library_;
  std::shared_ptr<const ReactionData> data_;
  runtime::Character character_;
  Reaction reaction_;
  PoseSource pose_source_ = PoseSource::character;
  ReactionStatus status_ = ReactionStatus::ok;  ///< of the last step of physics
  bool has_searched_ = false;                   ///< for a clip, in this reaction
  std::optional<ReactionMatch> match_;
  float match_age_s_ = 0;
  motion::Pose pose_;
  motion::Pose before_;  ///< shown `step_s_` before it
  float step_s_ = 1.0F / 60;
};

}  // namespace flinch::reaction
