// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>

#include "lookahead/look_ahead.h"
#include "reaction/reacting_character.h"
#include "runtime/c/c_handle.h"
#include "runtime/c/c_values.h"
#include "runtime/character.h"
#include "runtime/library.h"
#include "runtime/workspace.h"

// What the handles of flinch.h point to.

namespace flinch::runtime {

/// The library's handle and everything made from it share the library.
using SharedLibrary = std::shared_ptr<const Library>;

}  // namespace flinch::runtime

struct flinch_library : flinch::runtime::HandleHeader {
  static constexpr std::uint32_t kMark = 0xF11C0001;
  explicit flinch_library(flinch::runtime::SharedLibrary loaded)
      : HandleHeader(kMark), content(std::move(loaded)) {}

  flinch::runtime::SharedLibrary content;
};

struct flinch_workspace : flinch::runtime::HandleHeader {
  static constexpr std::uint32_t kMark = 0xF11C0002;
  struct Content {
    flinch::runtime::SharedLibrary library;
    flinch::runtime::Workspace workspace;
  };
  explicit flinch_workspace(Content made)
      : HandleHeader(kMark), content(std::make_unique<Content>(std::move(made))) {}

  std::unique_ptr<Content> content;
};

struct flinch_character : flinch::runtime::HandleHeader {
  static constexpr std::uint32_t kMark = 0xF11C0003;
  struct Content {
    flinch::runtime::SharedLibrary library;
    std::variant<flinch::runtime::Character, flinch::reaction::ReactingCharacter> body;
    std::shared_ptr<const flinch::runtime::MotionGraph> graph = nullptr;  ///< of its walk

    flinch::reaction::ReactingCharacter* reacting() {
      return std::get_if<flinch::reaction::ReactingCharacter>(&body);
    }
    flinch::runtime::Character& character() {
      return reacting() != nullptr ? reacting()->character()
                                   : std::get<flinch::runtime::Character>(body);
    }
    flinch::motion::Pose pose() {
      return reacting() != nullptr ? reacting()->pose() : character().pose();
    }
    /// Moves the character by `move`; physics and its clip then no longer move the body.
    template <class Move>
    flinch::runtime::Status moved(const Move& move) {
      const flinch::runtime::Status status = move(character());
      if (status == flinch::runtime::Status::ok && reacting() != nullptr) reacting()->stop();
      return status;
    }
    flinch_status update(float dt_s) {
      return reacting() != nullptr ? flinch::runtime::status_of(reacting()->update(dt_s))
                                   : flinch::runtime::status_of(character().update(dt_s));
    }
  };
  static_assert(sizeof(Content) <= std::size_t{16} * 1024);
  explicit flinch_character(Content made)
      : HandleHeader(kMark), content(std::make_unique<Content>(std::move(made))) {}

  std::unique_ptr<Content> content;
};

struct flinch_motion_graph : flinch::runtime::HandleHeader {
  static constexpr std::uint32_t kMark = 0xF11C0005;
  struct Content {
    flinch::runtime::SharedLibrary library;
    std::shared_ptr<const flinch::runtime::MotionGraph> graph;
  };
  explicit flinch_motion_graph(Content made)
      : HandleHeader(kMark), content(std::make_unique<Content>(std::move(made))) {}

  std::unique_ptr<Content> content;
};

struct flinch_look_ahead : flinch::runtime::HandleHeader {
  static constexpr std::uint32_t kMark = 0xF11C0004;
  struct Content {
    flinch::runtime::SharedLibrary library;
    flinch::lookahead::LookAheadWorkspace workspace;
  };
  explicit flinch_look_ahead(Content made)
      : HandleHeader(kMark), content(std::make_unique<Content>(std::move(made))) {}

  std::unique_ptr<Content> content;
};
