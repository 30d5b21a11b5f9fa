// SPDX-License-Identifier: MIT
#include "database/export/glb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string>

#include "motion/enum_array.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

using Json = nlohmann::ordered_json;

constexpr motion::EnumArray<GltfElement, std::string_view, 4> kElementNames{"SCALAR", "VEC3",
                                                                            "VEC4", "MAT4"};
constexpr motion::EnumArray<GltfElement, std::size_t, 4> kComponents{1, 3, 4, 16};

// glTF 2.0, 3.6.2.2, table of component types.
constexpr int component_type(std::uint8_t) {
  return 5121;
}
constexpr int component_type(std::uint16_t) {
  return 5123;
}
constexpr int component_type(std::uint32_t) {
  return 5125;
}
constexpr int component_type(float) {
  return 5126;
}

template <class Whole>
void append(Whole number, std::vector<std::byte>& bytes) {
  for (std::size_t i = 0; i < sizeof(Whole); ++i) {
    bytes.push_back(static_cast<std::byte>(number >> 8 * i & 0xFF));
  }
}
void append(float number, std::vector<std::byte>& bytes) {
  append(std::bit_cast<std::uint32_t>(number), bytes);
}

void pad(std::byte with, std::vector<std::byte>& bytes) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
}

// Minimum and maximum of each component.
std::pair<std::vector<float>, std::vector<float>> bounds(std::span<const float> numbers,
                                                         std::size_t components) {
  const std::span<const float> first = numbers.first(components);
  std::vector<float> min(first.begin(), first.end());
  std::vector<float> max = min;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    min[i % components] = std::min(min[i % components], numbers[i]);
    max[i % components] = std::max(max[i % components], numbers[i]);
  }
  return {min, max};
}

void append_chunk(std::string_view type, std::span<const std::byte> chunk,
                  std::vector<std::byte>& bytes) {
  append(static_cast<std::uint32_t>(chunk.size()), bytes);
  for (const char c : type) bytes.push_back(static_cast<std::byte>(c));
  bytes.insert(bytes.end(), chunk.begin(), chunk.end());
}

}  // namespace

template <class Number>
Json& GltfBuffer::add_accessor(std::span<const Number> numbers, GltfElement element,
                               GltfTarget target) {
  pad(std::byte{0}, bytes_);
  Json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", numbers.size_bytes()}};
  if (target != GltfTarget::none) view["target"] = static_cast<int>(target);
  for (const Number number : numbers) append(number, bytes_);
  accessors_.push_back({{"bufferView", views_.size()},
                        {"componentType", component_type(Number{})},
                        {"count", numbers.size() / kComponents[element]},
                        {"type", kElementNames[element]}});
  views_.push_back(std::move(view));
  return accessors_.back();
}

int GltfBuffer::add(std::span<const float> numbers, GltfElement element, GltfTarget target,
                    bool with_bounds) {
  Json& accessor = add_accessor(numbers, element, target);
  if (with_bounds) {
    const auto [min, max] = bounds(numbers, kComponents[element]);
    accessor["min"] = min;
    accessor["max"] = max;
  }
  return static_cast<int>(accessors_.size()) - 1;
}

int GltfBuffer::add(std::span<const std::uint8_t> numbers, GltfElement element, GltfTarget target) {
  add_accessor(numbers, element, target);
  return static_cast<int>(accessors_.size()) - 1;
}

int GltfBuffer::add_indices(std::span<const std::uint32_t> indices) {
  // The largest number of either type is the primitive restart value, which is not allowed.
  const bool is_short = std::all_of(indices.begin(), indices.end(), [](std::uint32_t index) {
    return index < std::numeric_limits<std::uint16_t>::max();
  });
  if (is_short) {
    const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
    add_accessor(std::span<const std::uint16_t>(narrow), GltfElement::scalar, GltfTarget::indices);
  } else {
    add_accessor(indices, GltfElement::scalar, GltfTarget::indices);
  }
  return static_cast<int>(accessors_.size()) - 1;
}

// glTF 2.0, 4.4: a header of 12 bytes, then the JSON chunk padded with spaces and the binary chunk
// padded with zeros, each preceded by its length and type.
std::vector<std::byte> GltfBuffer::file(Json document) const {
  std::vector<std::byte> binary = bytes_;
  pad(std::byte{0}, binary);
  document["accessors"] = accessors_;
  document["bufferViews"] = views_;
  document["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
  std::string text = document.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');

  const std::uint64_t length = 12 + 8 + text.size() + 8 + binary.size();
  if (length > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("", "the motion is too long for glTF, whose files hold at most 4 GiB: shorten it");
  }
  std::vector<std::byte> bytes;
  bytes.reserve(length);
  for (const char c : std::string_view("glTF")) bytes.push_back(static_cast<std::byte>(c));
  append(std::uint32_t{2}, bytes);
  append(static_cast<std::uint32_t>(length), bytes);
  append_chunk("JSON", std::as_bytes(std::span(text)), bytes);
  append_chunk(std::string_view("BIN\0", 4), binary, bytes);
  return bytes;
}

}  // namespace flinch::database
