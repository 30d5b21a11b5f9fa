// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "features/threat.h"
#include "reaction/reaction.h"
#include "runtime/character.h"

namespace flinch::reaction {

/// What the characters of a library share for their reactions. Make it once after loading; any
/// threads may use it, since it never changes.
struct ReactionData {
  std::shared_ptr<const sim::FigureModel> figure;  ///< the physical figure
  /// Whether a recorded response to a push may continue the motion after a hit.
  bool continues_by_clips = true;
};

/// The data of a loaded library, which is not needed afterwards. Null if nothing is loaded or
/// memory ran out. Allocates; throws nothing.
std::shared_ptr<const ReactionData> make_reaction_data(const runtime::Library& library) noexcept;

/// The place of motion::kPushPlaces at which a blow on this body pushes the character: the nearest
/// on the way to the trunk. None for the legs.
std::optional<motion::Role> push_place_of(motion::Body body) noexcept;

/// What moves a character's body.
enum class PoseSource : std::uint8_t {
  character,      ///< runtime::Character: it idles or answers a threat
  physics,        ///< Reaction, from react_to() on
  reaction_clip,  ///< runtime::Character, by the response to a push that follows physics
};
/// The source as one or two words, for people; never null.
const char* name_of(PoseSource pose_source) noexcept;

/// A character that can be hit. runtime::Character moves it until a ball is about to touch it, then
/// physics. After the hit it blends back to runtime::Character, which has gone on meanwhile, or to
/// the recorded response that Character::push() chooses for the blow: at the place that was struck
/// most, with the velocity that the blow gave to the whole body. docs/reaction.md explains it.
///
/// One thread at a time may use an object. Nothing throws. After react_to() nothing is allocated
/// (see Reaction).
class ReactingCharacter {
 public:
  /// `library` must be loaded and outlive this. `data` of make_reaction_data(). Allocates memory
  /// for the choice of a response; without it, none follows a hit.
  ReactingCharacter(const runtime::Library& library, std::shared_ptr<const ReactionData> data,
                    const ReactionOptions& options = {}) noexcept;

  /// The character that anticipates: perceive threats and place it here, but advance time with
  /// update() below. What it begins to answer while the body recovers ends with the recovery if a
  /// reaction clip follows.
  runtime::Character& character() noexcept { return character_; }
  const runtime::Character& character() const noexcept { return character_; }

  /// Hands the body to physics, with the pose and velocities that are shown, because `ball` is
  /// about to hit. Call it at the contact or up to 0.3 s before, so that the ball may hit early;
  /// from then on update() moves the ball too. May be called again while physics or a clip moves
  /// the body. Failure changes nothing.
  ReactionStatus react_to(const features::Ball& ball) noexcept;

  /// Answers a push as runtime::Character::push() does, whatever moves the body. Where no recorded
  /// response would look real, or there is none, physics moves the body (Reaction::begin_push()),
  /// and the result is ok, too: afterwards the character walks on or settles where physics has
  /// brought it, or the reaction's phase says that it was knocked over. A character that lies there
  /// is not pushed: no_good_answer. Without `data` the result is that of Character::push().
  runtime::Status push(motion::Role place, const Eigen::Vector3f& velocity) noexcept;

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
  enum class Cause : std::uint8_t { ball, push };
  void begin_physics(Cause cause) noexcept;
  void update_from_physics(float dt_s) noexcept;
  runtime::Character at_shown_pose() const noexcept;
  runtime::Character pushed_away() const noexcept;
  std::optional<runtime::Character> answer_to_blow() noexcept;
  Eigen::Vector2f blow_mps() const noexcept;  // velocity that the ball has given to the character

  const runtime::Library* library_;
  std::shared_ptr<const ReactionData> data_;
  runtime::Workspace workspace_;
  runtime::Character character_;
  Reaction reaction_;
  PoseSource pose_source_ = PoseSource::character;
  ReactionStatus status_ = ReactionStatus::ok;  ///< of the last step of physics
  Cause cause_ = Cause::ball;                   ///< of this reaction
  bool has_answered_ = false;                   ///< whether it is decided where it leads
  std::optional<runtime::Character> answer_;    ///< that will move the body when physics is over
  motion::Pose pose_;
  motion::Pose before_;  ///< shown `step_s_` before it
  float step_s_ = 1.0F / 60;
};

}  // namespace flinch::reaction
