// SPDX-License-Identifier: MIT
#include "runtime/library.h"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "database/library/file_header.h"
#include "database/library/library_file.h"
#include "models/selector.h"
#include "runtime/push/push_search.h"
#include "runtime/response/prepared_library.h"
#include "runtime/selection.h"
#include "runtime/selector_file.h"

namespace flinch::runtime {

using database::LoadStatus;

struct Library::Clips {
  Clips(database::ClipLibrary&& clips, std::vector<Footwork>&& footwork)
      : library(std::move(clips)), prepared(prepare(library, std::move(footwork))) {}

  const database::ClipLibrary library;
  const PreparedLibrary prepared;  // refers to `library`
};

struct Library::Contents {
  explicit Contents(std::shared_ptr<const Clips> of, models::Selector&& chooser = {})
      : clips(std::move(of)), selector(std::move(chooser)) {}

  std::shared_ptr<const Clips> clips;
  models::Selector selector;
  PushResponses push_responses;  // refer to `clips`
  PushModel push_model;          // refers to `selector`
  std::size_t selection_bytes = 0;
};

Library::Library() noexcept = default;
Library::~Library() = default;
Library::Library(Library&&) noexcept = default;
Library& Library::operator=(Library&&) noexcept = default;

void Library::keep(std::shared_ptr<const Clips> clips, models::Selector selector) {
  auto contents = std::make_unique<Contents>(std::move(clips), std::move(selector));
  contents->push_responses = prepare_push_responses(contents->clips->prepared);
  const std::optional<models::RealismModel>& realism = contents->selector.realism;
  contents->push_model =
      prepare_push_model(contents->push_responses, realism ? &*realism : nullptr);
  contents->selection_bytes =
      std::max(runtime::selection_bytes(contents->selector), contents->push_model.memory_bytes);
  contents_ = std::move(contents);
}

LoadStatus Library::load(std::span<const std::byte> bytes) noexcept try {
  SelectorFile file;
  const LoadStatus status = read_selector_file(bytes, file);
  if (status != LoadStatus::ok) return status;
  if (!file.library) return LoadStatus::without_clips;
  keep(std::make_shared<const Clips>(std::move(*file.library), std::move(file.footwork)),
       std::move(file.selector));
  return LoadStatus::ok;
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

LoadStatus Library::load(std::span<const std::byte> bytes, const Library& owner) noexcept try {
  models::Selector selector;
  const LoadStatus status = read_selector(bytes, selector);
  if (status != LoadStatus::ok) return status;
  if (selector.library_hash != owner.clip_library().hash) return LoadStatus::other_library;
  if (!is_compatible(selector, owner.clip_library())) return LoadStatus::damaged;
  keep(owner.contents_->clips, std::move(selector));
  return LoadStatus::ok;
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

LoadStatus Library::take(database::ClipLibrary clips) noexcept try {
  contents_ = std::make_unique<const Contents>(
      std::make_shared<const Clips>(std::move(clips), std::vector<Footwork>()));
  return LoadStatus::ok;
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

LoadStatus Library::take(const std::string& path) noexcept {
  database::ClipLibrary clips;
  const LoadStatus status = database::read_library(path, clips);
  return status == LoadStatus::ok ? take(std::move(clips)) : status;
}

LoadStatus Library::load(const std::string& path) noexcept {
  std::vector<std::byte> bytes;
  const LoadStatus status = database::read_bytes(path, bytes);
  return status == LoadStatus::ok ? load(bytes) : status;
}

LoadStatus Library::load(const std::string& path, const Library& owner) noexcept {
  std::vector<std::byte> bytes;
  const LoadStatus status = database::read_bytes(path, bytes);
  return status == LoadStatus::ok ? load(bytes, owner) : status;
}

const database::ClipLibrary& Library::clip_library() const noexcept {
  return contents_->clips->library;
}

const models::Selector& Library::selector() const noexcept {
  return contents_->selector;
}

const PreparedLibrary& Library::prepared() const noexcept {
  return contents_->clips->prepared;
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
