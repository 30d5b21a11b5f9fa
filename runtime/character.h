// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "models/candidate.h"
#include "runtime/library.h"
#include "runtime/perception.h"
#include "runtime/push/push_motion.h"
#include "runtime/response/response.h"
#include "runtime/workspace.h"

namespace flinch::runtime {

/// The longest time step of a character, s.
inline constexpr float kMaxTimeStep_s = 1e6F;

/// The result of a call to a character. A call that fails changes nothing.
enum class Status : std::uint8_t {
  ok,
  misses,           ///< the threat will hit nothing: there is nothing to answer
  unnoticed,        ///< the character did not notice the threat (PerceptionLimits::chance_to_fail)
  not_loaded,       ///< the library is empty, or has no selector
  other_workspace,  ///< the workspace was reserved for a library that needs less memory
  bad_clip,         ///< no such clip, or one without an annotation
  bad_threat,       ///< a threat that is not usable (features::is_usable), or a time out of range
  bad_time,         ///< a time step that is not above 0 and at most kMaxTimeStep_s
  bad_pose,         ///< a number that is not finite, or a rotation that is not unit (to 1 %)
  no_good_answer,   ///< no response to the push would look real: let physics move the body
  without_pushes,   ///< the library has no clip with a push
  without_realism,  ///< the selector has no realism model; `flinch train-realism` adds one
  bad_push,         ///< not one of motion::kPushPlaces, or not 0.05 to 20 m/s
  bad_placement,  ///< a position beyond 1e5 m, a direction or time beyond 1e6, or not finite; or no
                  ///< such stance
};
/// The status in words; never null.
const char* message_of(Status status) noexcept;

/// What a character is doing.
enum class Phase : std::uint8_t {
  idle,        ///< in its stance; answers no threat
  reacting,    ///< has perceived a threat; its reaction delay runs
  waiting,     ///< has chosen a clip; its first movement is still to come
  shifting,    ///< shifts its weight before the clip begins
  blending,    ///< blends from idle into the clip
  protecting,  ///< plays the clip
  returning,   ///< blends back to its stance
  pushed,      ///< plays the response to a push
  walking,     ///< moves about by the motion graph
};
/// The phase as one word, such as "blending"; never null.
const char* name_of(Phase phase) noexcept;

/// A threat that a character has perceived: what its response answers.
struct Perception {
  features::Scenario scenario;  ///< at the moment of perception, with the threat as perceived
  float delay_s = 0;            ///< until the character can act (PerceptionLimits), s
};

/// What a character noticed of several threats.
struct Notice {
  Status status = Status::not_loaded;  ///< ok if `count` is above 0
  std::size_t count = 0;               ///< of threats that will hit and found room
  std::size_t ignored = 0;             ///< of threats that will hit and are less urgent than those
};

/// The graph by which the characters of a loaded library can walk. Make it once after loading; any
/// threads may use it, since it never changes. Refers to the library. Null if nothing is loaded or
/// memory ran out. Allocates; throws nothing; costs some 20 ns per pair of moments, 15 per second
/// of everyday clips.
std::shared_ptr<const MotionGraph> make_motion_graph(const Library& library) noexcept;

/// Where a character that walks keeps to: a circle on the ground.
struct WalkArea {
  Eigen::Vector2f centre = Eigen::Vector2f::Zero();         ///< world, m
  float radius_m = std::numeric_limits<float>::infinity();  ///< infinite: anywhere
};

/// How much of each joint's motion comes from Flinch and how much from the game.
struct Mask {
  float weight = 1;  ///< scales the weights of all joints, 0 to 1
  /// Weight of each joint, 0 (the game's motion) to 1 (Flinch's). The pelvis' weight applies to the
  /// position of the whole body too.
  motion::PerRole<float> joint = whole_body();

  /// A weight of 1 for every joint.
  static motion::PerRole<float> whole_body();
};

/// A character that perceives threats, answers them with clips of its library and returns to idle.
///
/// Each frame: perceive() what was thrown since the last one, update() by the frame's time, and
/// draw pose(). World frame: right-handed, Z up, the ground at z = 0. Units: m, s, radians.
///
/// A plain value of a fixed size that refers to its library, which must outlive it. A copy is a
/// saved state. It allocates nothing, throws nothing and reads no clock. Its only random numbers
/// come from the seed given to limit_perception(), so equal calls give equal bits. One thread at a
/// time may use it.
class Character {
 public:
  /// Idles at the world's origin and faces +X. `library` may be loaded later; until then every call
  /// that needs it returns not_loaded.
  explicit Character(const Library& library) noexcept;

  /// Puts the character at `position`, turned by `facing` (counter-clockwise from +X), at
  /// `idle_time_s` of stance number `stance`; different times make neighbours differ. Ends any
  /// response. Returns bad_placement for a position beyond 1e5 m, a direction or time beyond 1e6, a
  /// number that is not finite, or a stance that the library does not have.
  Status place(const Eigen::Vector2f& position, float facing, float idle_time_s,
               int stance = 0) noexcept;

  /// Reports the pose of a character that the game animates: `now`, and `before`, which it had
  /// `dt_s` earlier (at least 1e-4 s); both in the world. The next response starts from `now` with
  /// these velocities. Ends any response. Call it in each frame before perceive() for as long as
  /// the game animates the character: perceive() takes it to move on as it has on average over
  /// about the last half second.
  Status set_pose(const motion::Pose& before, const motion::Pose& now, float dt_s) noexcept;

  /// The same for a pose that something else, such as physics, has brought the character to: it
  /// goes on walking from there (walk()), if it walked.
  Status move_to(const motion::Pose& before, const motion::Pose& now, float dt_s) noexcept;

  /// Stops the response and returns to its stance smoothly, with steps where the feet need them.
  /// While the character is in its stance it does nothing.
  Status settle() noexcept;

  /// Changes to stance number `stance` smoothly, with steps where the feet need them. Stops any
  /// response. Returns bad_placement for a stance that the library does not have.
  Status change_stance(int stance) noexcept;

  /// Makes perception imperfect. Each threat draws its own numbers from `seed`; characters with
  /// different seeds differ. Limits that are not valid (see is_valid()) count as none.
  void limit_perception(const PerceptionLimits& limits, std::uint64_t seed) noexcept;

  /// Perceives from now on as `other` does: with its limits, seed and count of threats.
  void perceive_as(const Character& other) noexcept;

  /// Answers a falling threat of which only position and velocity are known. Predicts whether, when
  /// and where it will hit if the character goes on as it is; chooses a clip and starts the
  /// response, or its reaction delay. Returns misses or unnoticed where there is nothing to answer.
  /// A later threat replaces the response to an earlier one. `workspace` must have memory for this
  /// library. Costs tens of microseconds.
  Status perceive(const features::Threat& threat, Workspace& workspace) noexcept;

  /// Answers several threats that come at once: the most urgent one first and, when its impact is
  /// over, the next that leaves at least kMinBlend_s, each with the clip that the selector chooses
  /// now. Keeps the kMaxThreats most urgent ones. A threat that is not usable refuses all of them.
  Status perceive(std::span<const features::Threat> threats, Workspace& workspace) noexcept;

  /// Answers a threat that the game knows to hit `target` in `time_to_impact_s` (above 0, at most
  /// 100 s). Predicts nothing; otherwise as above.
  Status perceive(const features::Threat& threat, motion::Target target, float time_to_impact_s,
                  Workspace& workspace) noexcept;

  /// The steps of perceive(), for a choice that looks further than the selector does
  /// (lookahead/look_ahead.h). notice() predicts the impact as perceive() does, and counts as one:
  /// the next threat draws other random numbers. `perception` is set only where the result is ok.
  Status notice(const features::Threat& threat, Perception& perception) noexcept;
  /// The clips that the selector considers for what was noticed, best first: as many as there are,
  /// or as `best` holds. `count` is their number.
  Status rank(const Perception& perception, Workspace& workspace, std::span<models::Candidate> best,
              std::size_t& count) const noexcept;
  /// The response with clip number `clip` that answer() would start if the reaction delay were
  /// over. Its time 0 is the end of the delay. Invalid where there is no such response, or where
  /// the threat arrives before the delay is over.
  Response plan(const Perception& perception, int clip) const noexcept;
  /// Starts that response, or the reaction delay before it. `candidates` are what candidates() will
  /// return; the first kMaxCandidates of them are kept.
  Status answer(const Perception& perception, int clip,
                std::span<const models::Candidate> candidates) noexcept;

  /// notice() of several threats: writes those that will hit, the most urgent first and as many as
  /// find room. A threat that is not usable refuses all of them.
  Notice notice(std::span<const features::Threat> threats,
                std::span<Perception> most_urgent) noexcept;

  /// Answers with clip number `clip`, for games that choose among candidates() themselves. The
  /// clip's peak falls on `time_to_impact_s` from now (above 0, at most 100 s).
  Status respond(int clip, float time_to_impact_s) noexcept;

  /// Answers by the pose rules of Hermens 2006 (runtime/response/brace.h), without a clip and
  /// without a selector: predicts the impact as perceive() does, and braces against it. The library
  /// may be one without a selector (Library::take). `startles`: it flinches first. While it plays,
  /// clip() is kNoClip.
  Status brace(const features::Threat& threat, bool startles = false) noexcept;
  /// The response that brace() would start for what was noticed.
  Response plan_brace(const Perception& perception, bool startles = false) const noexcept;
  /// Answers a push: the joint `place` (one of motion::kPushPlaces) shall move with `velocity`
  /// (world, m/s, 0.05 to 20; its vertical part is ignored) within 0.65 s. Chooses, of the recorded
  /// responses that can be bent to this push (is_faithful()), the one that will look most real, and
  /// starts it from the pose and velocities of now, whatever the character does; that includes the
  /// response to another push. Returns no_good_answer, and changes nothing but push_candidates(),
  /// where none of those has a realism of kGoodRealism. `workspace` as for perceive(). Costs 0.1 to
  /// 0.3 ms.
  Status push(motion::Role place, const Eigen::Vector3f& velocity, Workspace& workspace) noexcept;

  /// From now on the character walks about instead of idling: from clip to clip by the graph of its
  /// library (make_motion_graph()), which must outlive it, at random by `seed`. Whenever it enters
  /// a clip it draws up to 32 exits and takes the first that leads into `area`, or else the one
  /// that leaves it least. It answers threats and pushes as before, and then walks on. place()
  /// moves it along; settle(), change_stance() and set_pose() end the walk. Returns not_loaded for
  /// the graph of another library or one without nodes, bad_placement for an area without a radius
  /// or beyond 1e5 m. Allocates nothing.
  Status walk(const MotionGraph& graph, std::uint64_t seed, const WalkArea& area = {}) noexcept;

  /// Advances the character by `dt_s` (above 0, at most kMaxTimeStep_s), which may differ from
  /// frame to frame.
  Status update(float dt_s) noexcept;

  /// The current pose in the world. The rest pose at the origin while nothing is loaded. Costs one
  /// or two microseconds.
  motion::Pose pose() const noexcept;
  /// The game's pose `game` with Flinch's laid over it by the mask. Weights are clamped to [0, 1];
  /// a weight that is not finite counts as 0.
  motion::Pose pose_over(const motion::Pose& game, const Mask& mask) const noexcept;

  /// Whether it moves about by a motion graph, also while it answers a threat or a push.
  bool walks() const noexcept { return walk_.graph != nullptr; }
  /// The library that it was made with.
  const Library& library() const noexcept { return *library_; }
  /// What the character is doing.
  Phase phase() const noexcept;
  /// Index in the library of the clip that answers, or of the idle clip; kNoClip: by rule.
  int clip() const noexcept;
  /// The clips that the selector considered for the last threat, best first; at most
  /// kMaxCandidates. Valid until the next call to perceive().
  std::span<const models::Candidate> candidates() const noexcept;
  /// The responses that the last push could have had, best first; at most kMaxCandidates. Valid
  /// until the next call to push().
  std::span<const PushCandidate> push_candidates() const noexcept;
  /// The motion that answers a push; its library is null without one.
  const PushMotion& push_motion() const noexcept { return push_; }
  /// Time to the impact that is being answered, s; negative after it; infinite without a threat.
  float time_to_impact_s() const noexcept;
  /// The target of the last threat.
  motion::Target target() const noexcept { return target_; }
  /// Where the character stands; during a response, where it stood when the response began.
  const features::CharacterState& state() const noexcept { return state_; }
  /// The plan of the response that is playing; is_valid() is false of it without one.
  const Response& response() const noexcept { return response_; }
  /// Time since the response began, s; without a response, time spent idling.
  float response_time_s() const noexcept { return static_cast<float>(time_s_); }

  static constexpr std::size_t kMaxCandidates = 8;  ///< candidates kept for each threat
  static constexpr std::size_t kMaxThreats = 8;     ///< that are kept of one perception

 private:
  bool is_responding() const noexcept;
  bool is_settling() const noexcept;
  bool is_in_stance() const noexcept;
  const motion::Loop& current_loop() const noexcept;
  bool is_pushed() const noexcept { return push_.library != nullptr; }
  bool is_walking() const noexcept { return is_pushed() && !is_answering_push_; }
  void begin_push(const PushMotion& motion) noexcept;
  void finish_push(float dt_s) noexcept;
  void walk_on() noexcept;
  void jump_to(std::uint32_t node) noexcept;
  motion::Pose pose_after(float time_s) const noexcept;
  features::CharacterState current_state() const noexcept;
  Inertialization current_inertialization(const features::CharacterState& state) const noexcept;
  Status predict(const features::Threat& threat, Perception& perception) const noexcept;
  Eigen::Vector3f current_drift_mps() const noexcept;
  Status rank_and_answer(const Perception& perception, Workspace& workspace) noexcept;
  Status counted(Status status) noexcept;
  Status begin(int clip, float time_to_impact_s) noexcept;
  void begin(const Response& response) noexcept;
  Status begin(const features::CharacterState& state, const Inertialization& inertialization,
               int clip, float time_to_impact_s) noexcept;
  void answer_next() noexcept;
  void finish() noexcept;
  void remove_periods() noexcept;

  /// The way through a motion graph.
  struct Walk {
    const MotionGraph* graph = nullptr;  ///< none: the character does not walk
    WalkArea area;
    std::uint64_t seed = 0;
    std::uint64_t stays = 0;  ///< in clips so far; each draws its own random numbers
    float leave_s = 0;        ///< when push_ is left, s after it began
    std::uint32_t node = 0;   ///< to which it then jumps
  };
  /// A threat that is answered after the current one.
  struct Waiting {
    int clip = 0;
    motion::Target target = motion::Target::head;
    double time_to_impact_s = 0;
  };

  const Library* library_;
  features::CharacterState state_;  ///< when `time_s_` was 0
  double time_s_ = 0;               ///< of idling, or of the response while it plays
  Response response_;
  Inertialization inertialization_;  ///< of the next response, after set_pose()
  /// Of the pelvis along the ground, a running mean of what set_pose() tells, m/s.
  Eigen::Vector3f drift_mps_ = Eigen::Vector3f::Zero();
  PushMotion push_;  ///< while the character answers a push, or walks
  bool is_answering_push_ = false;
  Walk walk_;
  PerceptionLimits limits_;
  std::uint64_t seed_ = 0;
  std::uint64_t threats_ = 0;  ///< perceived so far; refused ones do not count
  double time_to_impact_s_ = std::numeric_limits<double>::infinity();
  motion::Target target_ = motion::Target::head;
  std::array<models::Candidate, kMaxCandidates> candidates_{};
  std::size_t candidate_count_ = 0;
  std::array<PushCandidate, kMaxCandidates> push_candidates_{};
  std::size_t push_candidate_count_ = 0;
  std::optional<int> delayed_clip_;                 ///< chosen; starts after the reaction delay
  double delay_s_ = 0;                              ///< what is left of the reaction delay
  std::array<Waiting, kMaxThreats - 1> waiting_{};  ///< the most urgent first
  std::size_t waiting_count_ = 0;
};

}  // namespace flinch::runtime
