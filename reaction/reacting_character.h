// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "features/threat.h"
#include "reaction/reaction.h"
#include "reaction/reaction_clips.h"
#include "runtime/character.h"

namespace flinch::reaction {

/// What the characters of a library share for their reactions. Make it once after loading; any
/// threads may use it, since it never changes.
struct ReactionData {
  std::shared_ptr<const sim::FigureModel> figure;  ///< the physical figure
  ReactionClips clips;  ///< the clips of purpose `push`, which continue a motion after a hit
};

/// The data of a loaded library, which is not needed afterwards. Null if nothing is loaded or
/// memory ran out. Allocates; throws nothing.
std::shared_ptr<const ReactionData> make_reaction_data(const runtime::Library& library) noexcept;

/// What moves a character's body.
enum class PoseSource : std::uint8_t {
  character,      ///< runtime::Character: it idles or answers a threat
  physics,        ///< Reaction, from react_to() on
  reaction_clip,  ///< the clip that follows physics, until it ends
};
/// The source as one or two words, for people; never null.
const char* name_of(PoseSource pose_source) noexcept;

/// A character that can be hit. runtime::Character moves it until a ball is about to touch it, then
/// physics. After the hit it blends back to runtime::Character, which has gone on meanwhile, or,
/// where the data has a clip that fits the blow and is close to how physics moves the body, to that
/// clip and then to idle. docs/reaction.md explains it.
///
/// One thread at a time may use an object. Nothing throws. After react_to() nothing is allocated
/// (see Reaction).
class ReactingCharacter {
 public:
  /// `library` must be loaded and outlive this. `data` of make_reaction_data().
  ReactingCharacter(const runtime::Library& library, std::shared_ptr<const ReactionData> data,
                    const ReactionOptions& options = {}) noexcept;

  /// The character that anticipates: perceive threats and place it here, but advance time with
  /// update() below.
  runtime::Character& character() noexcept { return character_; }
  const runtime::Character& character() const noexcept { return character_; }

  /// Hands the body to physics, with the pose and velocities that are shown, because `ball` is
  /// about to hit. Call it at the contact or up to 0.3 s before, so that the ball may hit early;
  /// from then on update() moves the ball too. May be called again while physics or a clip moves
  /// the body. Failure changes nothing.
  ReactionStatus react_to(const features::Ball& ball) noexcept;

  /// Advances by `dt_s`: above 0, and at most kMaxReactionFrame_s while physics moves the body.
  /// Failure changes nothing, except for `failed`: the character then goes on without physics.
  ReactionStatus update(float dt_s) noexcept;

  /// Ends physics or its clip at once: runtime::Character moves the body from where it is. Call it
  /// when the game has placed or moved the body itself, for example to help it up after a fall.
  void stop() noexcept;

  /// The current pose, world.
  const motion::Pose& pose() const noexcept { return pose_; }
  /// What moves the body now.
  PoseSource pose_source() const noexcept { return pose_source_; }
  /// The last reaction, with its phase, ball, contact and impulse.
  const Reaction& reaction() const noexcept { return reaction_; }
  /// Index in the library of the clip that moves the body; none while something else does.
  std::optional<int> reaction_clip() const noexcept;

 private:
  void update_from_physics(float dt_s) noexcept;
  void update_from_clip(float dt_s) noexcept;
  Eigen::Vector2f blow_mps() const noexcept;  // velocity that the ball has given to the character
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
