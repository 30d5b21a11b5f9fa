// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <vector>

namespace flinch::models {

/// Runs task(0), …, task(count - 1) on OpenMP's threads, then rethrows the exception of the first
/// task, by number, that threw one.
template <typename Task>
void parallel_for(std::size_t count, const Task& task) {
  std::vector<std::exception_ptr> thrown(count);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < count; ++i) {
    try {
      task(i);
    } catch (...) {
      thrown[i] = std::current_exception();
    }
  }
  for (const std::exception_ptr& exception : thrown) {
    if (exception) {
      std::rethrow_exception(exception);
    }
  }
}

}  // namespace flinch::models
