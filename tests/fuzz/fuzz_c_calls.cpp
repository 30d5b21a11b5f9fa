// SPDX-License-Identifier: MIT
// The C interface: an input is a sequence of calls and their numbers. FLINCH_FUZZ_SELECTOR names
// the selector file that they use.
#include <algorithm>

#include "tests/endurance/call_sequence.h"
#include "tests/fuzz/fuzz.h"

namespace {

flinch_library* load() {
  const char* path = std::getenv("FLINCH_FUZZ_SELECTOR");
  flinch_library* library = nullptr;
  flinch::tests::require(path != nullptr && flinch_library_load(path, &library) == FLINCH_OK,
                         "FLINCH_FUZZ_SELECTOR names a selector");
  return library;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static flinch_library* library = load();
  std::size_t at = 0;
  flinch::tests::CallSequence sequence(library, [&] {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < sizeof word; ++i, ++at)
      word = word << 8U | (at < size ? data[at] : 0U);
    return word;
  });
  while (at < size) {
    if (!sequence.call()) flinch::tests::require(false, sequence.fault().c_str());
  }
  return 0;
}
