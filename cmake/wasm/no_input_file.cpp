// SPDX-License-Identifier: MIT
// WebAssembly has no files: a page passes a file's bytes.
#include "database/library/input_file.h"

namespace flinch::database {

LoadStatus read_bytes(const std::string& /*path*/, std::vector<std::byte>& /*bytes*/) noexcept {
  return LoadStatus::cannot_open;
}

LoadStatus read_bytes(const std::string& /*path*/, std::string& /*bytes*/) noexcept {
  return LoadStatus::cannot_open;
}

LoadStatus read_first_bytes(const std::string& /*path*/, std::size_t /*size*/,
                            std::string& /*bytes*/) noexcept {
  return LoadStatus::cannot_open;
}

}  // namespace flinch::database
