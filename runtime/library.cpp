// SPDX-License-Identifier: MIT
#include "runtime/library.h"

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

#include "database/library/file_header.h"
#include "models/selector.h"
#include "runtime/push/push_search.h"
#include "runtime/response/prepared_library.h"
#include "runtime/selection.h"
#include "runtime/selector_file.h"

namespace flinch::runtime {

using database::LoadStatus;

struct Library::Contents {
  database::ClipLibrary clips;
  models::Selector selector;
  PreparedLibrary prepared;      // refers to `clips`
  PushResponses push_responses;  // refer to `prepared`
  PushModel push_model;          // refers to `selector`
  std::size_t selection_bytes = 0;
};

Library::Library() noexcept = default;
Library::~Library() = default;
Library::Library(Library&&) noexcept = default;
Library& Library::operator=(Library&&) noexcept = default;

LoadStatus Library::load(std::span<const std::byte> bytes) noexcept try {
  SelectorFile file;
  const LoadStatus status = read_selector_file(bytes, file);
  if (status != LoadStatus::ok) return status;
  if (!file.library) return LoadStatus::without_clips;
  auto contents = std::make_unique<Contents>();
  contents->clips = std::move(*file.library);
  contents->selector = std::move(file.selector);
  contents->prepared = prepare(contents->clips, std::move(file.footwork));
  contents->push_responses = prepare_push_responses(contents->prepared);
  const std::optional<models::RealismModel>& realism = contents->selector.realism;
  contents->push_model =
      prepare_push_model(contents->push_responses, realism ? &*realism : nullptr);
  contents->selection_bytes =
      std::max(runtime::selection_bytes(contents->selector), contents->push_model.memory_bytes);
  contents_ = std::move(contents);
  return LoadStatus::ok;
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

LoadStatus Library::take(database::ClipLibrary clips) noexcept try {
  auto contents = std::make_unique<Contents>();
  contents->clips = std::move(clips);
  contents->prepared = prepare(contents->clips);
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

const database::ClipLibrary& Library::clip_library() const noexcept {
  return contents_->clips;
}

const models::Selector& Library::selector() const noexcept {
  return contents_->selector;
}

const PreparedLibrary& Library::prepared() const noexcept {
  return contents_->prepared;
}

const PushResponses& Library::push_responses() const noexcept {
  return contents_->push_responses;
}

const PushModel& Library::push_model() const noexcept {
  return contents_->push_model;
}

std::size_t Library::selection_bytes() const noexcept {
  return contents_->selection_bytes;
}

}  // namespace flinch::runtime
