// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "database/files/library_writer.h"
#include "database/library/library_file.h"
#include "tests/database/library/packable_library.h"
#include "tests/scenes/file_damage.h"
#include "tests/scenes/flatbuffer_mutation.h"
#include "tests/scenes/read_cost.h"

namespace flinch::database {
namespace {

void expect_refused_or_sound(const FileFormat& format, const std::string& file) {
  const std::size_t allowed = tests::ReadCost::allowance(file.size());
  const auto reads = [&](const std::string& mutant) {
    ClipLibrary library;
    const tests::ReadCost cost;
    const LoadStatus status = read_library(bytes_of(mutant), library);
    cost.expect_below(allowed);
    if (status != LoadStatus::ok) return false;
    EXPECT_FALSE(fault_of(library));
    return true;
  };
  const int count = tests::soak_samples(600, 100'000);
  const tests::ReadCounts counts = tests::try_damaged_content(
      format, file, count, 15, tests::FlatbufferMutation(tests::content_of(file)), reads);
  EXPECT_GT(counts.refused, count / 4);
  EXPECT_GT(counts.read, 0);
}

TEST(LibraryMutant, IsRefusedOrSoundAtTheCostOfAWholeFile) {
  expect_refused_or_sound(kLibraryFormat, library_bytes(tests::random_library(4, 4)));
}

TEST(LibraryMutant, OfPackedClipsIsRefusedOrSoundToo) {
  expect_refused_or_sound(tests::kPackedFormat, library_bytes(tests::packable(4, 4)));
}

}  // namespace
}  // namespace flinch::database
