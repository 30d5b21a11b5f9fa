// SPDX-License-Identifier: MIT
#include "runtime/workspace.h"

#include <exception>

namespace flinch::runtime {

database::LoadStatus Workspace::reserve_memory(std::size_t bytes) noexcept try {
  std::vector<std::byte> memory(bytes);
  memory_ = std::move(memory);
  return database::LoadStatus::ok;
} catch (const std::exception&) {
  return database::LoadStatus::out_of_memory;
}

}  // namespace flinch::runtime
