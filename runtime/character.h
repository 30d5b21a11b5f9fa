// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "models/candidate.h"
#include "runtime/library.h"
#include "runtime/perception.h"
#include "runtime/response/response.h"
#include "runtime/workspace.h"

namespace flinch::runtime {

/// What a call did, or why it did nothing. A call that fails changes nothing.
enum class Status : std::uint8_t {
  ok,
  misses,           ///< the threat will hit nothing: there is nothing to answer
  unnoticed,        ///< it escaped the character's perception (PerceptionLimits)
  not_loaded,       ///< the library has no content
  other_workspace,  ///< made for a selector that takes less memory
  bad_clip,         ///< no such clip, or one without an annotation
  bad_threat,       ///< a number that is not finite, or a time that is not positive
  bad_time,         ///< a step of time that is not positive and finite
  bad_pose,         ///< a pose with a number that is not finite or a rotation that is not unit
  bad_placement,    ///< a place or direction that is not finite
};
/// What it means, for people; never null.
const char* message_of(Status status) noexcept;

/// What a character is doing.
enum class Phase : std::uint8_t {
  idle,        ///< nothing answers anything
  reacting,    ///< it has perceived, and the delay of its reaction runs
  waiting,     ///< it knows its answer, and there is time yet
  shifting,    ///< shifts its weight before the clip begins
  blending,    ///< goes over into the clip
  protecting,  ///< plays the clip
  returning,   ///< on the way back to idle
};
const char* name_of(Phase phase) noexcept;

/// Which joints move by Flinch and which as the game has them.
struct Mask {
  float weight = 1;  ///< of everything, 0 to 1
  /// Of each joint, 0 to 1; the pelvis' is that of the whole body's place too.
  motion::PerRole<float> joint = whole_body();

  static motion::PerRole<float> whole_body();
};

/// One character: perceives threats, answers with clips of its library, and comes back to idle.
///
/// A plain value of a fixed size that refers to its library, which must outlive it; copy it to save
/// its state. Allocates nothing, throws nothing, reads no clock, draws no chance but from the seed
/// of its limits. The world has Z up and the ground at 0.
class Character {
 public:
  /// Stands idling at the world's origin, facing +X.
  explicit Character(const Library& library) noexcept;

  /// Where it stands and which way it faces, radians; `idle_time_s` into its idle clip. Ends any
  /// response. All of them within features::kMaxExtent.
  Status place(const Eigen::Vector2f& position, float facing, float idle_time_s) noexcept;

  /// Tells it that it does not idle but is in a motion of the game's: its pose now and `dt_s` ago
  /// (at least 1e-4 s), world. The next response starts from there with these velocities. Ends any
  /// response; call it in each frame before `perceive` for as long as the game moves the character
  /// itself.
  Status set_pose(const motion::Pose& before, const motion::Pose& now, float dt_s) noexcept;

  /// Goes back to idle from what it is doing, feet and all.
  Status settle() noexcept;

  /// Limits what it notices. The seed makes characters differ; each threat draws its own number.
  void limit_perception(const PerceptionLimits& limits, std::uint64_t seed) noexcept;

  /// A threat of which only place and velocity are known. Predicts whether, when and where it will
  /// hit if the character goes on as it is, and answers. `workspace` is of the same library and
  /// used by one thread at a time.
  Status perceive(const features::Threat& threat, Workspace& workspace) noexcept;

  /// A threat that the game knows to aim at `target` and to be there in `time_to_impact_s`, at most
  /// features::kMaxHorizon_s.
  Status perceive(const features::Threat& threat, motion::Target target, float time_to_impact_s,
                  Workspace& workspace) noexcept;

  /// Answers with this clip, whatever the selector would say: for games that choose themselves
  /// among `candidates`, and for the trainer's twin.
  Status respond(int clip, float time_to_impact_s) noexcept;

  /// Lets `dt_s` pass.
  Status update(float dt_s) noexcept;

  /// The pose now, world.
  motion::Pose pose() const noexcept;
  /// The game's own pose with Flinch's over it where the mask says so.
  motion::Pose pose_over(const motion::Pose& game, const Mask& mask) const noexcept;

  Phase phase() const noexcept;
  /// Index in the library of the clip that answers; of the idle clip where none does.
  int clip() const noexcept;
  /// What the selector considered for the last threat, best first; at most kMaxCandidates.
  std::span<const models::Candidate> candidates() const noexcept;
  /// Until the impact that is being answered, s; negative after it; infinity where there is none.
  float time_to_impact_s() const noexcept;
  motion::Target target() const noexcept { return target_; }
  /// Where it stands, or began its response.
  const features::CharacterState& state() const noexcept { return state_; }
  /// The response that is played, and how long it has been; invalid where none is.
  const Response& response() const noexcept { return response_; }
  float response_time_s() const noexcept { return static_cast<float>(time_s_); }

  static constexpr std::size_t kMaxCandidates = 8;

 private:
  bool is_responding() const noexcept;
  bool is_settling() const noexcept;
  motion::Pose pose_after(float time_s) const noexcept;
  features::CharacterState current_state() const noexcept;
  Inertialization current_inertialization(const features::CharacterState& state) const noexcept;
  Status answer(const features::Scenario& scenario, float delay_s, Workspace& workspace) noexcept;
  Status begin(int clip, float time_to_impact_s) noexcept;
  void finish() noexcept;

  const Library* library_;
  features::CharacterState state_;  ///< as it was at `time_s_` 0
  double time_s_ = 0;               ///< of idling, or of the response while it plays
  Response response_;
  Inertialization inertialization_;  ///< of the next response, if the game has said so
  PerceptionLimits limits_;
  std::uint64_t seed_ = 0;
  std::uint64_t threats_ = 0;  ///< perceived so far
  double time_to_impact_s_ = std::numeric_limits<double>::infinity();
  motion::Target target_ = motion::Target::head;
  std::array<models::Candidate, kMaxCandidates> candidates_{};
  std::size_t candidate_count_ = 0;
  std::optional<int> delayed_clip_;  ///< the answer that waits for the reaction's delay
  double delay_s_ = 0;               ///< that is left of it
};

}  // namespace flinch::runtime
