// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "database/library/file_header.h"

// What the fuzz targets share. Each is a program of libFuzzer, which calls LLVMFuzzerTestOneInput
// with inputs that it grows from the seeds. An input may be refused in any way that a reader
// declares; what is accepted must have the properties that readers promise.
namespace flinch::tests {

/// Ends the program where a property does not hold, so that libFuzzer keeps the input.
inline void require(bool holds, const char* property) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", property);
  std::abort();
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The content with a valid header before it, as an attacker would seal it: the hash is no secret.
inline std::string sealed(const database::FileFormat& format, std::string_view content) {
  const auto header = database::make_file_header(format, database::bytes_of(content));
  std::string file(reinterpret_cast<const char*>(header.data()), header.size());
  return file.append(content);
}

}  // namespace flinch::tests
