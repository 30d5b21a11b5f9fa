// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "database/library/library.h"
#include "database/library/load_status.h"

namespace flinch::models {
struct Selector;
}

namespace flinch::runtime {

/// A library with what responses need to know of it. Opaque to games.
struct PreparedLibrary;
/// The recorded responses to pushes, and how a push is answered with them. Opaque to games.
struct PushResponses;
struct PushModel;
/// Which moments of a library's everyday clips can follow each other. Opaque to games.
struct MotionGraph;

/// What a game loads, once for all characters of one kind: a selector with its clips, from one file
/// that `flinch train` writes, or from two. Immutable after loading, so any number of characters
/// and threads may share one. It must outlive its characters. Moving it moves nothing that its
/// accessors return.
class Library {
 public:
  /// Empty: load() fills it.
  Library() noexcept;
  ~Library();
  Library(Library&&) noexcept;
  Library& operator=(Library&&) noexcept;

  /// Loads a selector file that holds its clips. Verifies the whole file before it uses any of it.
  /// On failure returns why and leaves the library as it was; on success replaces what was loaded
  /// before. Allocates; throws nothing.
  database::LoadStatus load(const std::string& path) noexcept;
  /// The same from the file's bytes, which are not needed afterwards.
  database::LoadStatus load(std::span<const std::byte> bytes) noexcept;

  /// Loads a selector file for the clips of `owner`, which both share from then on: so selectors
  /// that `flinch train --without-clips` writes play from one library, in memory and on disk. The
  /// file's own clips, if it has any, are verified and not kept. Returns LoadStatus::other_library
  /// unless the selector names the hash of the owner's library. `owner` is loaded, and need not
  /// live on.
  database::LoadStatus load(const std::string& path, const Library& owner) noexcept;
  database::LoadStatus load(std::span<const std::byte> bytes, const Library& owner) noexcept;

  /// Takes clips without a selector: its characters answer by rule (Character::brace) or as they
  /// are told (Character::respond). Allocates; throws nothing.
  database::LoadStatus take(database::ClipLibrary clips) noexcept;
  /// The same from a library's file (FILE.flinchlib).
  database::LoadStatus take(const std::string& path) noexcept;

  /// Whether a file was loaded. The functions below are for loaded libraries only.
  bool is_loaded() const noexcept { return contents_ != nullptr; }

  /// The character's skeleton and mass, and all clips with their names and annotations.
  const database::ClipLibrary& clip_library() const noexcept;
  /// The model that chooses the clips. Opaque to games.
  const models::Selector& selector() const noexcept;
  /// What make_response() takes.
  const PreparedLibrary& prepared() const noexcept;
  /// What Character::push() asks: the clips with a push, and the realism of what they could become.
  const PushResponses& push_responses() const noexcept;
  const PushModel& push_model() const noexcept;
  /// The memory that a Workspace needs for this library, bytes.
  std::size_t selection_bytes() const noexcept;

 private:
  struct Clips;
  struct Contents;
  void keep(std::shared_ptr<const Clips> clips, models::Selector selector);

  std::unique_ptr<const Contents> contents_;
};

}  // namespace flinch::runtime
