// SPDX-License-Identifier: MIT
#include "train/simulate/rehearsal_cache.h"

namespace flinch::train {

std::shared_ptr<const RehearsedResponse> RehearsalCache::find(const ResponseKey& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(key);
  return found == entries_.end() ? nullptr : found->second;
}

void RehearsalCache::insert(std::shared_ptr<const RehearsedResponse> response) {
  const std::lock_guard lock(mutex_);
  const std::uint64_t bytes = response->byte_count();
  if (bytes_ + bytes > max_bytes_) return;
  const ResponseKey key = response->key;
  if (entries_.emplace(key, std::move(response)).second) bytes_ += bytes;
}

std::uint64_t RehearsalCache::byte_count() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace flinch::train
