// SPDX-License-Identifier: MIT
#pragma once

#include <flatbuffers/flatbuffers.h>

#include <cstddef>
#include <cstdint>

namespace flinch::database {

/// Counts the bytes that reading makes of a file's vectors and texts, before any is copied.
///
/// FlatBuffers lets many offsets refer to the same vector, so the copies of a small file could take
/// gigabytes. Our writers share nothing: what a file of ours unfolds to is never larger than its
/// content, and readers refuse everything else.
class UnfoldedSize {
 public:
  template <class T>
  UnfoldedSize& add(const flatbuffers::Vector<T>* stored) {
    if (stored != nullptr) bytes_ += std::uint64_t{stored->size()} * sizeof(T);
    return *this;
  }
  UnfoldedSize& add(const flatbuffers::String* stored) {
    if (stored != nullptr) bytes_ += stored->size();
    return *this;
  }

  bool is_within(std::size_t content_size) const { return bytes_ <= content_size; }

 private:
  std::uint64_t bytes_ = 0;  ///< cannot overflow: at most a million tables of vectors below 2 GiB
};

}  // namespace flinch::database
