// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "runtime/character.h"

namespace flinch::sim {
struct FigureModel;  // opaque
}

namespace flinch::lookahead {

inline constexpr std::size_t kMaxCandidates = 16;  ///< that are looked at for one answer
/// Threats that are looked at at once.
inline constexpr std::size_t kMaxThreats = runtime::Character::kMaxThreats;

/// How long a search may take. It reads no clock of its own.
struct Budget {
  double us = std::numeric_limits<double>::infinity();
  /// Time since any fixed moment, µs, by a clock that does not go back; null: no limit. It must not
  /// throw.
  double (*now_us)(void* clock) = nullptr;
  void* clock = nullptr;  ///< passed to `now_us`
};

/// How far to look ahead.
struct LookAhead {
  /// Number of the selector's best clips to simulate, from 1 to kMaxCandidates; others are clamped.
  int candidates = 8;
  Budget budget = {};
};

/// What is known of a candidate.
enum class Foreseen : std::uint8_t {
  /// The budget ended before it was tried, it is the only one, its response cannot be planned, or
  /// the selector's file does not tell the work of responses from the character's stance.
  nothing,
  costlier,  ///< its work alone costs more than the best; not simulated: its damage is not known
  misses,    ///< no ball comes near it
  simulated,
  /// Given up where its first hit, or its simulation until then, made it costlier than the best:
  /// damage and cost are what was certain by then, no more than it would have cost.
  cut,
};
/// As one word; never null.
const char* name_of(Foreseen foreseen) noexcept;

/// A clip that the selector proposed, and why it was chosen or not. NaN where nothing is known.
struct ForeseenCandidate {
  models::Candidate candidate;
  Foreseen foreseen = Foreseen::nothing;
  float work_j = std::numeric_limits<float>::quiet_NaN();
  float damage_ns = std::numeric_limits<float>::quiet_NaN();  ///< of all threats together
  float cost_ns = std::numeric_limits<float>::quiet_NaN();    ///< as flinch train defines it
  /// Time of the first contact, s after perception; infinite if nothing touches.
  float contact_s = std::numeric_limits<float>::quiet_NaN();
};

/// The result of looking ahead.
struct LookAheadStatus {
  runtime::Status status = runtime::Status::not_loaded;  ///< as of Character::perceive
  std::size_t count = 0;                                 ///< of `candidates`
  /// Of these, those that the budget allowed; 0 if there is only one, or their work is not known.
  std::size_t tried = 0;
  std::size_t encounters = 0;  ///< balls that were simulated
  std::size_t chosen = 0;      ///< index of the answer in `candidates`
  std::size_t threats = 0;     ///< that will hit and were looked at, the most urgent ones
  std::size_t ignored = 0;     ///< that would hit, beyond the first kMaxThreats
  bool is_complete = false;    ///< all candidates were tried
  std::array<ForeseenCandidate, kMaxCandidates> candidates;  ///< in the selector's order
};

/// What all searches in a library share. Never changes: any threads may use it.
struct LookAheadData {
  std::shared_ptr<const sim::FigureModel> figure;  ///< the physical figure
};

/// The data of a loaded library. Null if nothing is loaded, if its selector was trained before
/// files held what clips cost (`flinch train` again), or if memory ran out. Allocates; throws
/// nothing.
std::shared_ptr<const LookAheadData> make_look_ahead_data(const runtime::Library& library) noexcept;

/// Memory for looking ahead in one library, so that searches allocate nothing. One thread may use
/// it at a time; any number of characters take turns.
class LookAheadWorkspace {
 public:
  LookAheadWorkspace() noexcept;
  ~LookAheadWorkspace();
  LookAheadWorkspace(LookAheadWorkspace&&) noexcept;
  LookAheadWorkspace& operator=(LookAheadWorkspace&&) noexcept;

  /// Reserves the memory, at most 256 KiB: `library` must outlive this, and `data` be that of
  /// make_look_ahead_data(). Returns false, and leaves the workspace as it was, if there is no data
  /// or not enough memory. Allocates; throws nothing.
  bool reserve_memory(const runtime::Library& library,
                      std::shared_ptr<const LookAheadData> data) noexcept;
  /// Whether it has memory for the characters of this library.
  bool is_for(const runtime::Library& library) const noexcept;

 private:
  friend class Search;
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// A search for the answer of one character that may be spread over frames: begin() when a threat
/// is perceived, then update() in place of the character's own for as long as is_open(). A plain
/// value of a fixed size. All candidates are planned from the character as it was at begin(), so
/// the answer does not depend on the frames in which they are tried.
class Search {
 public:
  /// `library` is that of the characters, and must outlive this.
  explicit Search(const runtime::Library& library) noexcept;

  /// Perceives the threats, as Character::perceive does one by one, and ranks the clips against
  /// them; tries none. Returns ok, or misses or unnoticed where there is nothing to answer. Other
  /// results refuse all threats and change nothing: bad_threat if one is not usable,
  /// other_workspace if `workspace` has no memory for the character's library. `candidates` as in
  /// LookAhead.
  runtime::Status begin(runtime::Character& character, std::span<const features::Threat> threats,
                        int candidates, LookAheadWorkspace& workspace) noexcept;

  /// The same for threats that `character` has perceived already (Character::notice), or that the
  /// game knows to hit; at most kMaxThreats, any order. bad_threat if there are none, or more, or
  /// if an impact is not above 0 and at most 100 s away.
  runtime::Status begin(const runtime::Character& character,
                        std::span<const runtime::Perception> threats, int candidates,
                        LookAheadWorkspace& workspace) noexcept;
  /// The same with candidates of the caller, the first kMaxCandidates of them; bad_clip if there
  /// are none or if one is not a clip of the library.
  runtime::Status begin(const runtime::Character& character,
                        std::span<const runtime::Perception> threats,
                        std::span<const models::Candidate> candidates,
                        LookAheadWorkspace& workspace) noexcept;

  /// Tries candidates until none is left, or until the budget ends, exceeding it by at most one
  /// encounter. Returns whether none is left.
  bool advance(const Budget& budget, LookAheadWorkspace& workspace) noexcept;

  /// Makes the character answer with the best candidate so far; with the selector's first if none
  /// was tried. Closes the search.
  const LookAheadStatus& finish(runtime::Character& character) noexcept;

  /// A frame of a search that is spread: advance(), then finish() if none is left or if the best so
  /// far would have to move in this frame, then the character's update(dt_s), whose status it
  /// returns.
  runtime::Status update(runtime::Character& character, float dt_s, const Budget& budget,
                         LookAheadWorkspace& workspace) noexcept;

  /// Whether begin() found something to answer that finish() has not answered yet.
  bool is_open() const noexcept { return is_open_; }
  /// What is known so far.
  const LookAheadStatus& status() const noexcept { return status_; }

 private:
  friend LookAheadStatus perceive(runtime::Character& character,
                                  std::span<const features::Threat> threats,
                                  const LookAhead& look_ahead,
                                  LookAheadWorkspace& workspace) noexcept;

  static LookAheadStatus answer_first(runtime::Character& character,
                                      const runtime::Perception& urgent,
                                      LookAheadWorkspace& workspace) noexcept;
  runtime::Status open(const runtime::Character& character,
                       std::span<const runtime::Perception> threats,
                       const LookAheadWorkspace& workspace) noexcept;
  void rank(int candidates, LookAheadWorkspace& workspace) noexcept;
  bool try_candidate(ForeseenCandidate& candidate, const Budget& budget, double end_us,
                     LookAheadWorkspace& workspace) noexcept;

  runtime::Character character_;                            ///< as it was at begin()
  std::array<runtime::Perception, kMaxThreats> threats_{};  ///< the most urgent first
  std::size_t next_ = 0;                                    ///< the next candidate to try
  bool is_open_ = false;
  float elapsed_s_ = 0;       ///< since begin()
  float latest_begin_s_ = 0;  ///< when the best so far has to move, s after begin()
  LookAheadStatus status_;
};

/// The same for a threat that the game knows to hit `perception.scenario.target` in
/// `time_to_impact_s`: begin(), advance() and finish() of a Search at once.
LookAheadStatus perceive(runtime::Character& character, const runtime::Perception& perception,
                         const LookAhead& look_ahead, LookAheadWorkspace& workspace) noexcept;

/// Perceives `threats`, tries the selector's best clips against all of them, and answers with the
/// one that costs least: begin(), advance() and finish() of a Search at once. One threat, or
/// several whose damage adds up for each clip; the clip's peak meets the most urgent one.
LookAheadStatus perceive(runtime::Character& character, std::span<const features::Threat> threats,
                         const LookAhead& look_ahead, LookAheadWorkspace& workspace) noexcept;

}  // namespace flinch::lookahead
