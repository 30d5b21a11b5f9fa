// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace flinch::database {

/// What an accessor's elements are, as glTF names them.
enum class GltfElement : std::uint8_t { scalar, vec3, vec4, mat4 };

/// What reads them; the numbers are glTF's.
enum class GltfTarget : std::uint16_t { none = 0, vertices = 34962, indices = 34963 };

/// The binary part of a glTF 2.0 file and the accessors that lead into it. Numbers are written
/// little endian whatever the machine; every accessor has its own view, which begins at a multiple
/// of 4 bytes. Each `add` returns the index of the accessor that it made.
class GltfBuffer {
 public:
  /// `numbers` holds the elements' components one after the other. `with_bounds` also writes the
  /// least and greatest of each component.
  int add(std::span<const float> numbers, GltfElement element, GltfTarget target = GltfTarget::none,
          bool with_bounds = false);
  int add(std::span<const std::uint8_t> numbers, GltfElement element, GltfTarget target,
          bool is_normalized);
  /// Indices of vertices: of 16 bits where that is enough, else of 32.
  int add_indices(std::span<const std::uint32_t> indices);

  /// The file: `document` with this buffer's accessors and views, and the bytes. Throws Error when
  /// it would be 4 GiB or more, which the format does not allow.
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
