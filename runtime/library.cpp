// SPDX-License-Identifier: MIT
#include "runtime/library.h"

#include <new>
#include <utility>
#include <vector>

#include "runtime/selector_file.h"
#include "runtime/workspace.h"

namespace flinch::runtime {

using database::LoadStatus;

LoadStatus Library::load(std::span<const std::byte> bytes) noexcept try {
  SelectorFile file;
  const LoadStatus status = read_selector_file(bytes, file);
  if (status != LoadStatus::ok) return status;
  if (!file.library) return LoadStatus::without_clips;
  auto contents = std::make_unique<Contents>();
  contents->clips = std::move(*file.library);
  contents->selector = std::move(file.selector);
  contents->prepared = prepare(contents->clips);
  contents->selection_bytes = runtime::selection_bytes(contents->selector);
  contents_ = std::move(contents);
  return LoadStatus::ok;
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

LoadStatus Library::load(const std::string& path) noexcept {
  std::vector<std::byte> bytes;
  const LoadStatus status = database::read_bytes(path, bytes);
  return status == LoadStatus::ok ? load(bytes) : status;
}

}  // namespace flinch::runtime
