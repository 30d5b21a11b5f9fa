// SPDX-License-Identifier: MIT
#include "runtime/selection.h"

#include <algorithm>
#include <memory_resource>
#include <new>

namespace flinch::runtime {
namespace {

/// Counts the bytes allocated from it. Like a monotonic_buffer_resource, does not reuse freed
/// memory.
class AllocationMeter : public std::pmr::memory_resource {
 public:
  std::size_t byte_count() const { return byte_count_; }

 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    // Assumes the worst alignment of each allocation, so that the sum is enough wherever the memory
    // starts.
    byte_count_ += bytes + alignment - 1;
    return std::pmr::new_delete_resource()->allocate(bytes, alignment);
  }
  void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
    std::pmr::new_delete_resource()->deallocate(memory, bytes, alignment);
  }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }

  std::size_t byte_count_ = 0;
};

}  // namespace

std::size_t selection_bytes(const models::Selector& selector) {
  std::size_t max_bytes = 0;
  for (const motion::Target target : motion::kTargets) {
    AllocationMeter meter;
    models::candidates(selector, {}, target, &meter);
    max_bytes = std::max(max_bytes, meter.byte_count());
  }
  return max_bytes;
}

Selection select(Workspace& workspace, const models::Selector& selector,
                 const features::FeatureVector& x, motion::Target threatened,
                 std::span<models::Candidate> best) noexcept try {
  const std::span<std::byte> room = workspace.memory();
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size(),
                                             std::pmr::null_memory_resource());
  const auto candidates = models::candidates(selector, x, threatened, &memory, best.size());
  const std::size_t count = std::min(candidates.size(), best.size());
  std::copy_n(candidates.begin(), count, best.begin());
  return {SelectStatus::ok, candidates.front().clip, count};
} catch (const std::bad_alloc&) {
  return {};
}

}  // namespace flinch::runtime
