// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace flinch::database {

/// Type of an accessor's elements, with glTF's names.
enum class GltfElement : std::uint8_t { scalar, vec3, vec4, mat4 };

/// Use of an accessor, with glTF's numbers.
enum class GltfTarget : std::uint16_t { none = 0, vertices = 34962, indices = 34963 };

/// The binary part of a glTF 2.0 file and the accessors that refer to it. Numbers are written
/// little endian on every machine. Every accessor has its own buffer view, which begins at a
/// multiple of 4 bytes. Each `add` returns the index of the accessor that it made.
class GltfBuffer {
 public:
  /// `numbers` holds the components of one element after another. `with_bounds` also writes the
  /// minimum and maximum of each component.
  int add(std::span<const float> numbers, GltfElement element, GltfTarget target = GltfTarget::none,
          bool with_bounds = false);
  int add(std::span<const std::uint8_t> numbers, GltfElement element, GltfTarget target);
  /// Adds vertex indices: 16 bits wide where that is enough, otherwise 32.
  int add_indices(std::span<const std::uint32_t> indices);

  /// Returns the file: `document` with this buffer's accessors and views, and the bytes. Throws
  /// Error when it would be 4 GiB or more, which the format does not allow.
  std::vector<std::byte> file(nlohmann::ordered_json document) const;

 private:
  template <class Number>
  nlohmann::ordered_json& add_accessor(std::span<const Number> numbers, GltfElement element,
                                       GltfTarget target);

  std::vector<std::byte> bytes_;
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
};

}  // namespace flinch::database
