// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/scenes/not_finite.h"

namespace flinch::tests {

/// Changes a FlatBuffer as an attacker would who knows the format: offsets are made to refer to
/// other objects, also many to one, lengths grow and shrink, tables lose fields, numbers become
/// extreme. For try_damaged_content().
class FlatbufferMutation {
 public:
  /// `content` is that of the file that is changed.
  explicit FlatbufferMutation(const std::string& content) {
    // Each number that could be an offset counts as one: most are.
    for (std::size_t at = 0; at + 4 <= content.size(); at += 4) {
      const std::uint32_t offset = number_at(content, at);
      if (offset >= 4 && offset % 4 == 0 && offset < content.size() - at) {
        references_.push_back({at, at + offset});
      }
    }
  }

  void operator()(std::string& content, std::mt19937_64& random) const {
    for (std::uint64_t changes = 1 + random() % 3; changes > 0; --changes) {
      switch (random() % 6) {
        case 0:
          put(content, any_place(content, random), extreme_number(random));
          break;
        case 1:
          redirect(content, random);
          break;
        case 2:
          change_length(content, random);
          break;
        case 3:
          copy_block(content, random);
          break;
        case 4:
          share(content, random);
          break;
        default:
          change_fields(content, random);
      }
    }
  }

 private:
  struct Reference {
    std::size_t from, to;
  };

  static std::uint32_t number_at(const std::string& content, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, content.data() + at, sizeof number);
    return number;
  }

  static void put(std::string& content, std::size_t at, std::uint32_t number) {
    if (at + 4 <= content.size()) std::memcpy(content.data() + at, &number, sizeof number);
  }

  static std::size_t any_place(const std::string& content, std::mt19937_64& random) {
    return random() % (content.size() / 4) * 4;
  }

  static std::uint32_t extreme_number(std::mt19937_64& random) {
    constexpr std::array kFloats{kNan,
                                 kInfinity,
                                 -kInfinity,
                                 std::numeric_limits<float>::max(),
                                 std::numeric_limits<float>::denorm_min(),
                                 1e6F,
                                 -1e3F,
                                 -0.0F,
                                 1.0F};
    constexpr std::array kIntegers{0U, 1U, 4U, 255U, 65536U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU};
    if (random() % 2 == 0) return std::bit_cast<std::uint32_t>(kFloats[random() % kFloats.size()]);
    return kIntegers[random() % kIntegers.size()];
  }

  const Reference& any_reference(std::mt19937_64& random) const {
    return references_[random() % references_.size()];
  }

  void redirect(std::string& content, std::mt19937_64& random) const {
    const std::size_t from = any_reference(random).from;
    put(content, from, static_cast<std::uint32_t>(any_reference(random).to - from));
  }

  void change_length(std::string& content, std::mt19937_64& random) const {
    const std::size_t at = any_reference(random).to;
    if (at + 4 > content.size()) return;
    const std::uint32_t length = number_at(content, at);
    const std::array lengths{0U, length / 2, length - 1, length + 1, length * 2, length * 64};
    put(content, at, lengths[random() % lengths.size()]);
  }

  static void copy_block(std::string& content, std::mt19937_64& random) {
    const std::size_t to = any_place(content, random);
    const std::size_t from = any_place(content, random);
    const std::size_t size =
        std::min<std::size_t>(4 * (1 + random() % 64), content.size() - std::max(from, to));
    std::memmove(content.data() + to, content.data() + from, size);
  }

  /// Makes a run of numbers refer to one object, as elements of a vector of offsets would.
  void share(std::string& content, std::mt19937_64& random) const {
    const std::size_t first = any_reference(random).from;
    const std::size_t target = any_reference(random).to;
    const std::size_t end = first + 4 * (1 + random() % 32);
    for (std::size_t at = first; at < end; at += 4) {
      put(content, at, static_cast<std::uint32_t>(target - at));
    }
  }

  /// Changes one entry of what may be the list of a table's fields.
  void change_fields(std::string& content, std::mt19937_64& random) const {
    const std::size_t table = any_reference(random).to;
    if (table + 4 > content.size()) return;
    const std::size_t fields = table - number_at(content, table);  // a signed offset backwards
    const std::size_t at = fields + 2 * (random() % 8);
    if (at >= content.size() - 1) return;
    content[at] = static_cast<char>(random() % 2 == 0 ? 0 : random() % 64);
    content[at + 1] = 0;
  }

  std::vector<Reference> references_;
};

}  // namespace flinch::tests
