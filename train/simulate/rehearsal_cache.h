// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "train/simulate/trial.h"

namespace flinch::train {

/// Keeps rehearsed responses for later scenarios, as far as memory allows. Keeps the first ones:
/// all responses are requested equally often and in the same order, so evicting one for the newest
/// would only lose the one that is needed next. A response that is not kept is rehearsed again on
/// request, with the same result.
class RehearsalCache {
 public:
  explicit RehearsalCache(std::uint64_t max_bytes) : max_bytes_(max_bytes) {}

  /// Returns the kept response, or nothing. Any thread may call this.
  std::shared_ptr<const RehearsedResponse> find(const ResponseKey& key) const;
  /// Keeps a response that is not kept yet, if there is room for it.
  void insert(std::shared_ptr<const RehearsedResponse> response);

  std::uint64_t byte_count() const;

 private:
  mutable std::mutex mutex_;
  std::map<ResponseKey, std::shared_ptr<const RehearsedResponse>> entries_;
  std::uint64_t max_bytes_;
  std::uint64_t bytes_ = 0;
};

}  // namespace flinch::train
