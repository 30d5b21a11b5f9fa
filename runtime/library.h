// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "database/library/library_file.h"
#include "models/selector.h"
#include "runtime/response/prepared_library.h"

namespace flinch::runtime {

/// What a game loads, once for all characters of one kind: a selector with its clips, from one
/// file. Immutable after loading: any number of characters and threads share one, and it must
/// outlive them. What its accessors refer to stays where it is when the library is moved.
class Library {
 public:
  /// Loads a selector file that has its clips in it. All of it is verified before anything is
  /// used; see read_selector_file(). A selector without clips is refused as `without_clips`. On
  /// failure the library is left as it was; on success what was loaded before is gone. Allocates.
  database::LoadStatus load(const std::string& path) noexcept;
  /// The same from the file's bytes, which are not needed afterwards.
  database::LoadStatus load(std::span<const std::byte> bytes) noexcept;

  /// Whether anything was loaded; what follows is for loaded libraries only.
  bool is_loaded() const { return contents_ != nullptr; }

  const database::ClipLibrary& clip_library() const { return contents_->clips; }
  const models::Selector& selector() const { return contents_->selector; }
  const PreparedLibrary& prepared() const { return contents_->prepared; }
  /// What a Workspace needs for this selector, bytes.
  std::size_t selection_bytes() const { return contents_->selection_bytes; }

 private:
  struct Contents {
    database::ClipLibrary clips;
    models::Selector selector;
    PreparedLibrary prepared;  // refers to `clips`
    std::size_t selection_bytes = 0;
  };
  std::unique_ptr<const Contents> contents_;
};

}  // namespace flinch::runtime
