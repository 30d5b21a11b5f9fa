// SPDX-License-Identifier: MIT
#include "database/library/bare_hash.h"

#include <bit>
#include <string>

#include "database/library/content_hash.h"
#include "library_generated.h"

namespace flinch::database {
namespace {

static_assert(std::endian::native == std::endian::little, "FlatBuffers are written in place");

/// A part of a FlatBuffer, by its distance from the end.
using FromEnd = std::uint32_t;

/// Bytes of a FlatBuffer of a size, from the front on.
class Writer {
 public:
  explicit Writer(std::size_t size) : size_(size) { bytes_.reserve(size); }

  template <class Number>
  void put(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  /// References are relative to where they stand.
  void refer(FromEnd part) { put(static_cast<std::uint32_t>(size_ - bytes_.size()) - part); }
  void append(std::string_view bytes) { bytes_ += bytes; }
  std::string_view bytes() const { return bytes_; }

 private:
  std::size_t size_;
  std::string bytes_;
};

}  // namespace

// FlatBuffers are written from their end: name, character and clips, then the provenance, then the
// table that refers to them. References are relative, so the first three are the same bytes in a
// file without provenance, before which stand
//
//     24, "FLIB", 0                              4 + 4 + 2 bytes
//     the sizes of what follows, the places      7 * 2 bytes
//       of the table's fields; 0: left out
//     14, name, character, rate_hz, idle, clips  4 bytes each; idle is left out if it is 0
//
// without FlatBufferBuilder, which would weigh as much as all that reads libraries.
std::optional<std::uint64_t> bare_hash_of(const schema::Library& stored,
                                          std::span<const std::byte> content) {
  const auto* const begin = reinterpret_cast<const char*>(content.data());
  const auto from_end = [&](const auto* part) {
    return static_cast<FromEnd>(begin + content.size() - reinterpret_cast<const char*>(part));
  };
  const FromEnd clips = from_end(stored.clips());
  const FromEnd name = from_end(stored.name());
  const FromEnd character = from_end(stored.character());
  if (name > clips || character > clips) return std::nullopt;
  const bool has_idle = stored.idle() != 0;
  const int table_size = has_idle ? 24 : 20;
  Writer bare(24 + static_cast<std::size_t>(table_size) + clips);
  bare.put(std::uint32_t{24});
  bare.append(schema::LibraryIdentifier());
  bare.put(std::uint16_t{0});
  for (const int number : {14, table_size, 4, 8, 12, has_idle ? 16 : 0, table_size - 4})
    bare.put(static_cast<std::uint16_t>(number));
  bare.put(std::int32_t{14});
  bare.refer(name);
  bare.refer(character);
  bare.put(stored.rate_hz());
  if (has_idle) bare.put(stored.idle());
  bare.refer(clips);
  bare.append({begin + content.size() - clips, clips});
  return content_hash(std::as_bytes(std::span(bare.bytes())));
}

}  // namespace flinch::database
