// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "database/library/file_header.h"
#include "models/fit/pairwise_linear_fit.h"
#include "models/fit/svm_fit.h"
#include "runtime/selector_file.h"
#include "tests/models/training_sets.h"
#include "tests/runtime/selector_samples.h"
#include "train/fit/selector_writer.h"

namespace flinch::runtime {
namespace {

using database::LoadStatus;
using models::Selector;
using motion::Target;

void expect_every_byte_counts(const Selector& small) {
  const std::string bytes = train::selector_bytes(small);
  Selector untouched = tests::knn_selector();
  std::mt19937_64 random(3);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ static_cast<char>(1 + random() % 255));
    ASSERT_NE(tests::read(changed, untouched), LoadStatus::ok) << "byte " << i;
  }
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_NE(tests::read(bytes.substr(0, size), untouched), LoadStatus::ok) << size << " bytes";
  }
  EXPECT_NE(tests::read(bytes + '\0', untouched), LoadStatus::ok);
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

/// The bytes of a selector that was sealed properly but whose content differs: every occurrence of
/// `from` in the content becomes `to`, of the same size.
std::string resealed_with(std::string bytes, const std::string& from, const std::string& to) {
  EXPECT_EQ(from.size(), to.size());
  std::size_t replaced = 0;
  for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + 1)) {
    bytes.replace(at, from.size(), to);
    ++replaced;
  }
  EXPECT_GT(replaced, 0U) << from;
  const auto seal = database::make_file_header(
      database::kSelectorFormat, database::bytes_of(bytes).subspan(database::kFileHeaderSize));
  return bytes.replace(0, seal.size(), reinterpret_cast<const char*>(seal.data()), seal.size());
}

TEST(SelectorFileDamage, AnotherFeatureLayoutHasItsOwnStatus) {
  const std::string bytes = train::selector_bytes(tests::svm_selector());
  Selector selector;
  EXPECT_EQ(tests::read(resealed_with(bytes, "speed_mps", "speed_mph"), selector),
            LoadStatus::other_layout);
}

// Damage that the seal cannot see, because who sealed it meant it: the verifier and the checks that
// follow must still keep anything out that would be read beyond its bounds.
TEST(SelectorFileDamage, CorruptContentWithAValidSealNeverLoadsUnsound) {
  for (const Selector& original : tests::one_of_each()) {
    const std::string bytes = train::selector_bytes(original);
    std::mt19937_64 random(4);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
      std::string changed = bytes;
      // Half of the changes go to the tables, which stand before and after the long vectors.
      const std::size_t content = bytes.size() - database::kFileHeaderSize;
      const std::size_t at = random() % 2 == 0 ? random() % content : random() % 400;
      changed[database::kFileHeaderSize + at] = static_cast<char>(random());
      const auto seal = database::make_file_header(
          database::kSelectorFormat,
          database::bytes_of(changed).subspan(database::kFileHeaderSize));
      changed.replace(0, seal.size(), reinterpret_cast<const char*>(seal.data()), seal.size());
      Selector selector;
      if (tests::read(changed, selector) != LoadStatus::ok) {
        ++refused;
        continue;
      }
      ASSERT_TRUE(is_sound(selector));
      features::FeatureVector x{};
      ASSERT_LT(models::select(selector, x, Target::trunk), 8);
    }
    EXPECT_GT(refused, 100);
  }
}

}  // namespace
}  // namespace flinch::runtime
