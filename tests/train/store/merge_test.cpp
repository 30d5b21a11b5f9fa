// SPDX-License-Identifier: MIT
#include "train/store/merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "motion/error.h"
#include "tests/scenes/error_of.h"
#include "tests/train/store/made_up_store.h"

namespace flinch::train {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::uint64_t kCount = 60;

class Merge : public testing::Test {
 protected:
  std::string make(const std::string& name, ScenarioRange range) {
    return make(name, made_up_observations(header_, range.first, range.end()));
  }
  std::string make(const std::string& name, std::span<const Observation> observations) {
    const std::string path = folder_ / name;
    StoreWriter writer(path, header_, {observations.front().number, observations.size()});
    writer.append(observations);
    writer.finish();
    return path;
  }

  /// Returns the message of a merge that must fail, and checks that it leaves no file under the
  /// name.
  std::string refusal(const std::vector<std::string>& paths) {
    const std::string message = tests::error_of([&] { merge_stores(paths, folder_ / "out"); });
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
    return message;
  }

  TemporaryFolder folder_;
  StoreHeader header_ = made_up_header();
};

TEST_F(Merge, GivesTheBytesOfOneStoreOfAllScenarios) {
  const std::string whole = read_file(make("whole", {0, kCount}));
  const std::string a = make("a", {0, 25});
  const std::string b = make("b", {25, 15});
  const std::string c = make("c", {40, 20});
  const std::string inner = make("inner", {30, 5});
  const std::string over = make("over", {20, 30});
  const std::vector<std::vector<std::string>> ways{
      {a, b, c}, {c, a, b}, {c, over, a}, {over, inner, c, b, a}, {a, a, c, over}};
  for (const auto& paths : ways) {
    merge_stores(paths, folder_ / "out");
    EXPECT_TRUE(read_file(folder_ / "out") == whole);
    std::filesystem::remove(folder_ / "out");
  }
  merge_stores(std::vector{a, over, c}, a);
  EXPECT_TRUE(read_file(a) == whole) << "into one of them";
  EXPECT_FALSE(std::filesystem::exists(a + ".partial"));
}

TEST_F(Merge, ResumesAfterAnInterruption) {
  const std::string whole = read_file(make("whole", {10, 50}));
  const std::string a = make("a", {10, 20});
  const std::string b = make("b", {30, 30});
  {
    StoreWriter writer(folder_ / "out", header_, {10, 50});
    writer.append(made_up_observations(header_, 25, 35));
  }
  merge_stores(std::vector{a, b}, folder_ / "out");
  EXPECT_TRUE(read_file(folder_ / "out") == whole);
}

TEST_F(Merge, NamesTheScenarioOnWhichStoresDisagree) {
  const std::string a = make("a", {0, 20});
  std::vector<Observation> others = made_up_observations(header_, 10, 30);
  others[7].trials[1].impulse[motion::Body::chest] = 1;
  const std::string b = make("b", others);
  EXPECT_THAT(refusal({a, b}), HasSubstr("b: scenario 17 is not as in " + a));
}

TEST_F(Merge, ChecksThePartialFileOfAnEarlierMerge) {
  std::vector<Observation> others = made_up_observations(header_, 5, 8);
  others[1].scenario.threat.mass_kg = 1;
  {
    StoreWriter writer(folder_ / "out", header_, {0, 20});
    writer.append(others);
  }
  EXPECT_THAT(refusal({make("a", {0, 20})}),
              AllOf(HasSubstr("a: scenario 6 is not as in "), HasSubstr("out.partial")));
}

TEST_F(Merge, NamesAGap) {
  const std::string a = make("a", {0, 20});
  const std::string c = make("c", {33, 7});
  EXPECT_THAT(refusal({c, a}),
              AllOf(HasSubstr("c: scenarios 20 to 32 are in none"), HasSubstr("--first 20 -n 13")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.partial"));
}

TEST_F(Merge, RejectsStoresOfOtherRunsNamingFileAndDifference) {
  const std::string a = make("a", {0, 20});
  const StoreHeader header = header_;
  const auto expect = [&](const char* what) {
    const std::string b = make("b", {20, 20});
    EXPECT_THAT(refusal({a, b}), AllOf(HasSubstr("b: made"), HasSubstr(what), HasSubstr(a)));
    std::filesystem::remove(b);
    header_ = header;
  };
  header_.seed = 6;
  expect("--seed 6, not 5");
  header_.distribution = "{}";
  expect("distribution");
  header_.simulation = "{}";
  expect("simulation");
  database::ClipLibrary other = scenes::synthetic_library();
  other.name = "other";
  const std::string file = database::library_bytes(other);
  const auto bytes = std::as_bytes(std::span(file));
  header_.library_file.assign(bytes.begin(), bytes.end());
  header_.library_hash = database::verify_file(database::kLibraryFormat, bytes).hash;
  header_.library_name = "other";
  expect("another library (other");
}

TEST_F(Merge, RejectsAnUnfinishedStore) {
  const std::string a = make("a", {0, 20});
  {
    StoreWriter writer(folder_ / "b", header_, {20, 20});
    writer.append(made_up_observations(header_, 25, 30));
    writer.append(made_up_observations(header_, 35, 40));
  }
  EXPECT_THAT(refusal({a, folder_ / "b.partial"}), HasSubstr("b.partial: is not finished"));
  EXPECT_THAT(refusal({a, folder_ / "b"}), HasSubstr("b: cannot be read"));
}

}  // namespace
}  // namespace flinch::train
