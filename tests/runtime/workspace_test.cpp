// SPDX-License-Identifier: MIT
#include "runtime/selection.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/runtime/made_up_selector.h"
#include "tests/scenes/allocation_count.h"

namespace flinch::runtime {
namespace {

using models::Candidate;
using motion::Target;
using tests::ModelKind;

constexpr int kClips = 24;

models::Selector selector_with(ModelKind model) {
  return tests::made_up_selector(tests::made_up_library(kClips, 61), 300, model).selector;
}

/// Threats of every size, and feature vectors that are no threat.
std::vector<features::FeatureVector> queries() {
  std::mt19937_64 random(7);
  std::vector<features::FeatureVector> queries(500);
  for (features::FeatureVector& query : queries) {
    const std::vector<double> point = models::random_point(random, features::kFeatureCount);
    std::transform(point.begin(), point.end(), query.begin(),
                   [](double value) { return static_cast<float>(value); });
  }
  for (const float value :
       {0.0F, 1e30F, std::numeric_limits<float>::max(), std::numeric_limits<float>::infinity(),
        std::numeric_limits<float>::quiet_NaN()}) {
    queries.emplace_back().fill(value);
    queries.emplace_back(queries[0])[3] = value;
  }
  return queries;
}

class WorkspaceOfModel : public testing::TestWithParam<ModelKind> {};
INSTANTIATE_TEST_SUITE_P(Models, WorkspaceOfModel,
                         testing::Values(ModelKind::svm, ModelKind::knn, ModelKind::knn_cost,
                                         ModelKind::network, ModelKind::pairwise));

TEST_P(WorkspaceOfModel, SelectsAsTheModelDoesWithoutAllocating) {
  const models::Selector selector = selector_with(GetParam());
  Workspace workspace;
  ASSERT_EQ(workspace.reserve_memory(selection_bytes(selector)), database::LoadStatus::ok);
  std::array<Candidate, kClips> best;
  for (const features::FeatureVector& query : queries()) {
    for (const Target target : motion::kTargets) {
      const std::size_t before = tests::allocation_count();
      const Selection selection = select(workspace, selector, query, target, best);
      ASSERT_EQ(tests::allocation_count(), before);
      ASSERT_EQ(selection.status, SelectStatus::ok);
      const auto expected = models::candidates(selector, query, target);
      ASSERT_GT(tests::allocation_count(), before) << "the count counts";
      ASSERT_EQ(selection.clip, expected[0].clip);
      ASSERT_EQ(selection.count, expected.size());
      for (std::size_t i = 0; i < selection.count; ++i) {
        ASSERT_EQ(best[i].clip, expected[i].clip);
        // NaN is not equal to itself.
        ASSERT_EQ(std::bit_cast<std::uint32_t>(best[i].vote),
                  std::bit_cast<std::uint32_t>(expected[i].vote));
      }
    }
  }
}

TEST_P(WorkspaceOfModel, WritesAtMostTheRequestedCandidates) {
  const models::Selector selector = selector_with(GetParam());
  Workspace workspace;
  ASSERT_EQ(workspace.reserve_memory(selection_bytes(selector)), database::LoadStatus::ok);
  const features::FeatureVector query = queries()[1];
  const auto expected = models::candidates(selector, query, Target::trunk);
  ASSERT_GT(expected.size(), 2U);
  std::array<Candidate, 3> best{{{-1, 0}, {-1, 0}, {-1, 0}}};
  const Selection two = select(workspace, selector, query, Target::trunk, std::span(best).first(2));
  EXPECT_EQ(two.count, 2U);
  EXPECT_EQ(best[1].clip, expected[1].clip);
  EXPECT_EQ(best[2].clip, -1);
  const Selection none = select(workspace, selector, query, Target::trunk, {});
  EXPECT_EQ(none.status, SelectStatus::ok);
  EXPECT_EQ(none.clip, expected[0].clip);
  EXPECT_EQ(none.count, 0U);
}

TEST_P(WorkspaceOfModel, ReportsTooLittleMemory) {
  const models::Selector selector = selector_with(GetParam());
  const std::size_t need = selection_bytes(selector);
  std::array<Candidate, kClips> best;
  Workspace workspace;
  EXPECT_EQ(select(workspace, selector, {}, Target::trunk, best).status, SelectStatus::too_small);
  for (std::size_t size = 0; size < need / 2; size += 1 + need / 50) {
    ASSERT_EQ(workspace.reserve_memory(size), database::LoadStatus::ok);
    const Selection selection = select(workspace, selector, {}, Target::trunk, best);
    EXPECT_EQ(selection.status, SelectStatus::too_small) << size << " of " << need << " bytes";
    EXPECT_EQ(selection.count, 0U);
  }
  ASSERT_EQ(workspace.reserve_memory(need), database::LoadStatus::ok);
  EXPECT_EQ(select(workspace, selector, {}, Target::trunk, best).status, SelectStatus::ok);
}

TEST(Workspace, KeepsItsMemoryWhenReservingMoreFails) {
  const models::Selector selector = selector_with(ModelKind::knn);
  Workspace workspace;
  ASSERT_EQ(workspace.reserve_memory(selection_bytes(selector)), database::LoadStatus::ok);
  EXPECT_EQ(workspace.reserve_memory(std::numeric_limits<std::size_t>::max()),
            database::LoadStatus::out_of_memory);
  EXPECT_EQ(select(workspace, selector, {}, Target::head, {}).status, SelectStatus::ok);
}

}  // namespace
}  // namespace flinch::runtime
