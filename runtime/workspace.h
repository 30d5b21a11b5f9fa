// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "database/library/file_header.h"
#include "models/selector.h"

namespace flinch::runtime {

/// The most memory that a selection by this selector takes, bytes. Measured: the selector is asked
/// once for each target, which is all that it depends on. Allocates.
std::size_t selection_bytes(const models::Selector& selector);

enum class SelectStatus : std::uint8_t {
  ok,
  too_small,  ///< the workspace was made for a selector that takes less
};

/// What a selector chose.
struct Selection {
  SelectStatus status = SelectStatus::too_small;
  int clip = 0;           ///< the library's index; 0 unless ok
  std::size_t count = 0;  ///< of candidates written
};

/// The memory that selections are made in, so that they allocate nothing. It keeps nothing from one
/// selection to the next; any number of characters that take turns may share one, threads may not.
class Workspace {
 public:
  /// Makes room for every selection by a selector of this many selection_bytes(). Allocates. On
  /// failure, out_of_memory, it is left as it was.
  database::LoadStatus reserve_memory(std::size_t bytes) noexcept;

  /// models::candidates(): the first of them are written to `best`, best first, as many as there
  /// are or as it holds. Neither allocates nor throws.
  Selection select(const models::Selector& selector, const features::FeatureVector& x,
                   motion::Target threatened, std::span<models::Candidate> best) noexcept;

 private:
  std::vector<std::byte> memory_;
};

}  // namespace flinch::runtime
