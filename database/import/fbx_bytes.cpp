// SPDX-License-Identifier: MIT
#include "database/import/fbx_bytes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>

#include "database/files/text_encoding.h"

namespace flinch::database {
namespace {

// Classes and names are quoted in text; in binary a text stands after its length.
std::string quoted(const std::string& name) {
  return "\"" + name + "\"";
}

std::vector<std::size_t> places_of(std::string_view bytes, const std::string& mark) {
  std::vector<std::size_t> places;
  for (std::size_t at = bytes.find(mark); at != std::string_view::npos;
       at = bytes.find(mark, at + 1)) {
    places.push_back(at);
  }
  return places;
}

template <class Number>
bool take(std::string_view& bytes, Number& number) {
  if (bytes.size() < sizeof number) return false;
  std::memcpy(&number, bytes.data(), sizeof number);  // FBX and we are little-endian
  bytes.remove_prefix(sizeof number);
  return true;
}

bool take_text_in_quotes(std::string_view& bytes) {
  const std::size_t open = bytes.find_first_not_of(", \t\r\n");
  if (open == std::string_view::npos || bytes[open] != '"') return false;
  const std::size_t close = bytes.find('"', open + 1);
  if (close == std::string_view::npos) return false;
  bytes.remove_prefix(close + 1);
  return true;
}

bool take_text_with_length(std::string_view& bytes) {
  std::uint32_t length = 0;
  if (!bytes.starts_with('S')) return false;
  bytes.remove_prefix(1);
  if (!take(bytes, length) || length > bytes.size()) return false;
  bytes.remove_prefix(length);
  return true;
}

bool take_digits(std::string_view& bytes, double& value) {
  const std::size_t first = bytes.find_first_not_of(", \t\r\n");
  if (first == std::string_view::npos) return false;
  bytes.remove_prefix(first);
  const auto [end, error] = std::from_chars(bytes.data(), bytes.data() + bytes.size(), value);
  if (error != std::errc()) return false;
  bytes.remove_prefix(static_cast<std::size_t>(end - bytes.data()));
  return true;
}

template <class Number>
bool take_as(std::string_view& bytes, double& value) {
  Number number{};
  if (!take(bytes, number)) return false;
  value = static_cast<double>(number);
  return true;
}

bool take_typed(std::string_view& bytes, double& value) {
  if (bytes.empty()) return false;
  const char type = bytes.front();
  bytes.remove_prefix(1);
  switch (type) {
    case 'C':
      return take_as<std::int8_t>(bytes, value);
    case 'Y':
      return take_as<std::int16_t>(bytes, value);
    case 'I':
      return take_as<std::int32_t>(bytes, value);
    case 'L':
      return take_as<std::int64_t>(bytes, value);
    case 'F':
      return take_as<float>(bytes, value);
    case 'D':
      return take_as<double>(bytes, value);
    default:
      return false;
  }
}

// The numbers of a property, of which `bytes` are what follows its name: type, label, flags, then
// one number or three.
std::vector<double> numbers_in(std::string_view bytes, bool is_text) {
  for (int k = 0; k < 3; ++k) {
    if (!(is_text ? take_text_in_quotes(bytes) : take_text_with_length(bytes))) return {};
  }
  std::vector<double> numbers;
  double value = 0;
  while (numbers.size() < 3 && (is_text ? take_digits(bytes, value) : take_typed(bytes, value))) {
    numbers.push_back(value);
  }
  return numbers;
}

// The part before `end` of a binary file's text, of which `rest` more bytes follow.
std::string_view text_before(std::string_view bytes, std::size_t end, std::size_t rest) {
  constexpr std::size_t kHead = 5;  // 'S' and the length
  constexpr std::size_t kMaxName = 256;
  for (std::size_t size = 0; size <= kMaxName && size + kHead <= end; ++size) {
    std::string_view head = bytes.substr(end - size - kHead, kHead);
    if (head.front() != 'S') continue;
    head.remove_prefix(1);
    std::uint32_t length = 0;
    if (take(head, length) && length == size + rest) return bytes.substr(end - size, size);
  }
  return {};
}

/// A place in the file where something is said of rotations.
struct Mention {
  enum class Kind : std::uint8_t { node, order, active, other_turn };
  Kind kind = Kind::node;
  std::string_view name;  ///< of a node
  std::vector<double> numbers;
};
using Mentions = std::map<std::size_t, Mention>;

void add_nodes(std::string_view bytes, Mentions& mentions) {
  const std::string text_mark = "\"Model::";
  for (const std::size_t at : places_of(bytes, text_mark)) {
    const std::string_view name = bytes.substr(at + text_mark.size());
    mentions[at] = {Mention::Kind::node, name.substr(0, name.find('"')), {}};
  }
  const std::string binary_mark("\0\1Model", 7);
  for (const std::size_t at : places_of(bytes, binary_mark)) {
    mentions[at] = {Mention::Kind::node, text_before(bytes, at, binary_mark.size()), {}};
  }
}

void add_properties(std::string_view bytes, Mentions& mentions) {
  constexpr std::array<std::pair<const char*, Mention::Kind>, 4> kNames{
      {{"RotationOrder", Mention::Kind::order},
       {"RotationActive", Mention::Kind::active},
       {"PreRotation", Mention::Kind::other_turn},
       {"PostRotation", Mention::Kind::other_turn}}};
  for (const auto& [name, kind] : kNames) {
    const std::string in_quotes = quoted(name);
    for (const std::size_t at : places_of(bytes, in_quotes))
      mentions[at] = {kind, {}, numbers_in(bytes.substr(at + in_quotes.size()), true)};
    const auto length = static_cast<char>(std::strlen(name));
    const std::string with_length = std::string{'S', length, '\0', '\0', '\0'} + name;
    for (const std::size_t at : places_of(bytes, with_length))
      mentions[at] = {kind, {}, numbers_in(bytes.substr(at + with_length.size()), false)};
  }
}

void apply(const Mention& mention, FbxRotationRules& rules) {
  if (mention.numbers.empty()) return;
  switch (mention.kind) {
    case Mention::Kind::order:
      rules.order = mention.numbers.front();
      break;
    case Mention::Kind::active:
      rules.is_active = mention.numbers.front() != 0;
      break;
    case Mention::Kind::other_turn:
      rules.is_turned_else |= std::ranges::any_of(mention.numbers, [](double x) { return x != 0; });
      break;
    case Mention::Kind::node:
      break;
  }
}

}  // namespace

bool has_animation_layers(std::string_view bytes) {
  const auto count = [&](const std::string& name) {
    return places_of(bytes, "\"" + name + "::").size() +
           places_of(bytes, std::string("\0\1", 2) + name).size();
  };
  return count("AnimLayer") > std::max<std::size_t>(count("AnimStack"), 1);
}

std::vector<FbxRotationRules> fbx_rotation_rules(std::string_view bytes) {
  Mentions mentions;
  add_nodes(bytes, mentions);
  add_properties(bytes, mentions);
  std::vector<FbxRotationRules> all(1);
  for (const auto& [at, mention] : mentions) {
    if (mention.kind == Mention::Kind::node) {
      all.push_back(all.front());
      all.back().name = printable_text(mention.name);
    } else {
      apply(mention, all.back());
    }
  }
  return all;
}

}  // namespace flinch::database
