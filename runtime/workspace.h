// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "database/library/load_status.h"

namespace flinch::runtime {

/// The memory in which characters choose their clips, so that choosing allocates nothing. It keeps
/// nothing from one choice to the next: any number of characters may take turns with one workspace,
/// but only one thread may use it at a time. Make one for each thread that perceives.
class Workspace {
 public:
  /// Makes room for every choice by a library of this many Library::selection_bytes(). Allocates.
  /// On failure returns out_of_memory and leaves the workspace as it was.
  database::LoadStatus reserve_memory(std::size_t bytes) noexcept;

  /// The reserved memory. Its contents mean nothing between choices.
  std::span<std::byte> memory() noexcept { return memory_; }

 private:
  std::vector<std::byte> memory_;
};

}  // namespace flinch::runtime
