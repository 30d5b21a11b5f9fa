// SPDX-License-Identifier: MIT
#pragma once

// GCC has the first, Clang the second, which other headers define for GCC as false.
#if defined(__SANITIZE_ADDRESS__)
#define FLINCH_LEAKS_ARE_FOUND
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FLINCH_LEAKS_ARE_FOUND
#endif
#endif

#ifdef FLINCH_LEAKS_ARE_FOUND
#include <sanitizer/lsan_interface.h>
#endif

namespace flinch::tests {

/// While it lives, the leak sanitizer does not watch what is allocated: for what a library outside
/// of Flinch leaks.
class AllowLeaks {
 public:
#ifdef FLINCH_LEAKS_ARE_FOUND
  AllowLeaks() {
    __lsan_disable();
  }
  ~AllowLeaks() {
    __lsan_enable();
  }
#else
  AllowLeaks() {}
  ~AllowLeaks() {}
#endif
  AllowLeaks(const AllowLeaks&) = delete;
  AllowLeaks& operator=(const AllowLeaks&) = delete;
};

}  // namespace flinch::tests
