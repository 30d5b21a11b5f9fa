// SPDX-License-Identifier: MIT
#include "runtime/selector_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <random>
#include <type_traits>

#include "database/files/file_io.h"
#include "database/library/file_header.h"
#include "tests/models/training_sets.h"
#include "tests/runtime/selector_samples.h"
#include "train/fit/selector_writer.h"

namespace flinch::runtime {
namespace {

using database::bytes_of;
using database::LoadStatus;
using models::Selector;
using motion::Target;
using tests::knn_selector;
using tests::one_of_each;
using tests::read;

std::vector<std::uint64_t> bits_of(const std::vector<double>& numbers) {
  std::vector<std::uint64_t> bits;
  for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

std::vector<std::uint32_t> bits_of_floats(const std::vector<float>& numbers) {
  std::vector<std::uint32_t> bits;
  for (const float number : numbers) bits.push_back(std::bit_cast<std::uint32_t>(number));
  return bits;
}

void expect_same(const models::SvmModel& a, const models::SvmModel& b) {
  EXPECT_EQ(a.degree, b.degree);
  EXPECT_EQ(bits_of({a.gamma, a.coef0, a.cost}), bits_of({b.gamma, b.coef0, b.cost}));
  EXPECT_EQ(a.feature_count, b.feature_count);
  EXPECT_EQ(a.kernel, b.kernel);
  EXPECT_EQ(a.label, b.label);
  EXPECT_EQ(a.vectors_of_class, b.vectors_of_class);
  EXPECT_EQ(bits_of(a.bound), bits_of(b.bound));
  EXPECT_EQ(a.support_vectors, b.support_vectors);
  EXPECT_EQ(a.vectors, b.vectors);
  EXPECT_EQ(bits_of(a.coefficients), bits_of(b.coefficients));
  ASSERT_EQ(a.machines.size(), b.machines.size());
  for (std::size_t i = 0; i < a.machines.size(); ++i) {
    EXPECT_EQ(bits_of({a.machines[i].rho, a.machines[i].weight}),
              bits_of({b.machines[i].rho, b.machines[i].weight}));
    EXPECT_EQ(a.machines[i].count, b.machines[i].count);
    EXPECT_EQ(a.machines[i].first_vector, b.machines[i].first_vector);
    EXPECT_EQ(a.machines[i].first_coefficient, b.machines[i].first_coefficient);
  }
  EXPECT_EQ(a.first_of_class, b.first_of_class);
  EXPECT_EQ(bits_of({a.largest_norm}), bits_of({b.largest_norm}));
}

void expect_same(const models::KnnModel& a, const models::KnnModel& b) {
  EXPECT_EQ(a.k, b.k);
  EXPECT_EQ(a.vote, b.vote);
  EXPECT_EQ(a.feature_count, b.feature_count);
  EXPECT_EQ(bits_of_floats(a.points), bits_of_floats(b.points));
  EXPECT_EQ(a.label, b.label);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.clip_count, b.clip_count);
  EXPECT_EQ(a.cost_step_ns, b.cost_step_ns);
  EXPECT_EQ(a.leaves.observation, b.leaves.observation);
  EXPECT_EQ(bits_of_floats(a.leaves.points), bits_of_floats(b.leaves.points));
  EXPECT_EQ(bits_of_floats(a.leaves.lower), bits_of_floats(b.leaves.lower));
  EXPECT_EQ(bits_of_floats(a.leaves.upper), bits_of_floats(b.leaves.upper));
}

void expect_same(const models::NetworkModel& a, const models::NetworkModel& b) {
  EXPECT_EQ(a.feature_count, b.feature_count);
  EXPECT_EQ(a.hidden_count, b.hidden_count);
  EXPECT_EQ(a.member_count, b.member_count);
  EXPECT_EQ(a.clip, b.clip);
  EXPECT_EQ(a.mean_root, b.mean_root);
  EXPECT_EQ(a.scale_root, b.scale_root);
  EXPECT_EQ(a.variance_ns, b.variance_ns);
  EXPECT_EQ(bits_of_floats(a.weights), bits_of_floats(b.weights));
}

void expect_same(const models::PairwiseModel& a, const models::PairwiseModel& b) {
  EXPECT_EQ(a.feature_count, b.feature_count);
  EXPECT_EQ(a.clip, b.clip);
  EXPECT_EQ(a.machine, b.machine);
  EXPECT_EQ(a.weights, b.weights);
}

void expect_same(const models::ClipSummary& a, const models::ClipSummary& b) {
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.annotation.has_value(), b.annotation.has_value());
  if (!a.annotation) return;
  EXPECT_EQ(a.annotation->target, b.annotation->target);
  EXPECT_EQ(a.annotation->degree, b.annotation->degree);
  EXPECT_EQ(a.annotation->direction, b.annotation->direction);
  EXPECT_EQ(a.annotation->onset_s, b.annotation->onset_s);
  EXPECT_EQ(a.annotation->peak_s, b.annotation->peak_s);
  EXPECT_EQ(a.annotation->end_s, b.annotation->end_s);
}

void expect_same(const Selector& a, const Selector& b) {
  EXPECT_EQ(a.library_hash, b.library_hash);
  EXPECT_EQ(a.idle, b.idle);
  ASSERT_EQ(a.clips.size(), b.clips.size());
  for (std::size_t i = 0; i < a.clips.size(); ++i) expect_same(a.clips[i], b.clips[i]);
  EXPECT_EQ(a.layout, b.layout);
  EXPECT_EQ(bits_of(a.scaling.min), bits_of(b.scaling.min));
  EXPECT_EQ(bits_of(a.scaling.max), bits_of(b.scaling.max));
  EXPECT_EQ(bits_of({a.brawn}), bits_of({b.brawn}));
  EXPECT_EQ(a.target_centres, b.target_centres);
  EXPECT_EQ(a.kinds, b.kinds);
  ASSERT_TRUE(a.costs && b.costs);
  EXPECT_EQ(a.costs->vulnerability, b.costs->vulnerability);
  EXPECT_EQ(a.costs->reference_damage_ns, b.costs->reference_damage_ns);
  EXPECT_EQ(a.costs->of_kind, b.costs->of_kind);
  EXPECT_EQ(a.costs->reference_work_j, b.costs->reference_work_j);
  EXPECT_EQ(a.costs->work_j, b.costs->work_j);
  EXPECT_EQ(a.costs->of_stance, b.costs->of_stance);
  EXPECT_EQ(a.costs->phase_count, b.costs->phase_count);
  EXPECT_EQ(a.costs->time_count, b.costs->time_count);
  EXPECT_EQ(a.costs->min_time_s, b.costs->min_time_s);
  EXPECT_EQ(a.costs->time_step_s, b.costs->time_step_s);
  EXPECT_EQ(a.costs->vulnerability_name, b.costs->vulnerability_name);
  ASSERT_EQ(a.model.index(), b.model.index());
  std::visit(
      [&](const auto& model) {
        expect_same(model, std::get<std::decay_t<decltype(model)>>(b.model));
      },
      a.model);
}

TEST(SelectorFile, RoundTripsBitForBit) {
  for (const Selector& selector : one_of_each()) {
    const std::string bytes = train::selector_bytes(selector);
    EXPECT_EQ(bytes, train::selector_bytes(selector));
    Selector back;
    ASSERT_EQ(read(bytes, back), LoadStatus::ok);
    expect_same(selector, back);
  }
}

TEST(SelectorFile, SelectsTheSameAfterARoundTrip) {
  for (const Selector& selector : one_of_each()) {
    Selector back;
    ASSERT_EQ(read(train::selector_bytes(selector), back), LoadStatus::ok);
    std::mt19937_64 random(2);
    for (int i = 0; i < 200; ++i) {
      features::FeatureVector x{};
      for (float& value : x) value = static_cast<float>(models::random_point(random, 1)[0]);
      const auto target = static_cast<Target>(random() % 4);
      ASSERT_EQ(models::select(back, x, target), models::select(selector, x, target));
    }
  }
}

TEST(SelectorFile, RoundTripsThroughADiskFile) {
  const auto path =
      (std::filesystem::path(testing::TempDir()) / "selector_file_test.flinch").string();
  const Selector selector = knn_selector();
  train::write_selector(selector, {}, nullptr, path);
  EXPECT_EQ(database::read_file(path), train::selector_bytes(selector));
  Selector back;
  ASSERT_EQ(read_selector(path, back), LoadStatus::ok);
  expect_same(selector, back);
  std::filesystem::remove(path);
  EXPECT_EQ(read_selector(path, back), LoadStatus::cannot_open);
}

TEST(SelectorFile, BytesNeedNoAlignment) {
  const std::string shifted = "x" + train::selector_bytes(knn_selector());
  Selector back;
  EXPECT_EQ(read_selector(bytes_of(shifted).subspan(1), back), LoadStatus::ok);
}

}  // namespace
}  // namespace flinch::runtime
