// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "models/fit/pairwise_linear_fit.h"
#include "models/fit/svm_fit.h"
#include "runtime/selector_file.h"
#include "tests/models/training_sets.h"
#include "tests/runtime/selector_samples.h"
#include "tests/scenes/file_damage.h"
#include "train/fit/selector_writer.h"

namespace flinch::runtime {
namespace {

using database::LoadStatus;
using models::Selector;
using motion::Target;

void expect_every_byte_counts(const Selector& small) {
  const std::string bytes = train::selector_bytes(small);
  Selector untouched = tests::knn_selector();
  const auto is_refused = [&](const std::string& damaged) {
    return tests::read(damaged, untouched) != LoadStatus::ok;
  };
  std::mt19937_64 random(3);
  tests::expect_flips_are_refused(bytes, tests::random_flips(tests::places(bytes.size()), random),
                                  is_refused);
  tests::expect_wrong_sizes_are_refused(bytes, tests::places(bytes.size()), is_refused);
  EXPECT_EQ(train::selector_bytes(untouched), train::selector_bytes(tests::knn_selector()));
}

TEST(SelectorFileDamage, InAnyByteIsDetectedAndChangesNothing) {
  const models::TrainingSet set = models::random_clouds(1, 6, 2, features::kFeatureCount);
  Selector small = tests::selector_without_model();
  small.model = models::fit_svm(set, {3, 1.0 / 3, 0, 1});
  expect_every_byte_counts(small);
  small.model = models::fit_pairwise(models::with_costs(set, 2), {});
  expect_every_byte_counts(small);
}

TEST(SelectorFileDamage, OtherFileKindsHaveTheirOwnStatus) {
  std::string bytes = train::selector_bytes(tests::knn_selector());
  Selector selector;
  EXPECT_EQ(tests::read("", selector), LoadStatus::not_a_library);
  EXPECT_EQ(tests::read("HIERARCHY\nROOT Hips\n{\n", selector), LoadStatus::not_a_library);
  bytes[7] = static_cast<char>(bytes[7] + 1);
  EXPECT_EQ(tests::read(bytes, selector), LoadStatus::other_version);
}

/// Returns the file with every occurrence of `from` in its content replaced by `to`, which has the
/// same size, and with a matching header.
std::string resealed_with(const std::string& file, const std::string& from, const std::string& to) {
  EXPECT_EQ(from.size(), to.size());
  std::string content = tests::content_of(file);
  std::size_t replaced = 0;
  for (std::size_t at = content.find(from); at != std::string::npos;
       at = content.find(from, at + 1)) {
    content.replace(at, from.size(), to);
    ++replaced;
  }
  EXPECT_GT(replaced, 0U) << from;
  return tests::with_header(database::kSelectorFormat, content);
}

TEST(SelectorFileDamage, AnotherFeatureLayoutHasItsOwnStatus) {
  const std::string bytes = train::selector_bytes(tests::svm_selector());
  Selector selector;
  EXPECT_EQ(tests::read(resealed_with(bytes, "speed_mps", "speed_mph"), selector),
            LoadStatus::other_layout);
}

// Damage that the seal does not show, because the file was sealed after it. The verifier and the
// checks that follow must still reject everything that would be read beyond its bounds.
TEST(SelectorFileDamage, CorruptContentWithAValidSealNeverLoadsUnsound) {
  const auto damage = [](std::string& content, std::mt19937_64& random) {
    // Half of the changes are in the tables, which are before and after the long vectors.
    const std::size_t at = random() % 2 == 0 ? random() % content.size() : random() % 400;
    content[at] = static_cast<char>(random());
  };
  const auto reads = [](const std::string& damaged) {
    Selector selector;
    if (tests::read(damaged, selector) != LoadStatus::ok) return false;
    EXPECT_TRUE(is_sound(selector));
    EXPECT_LT(models::select(selector, features::FeatureVector{}, Target::trunk), 8);
    return true;
  };
  for (const Selector& original : tests::one_of_each()) {
    const tests::ReadCounts counts = tests::try_damaged_content(
        database::kSelectorFormat, train::selector_bytes(original), 3000, 4, damage, reads);
    EXPECT_GT(counts.refused, 100);
  }
}

}  // namespace
}  // namespace flinch::runtime
