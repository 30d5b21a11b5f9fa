// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "runtime/c/flinch.h"

namespace flinch::tests {

/// Where a sequence takes its choices from: a random generator, or the bytes of a fuzzer.
using Draw = std::function<std::uint32_t()>;

/// Calls of the C interface in any order, with numbers as games have them and numbers that no
/// correct game has, on four characters of one library. After each call it checks that
///
/// - the call was refused where a number is beyond what flinch.h allows, and has then changed
///   nothing: pose, state and candidates are equal bit by bit;
/// - every number of pose and state is finite, and every quaternion unit to 1e-5;
/// - every joint is within its human limits to 0.05 rad, but for characters that the game has
///   moved.
class CallSequence {
 public:
  /// `library` must outlive it.
  CallSequence(flinch_library* library, Draw draw);
  ~CallSequence();
  CallSequence(const CallSequence&) = delete;
  CallSequence& operator=(const CallSequence&) = delete;

  /// Makes one call. Returns false where a property does not hold, which fault() tells.
  bool call();

  /// The first property that did not hold, with the call and the numbers; empty if there is none.
  const std::string& fault() const { return fault_; }
  /// How often calls returned each status.
  const std::map<flinch_status, std::int64_t>& statuses() const { return statuses_; }
  /// The largest excess of a joint's limit so far, radians.
  float max_excess() const { return max_excess_; }
  /// The largest difference of a quaternion's length from 1 so far.
  float max_unit_error() const { return max_unit_error_; }
  /// Of all poses so far, in their order.
  std::uint64_t pose_hash() const { return pose_hash_; }

 private:
  struct Actor {
    flinch_character* character = nullptr;
    bool is_bent = false;  ///< the game has moved it, perhaps as no body moves
  };
  /// All that a caller can see of a character.
  struct Seen {
    flinch_pose pose{};
    flinch_character_state state{};
    std::array<flinch_candidate, FLINCH_MOST_CANDIDATES> candidates{};
    std::int32_t candidate_count = 0;
  };
  enum class Expected : std::uint8_t { answer, refusal, either };
  /// What a call returned, and what it must return.
  struct Outcome {
    flinch_status status = FLINCH_OK;
    Expected expected = Expected::answer;
  };

  std::uint32_t below(std::uint32_t count) { return draw_() % count; }
  std::uint32_t below(std::size_t count) { return below(static_cast<std::uint32_t>(count)); }
  std::uint32_t below(int count) { return below(static_cast<std::uint32_t>(count)); }
  float share();
  /// A number from `min` to `max`, or in an odd call any other.
  float number(float min, float max);
  flinch_threat threat_at(const flinch_character_state& state);

  Outcome update(Actor& actor);
  Outcome perceive(Actor& actor);
  Outcome respond(Actor& actor);
  Outcome place(Actor& actor);
  Outcome set_pose(Actor& actor);
  Outcome settle(Actor& actor);
  Outcome pose_over(Actor& actor);
  Outcome joint_frames(Actor& actor);
  Outcome clip_pose(Actor& actor);
  Outcome copy(Actor& actor);
  Outcome step_by_step(Actor& actor);
  void forge(flinch_perception& perception);
  Outcome limit_perception(Actor& actor);
  Outcome make_anew(Actor& actor);

  static Seen seen_of(const Actor& actor);
  void check(const Actor& actor, const Seen& now);
  void check_numbers(const flinch_pose& pose);
  void fail(const std::string& what, float number);

  flinch_library* library_;
  Draw draw_;
  flinch_library_info info_{};
  flinch_workspace* workspace_ = nullptr;
  std::array<Actor, 4> actors_{};
  bool is_odd_ = false;  ///< whether the call may have numbers that no correct game has
  std::string_view call_name_;
  std::string fault_;
  std::map<flinch_status, std::int64_t> statuses_;
  float max_excess_ = 0;
  float max_unit_error_ = 0;
  std::uint64_t pose_hash_ = 0;
};

}  // namespace flinch::tests
