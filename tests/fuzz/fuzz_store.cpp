// SPDX-License-Identifier: MIT
// The store's reader, which is SQLite's and ours. An input is a whole file.
#include "motion/error.h"
#include "tests/fuzz/fuzz.h"
#include "tests/scenes/temporary_folder.h"
#include "train/store/store.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flinch;
  static const tests::TemporaryFolder folder;
  const std::string path = folder.write("input.flinchobs", std::string(tests::text_of(data, size)));
  try {
    train::StoreReader reader(path);
    tests::require(!reader.header().clips.empty(), "an accepted store has clips");
    train::Observation observation;
    std::uint64_t before = 0;
    for (bool is_first = true; reader.next(observation); is_first = false) {
      tests::require(is_first || observation.number > before, "numbers ascend");
      before = observation.number;
    }
  } catch (const Error&) {
  }
  return 0;
}
