// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "train/simulate/trial.h"

namespace flinch::train {

/// Keeps responses that were rehearsed, as far as memory allows, for scenarios to come. The first
/// ones stay: all are asked for equally often and in the same order, so that making room for the
/// last one would only drop the next. What is not kept is rehearsed again when it is asked for,
/// with the same result.
class RehearsalCache {
 public:
  explicit RehearsalCache(std::uint64_t max_bytes) : max_bytes_(max_bytes) {}

  /// The kept one, or nothing. Any thread may ask.
  std::shared_ptr<const RehearsedResponse> find(const ResponseKey& key) const;
  /// Keeps one that is not there yet if there is room for it.
  void insert(std::shared_ptr<const RehearsedResponse> response);

  std::uint64_t byte_count() const;

 private:
  mutable std::mutex mutex_;
  std::map<ResponseKey, std::shared_ptr<const RehearsedResponse>> entries_;
  std::uint64_t max_bytes_;
  std::uint64_t bytes_ = 0;
};

}  // namespace flinch::train
