// SPDX-License-Identifier: MIT
#include "runtime/selector_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <random>
#include <type_traits>

#include "database/file_io.h"
#include "models/knn_fit.h"
#include "models/network_fit.h"
#include "models/pairwise_linear_fit.h"
#include "models/svm_fit.h"
#include "motion/error.h"
#include "tests/models/training_sets.h"
#include "train/selector_writer.h"

namespace flinch::runtime {
namespace {

using database::LoadStatus;
using models::Selector;
using motion::Target;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

LoadStatus read(const std::string& bytes, Selector& selector) {
  return read_selector(bytes_of(bytes), selector);
}

/// Clips 0 to 7, idle last; numbers that no text or float would bring back.
Selector selector_without_model() {
  Selector selector;
  selector.library_hash = 0xFEDCBA9876543210;
  for (int clip = 0; clip < 7; ++clip) {
    selector.clips.push_back({"clip \"" + std::to_string(clip) + "\"",
                              motion::Annotation{.target = static_cast<Target>(clip % 4),
                                                 .direction = -0.1F * static_cast<float>(clip),
                                                 .degree = motion::Degree::exaggerated,
                                                 .onset_s = 1.0F / 3,
                                                 .peak_s = 2.0F / 3,
                                                 .end_s = 1}});
  }
  selector.clips.push_back({"idle", std::nullopt});
  selector.idle = 7;
  selector.layout = features::feature_set_named("paper")->layout;
  for (int i = 0; i < features::kFeatureCount; ++i) {
    selector.scaling.least.push_back(-1.0 / (i + 3));
    selector.scaling.most.push_back(1.0 / (i + 7));
  }
  selector.brawn = 0.1;
  for (Eigen::Vector3f& centre : selector.target_centres) centre = {0.1F, -0.2F, 1.0F / 3};
  return selector;
}

models::TrainingSet training_set() {
  return models::random_clouds(1, 80, 4, features::kFeatureCount);
}

Selector svm_selector() {
  Selector selector = selector_without_model();
  selector.model = models::fit_svm(training_set(), {3, 1.0 / 3, 1.0 / 7, 10});
  return selector;
}

/// Of features that do not fill a whole row of the model.
Selector rbf_selector() {
  Selector selector = selector_without_model();
  selector.layout = features::feature_set_named("geometry")->layout;
  const int features = selector.layout.size();
  selector.scaling.least.assign(static_cast<std::size_t>(features), -1.0 / 3);
  selector.scaling.most.assign(static_cast<std::size_t>(features), 1.0 / 7);
  selector.model = models::fit_svm(
      models::random_clouds(1, 80, 4, features),
      {.gamma = 1.0 / 3, .cost = 1.0 / 7, .kernel = models::SvmKernel::rbf, .balance = 0.5});
  return selector;
}

Selector knn_selector() {
  Selector selector = selector_without_model();
  selector.model = models::fit_knn(training_set(), {7, models::KnnVote::inverse_distance});
  return selector;
}

Selector knn_cost_selector() {
  Selector selector = selector_without_model();
  selector.model =
      models::fit_knn(models::with_costs(training_set(), 5), {7, models::KnnVote::cost});
  return selector;
}

Selector network_selector() {
  Selector selector = selector_without_model();
  selector.model = models::fit_network(models::with_costs(training_set(), 5),
                                       {.hidden_count = 16, .member_count = 2, .epoch_count = 1});
  return selector;
}

Selector pairwise_selector() {
  Selector selector = selector_without_model();
  selector.model = models::fit_pairwise(models::with_costs(training_set(), 5), {});
  return selector;
}

std::vector<Selector> one_of_each() {
  return {svm_selector(),      rbf_selector(),     knn_selector(),
          knn_cost_selector(), network_selector(), pairwise_selector()};
}

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
  EXPECT_EQ(bits_of(a.scaling.least), bits_of(b.scaling.least));
  EXPECT_EQ(bits_of(a.scaling.most), bits_of(b.scaling.most));
  EXPECT_EQ(bits_of({a.brawn}), bits_of({b.brawn}));
  EXPECT_EQ(a.target_centres, b.target_centres);
  ASSERT_EQ(a.model.index(), b.model.index());
  std::visit(
      [&](const auto& model) {
        expect_same(model, std::get<std::decay_t<decltype(model)>>(b.model));
      },
      a.model);
}

TEST(SelectorFile, ComesBackToTheBit) {
  for (const Selector& selector : one_of_each()) {
    const std::string bytes = train::selector_bytes(selector);
    EXPECT_EQ(bytes, train::selector_bytes(selector));
    Selector back;
    ASSERT_EQ(read(bytes, back), LoadStatus::ok);
    expect_same(selector, back);
  }
}

TEST(SelectorFile, ChoosesTheSameAfterwards) {
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

TEST(SelectorFile, IsWrittenUnderItsNameAndReadFromIt) {
  const auto path =
      (std::filesystem::path(testing::TempDir()) / "selector_file_test.flinch").string();
  const Selector selector = knn_selector();
  train::write_selector(selector, {}, path);
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

void expect_every_byte_counts(const Selector& small) {
  const std::string bytes = train::selector_bytes(small);
  Selector untouched = knn_selector();
  std::mt19937_64 random(3);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ static_cast<char>(1 + random() % 255));
    ASSERT_NE(read(changed, untouched), LoadStatus::ok) << "byte " << i;
  }
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_NE(read(bytes.substr(0, size), untouched), LoadStatus::ok) << size << " bytes";
  }
  EXPECT_NE(read(bytes + '\0', untouched), LoadStatus::ok);
  expect_same(untouched, knn_selector());
}

TEST(SelectorFile, AnyChangedByteIsNoticedAndNothingIsTouched) {
  const models::TrainingSet set = models::random_clouds(1, 6, 2, features::kFeatureCount);
  Selector small = selector_without_model();
  small.model = models::fit_svm(set, {3, 1.0 / 3, 0, 1});
  expect_every_byte_counts(small);
  small.model = models::fit_pairwise(models::with_costs(set, 2), {});
  expect_every_byte_counts(small);
}

TEST(SelectorFile, OtherFilesAreToldApart) {
  std::string bytes = train::selector_bytes(knn_selector());
  Selector selector;
  EXPECT_EQ(read("", selector), LoadStatus::not_a_library);
  EXPECT_EQ(read("HIERARCHY\nROOT Hips\n{\n", selector), LoadStatus::not_a_library);
  bytes[7] = static_cast<char>(bytes[7] + 1);
  EXPECT_EQ(read(bytes, selector), LoadStatus::other_version);
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
  const auto seal =
      database::make_seal(database::kSelectorKind, bytes_of(bytes).subspan(database::kSealSize));
  return bytes.replace(0, seal.size(), reinterpret_cast<const char*>(seal.data()), seal.size());
}

TEST(SelectorFile, AnotherFeatureLayoutIsRefusedAsSuch) {
  const std::string bytes = train::selector_bytes(svm_selector());
  Selector selector;
  EXPECT_EQ(read(resealed_with(bytes, "speed_mps", "speed_mph"), selector),
            LoadStatus::other_layout);
}

// Damage that the seal cannot see, because who sealed it meant it: the verifier and the checks that
// follow must still keep anything out that would be read beyond its bounds.
TEST(SelectorFile, SealedNonsenseNeverGetsThroughUnsound) {
  for (const Selector& original : one_of_each()) {
    const std::string bytes = train::selector_bytes(original);
    std::mt19937_64 random(4);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
      std::string changed = bytes;
      // Half of the changes go to the tables, which stand before and after the long vectors.
      const std::size_t content = bytes.size() - database::kSealSize;
      const std::size_t at = random() % 2 == 0 ? random() % content : random() % 400;
      changed[database::kSealSize + at] = static_cast<char>(random());
      const auto seal = database::make_seal(database::kSelectorKind,
                                            bytes_of(changed).subspan(database::kSealSize));
      changed.replace(0, seal.size(), reinterpret_cast<const char*>(seal.data()), seal.size());
      Selector selector;
      if (read(changed, selector) != LoadStatus::ok) {
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

TEST(SelectorFile, WhatCannotBeReadIsNotWritten) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto svm = [](Selector& s) -> models::SvmModel& { return std::get<0>(s.model); };
  const auto knn = [](Selector& s) -> models::KnnModel& { return std::get<1>(s.model); };
  const std::vector<std::function<void(Selector&)>> faults_of_any{
      [](Selector& s) { s.idle = 8; },
      [](Selector& s) { s.idle = -1; },
      [](Selector& s) { s.clips.clear(); },
      [](Selector& s) { s.layout = {}; },
      [](Selector& s) { s.layout = features::feature_set_named("geometry")->layout; },
      [](Selector& s) { s.scaling.least.pop_back(); },
      [nan](Selector& s) { s.scaling.most[3] = nan; },
      [](Selector& s) { s.scaling.least[3] = s.scaling.most[3] + 1; },
      [nan](Selector& s) { s.brawn = nan; },
      [](Selector& s) { s.brawn = 1.5; },
      [](Selector& s) { s.clips[2].annotation->target = static_cast<Target>(4); },
      [](Selector& s) { s.clips[2].annotation->degree = static_cast<motion::Degree>(2); },
      [nan](Selector& s) { s.clips[2].annotation->direction = static_cast<float>(nan); },
      [nan](Selector& s) { s.target_centres[3].z() = static_cast<float>(nan); }};
  const std::vector<std::function<void(Selector&)>> faults_of_svm{
      [&](Selector& s) { svm(s).label[1] = 8; },
      [&](Selector& s) { svm(s).label[1] = svm(s).label[0]; },
      [&](Selector& s) { svm(s).label.clear(); },
      [&](Selector& s) { svm(s).vectors_of_class[0] += 1; },
      [&](Selector& s) { svm(s).vectors_of_class[0] = -1; },
      [&](Selector& s) { svm(s).vectors_of_class.pop_back(); },
      [&](Selector& s) { svm(s).support_vectors.pop_back(); },
      [&](Selector& s) { svm(s).coefficients.pop_back(); },
      [&](Selector& s) { svm(s).machines.pop_back(); },
      [&](Selector& s) { svm(s).machines[0].rho = nan; },
      [&](Selector& s) { svm(s).machines[0].count[0] += 1; },
      [&](Selector& s) { svm(s).vectors.pop_back(); },
      [&](Selector& s) { svm(s).vectors[0] = 65535; },
      [&](Selector& s) { svm(s).vectors[1] = svm(s).vectors[0]; },
      [&](Selector& s) { svm(s).bound.pop_back(); },
      [&](Selector& s) { svm(s).bound[0] = nan; },
      [&](Selector& s) { svm(s).bound[0] = -1; },
      [&](Selector& s) { svm(s).kernel = static_cast<models::SvmKernel>(2); },
      [&](Selector& s) { svm(s).coefficients[2] = -1; },
      [&](Selector& s) { svm(s).gamma = -1; },
      [&](Selector& s) { svm(s).coefficients[2] = nan; },
      [&](Selector& s) { svm(s).support_vectors[2] = static_cast<float>(nan); },
      [&](Selector& s) { svm(s).gamma = nan; },
      [&](Selector& s) { svm(s).degree = -1; }};
  const std::vector<std::function<void(Selector&)>> faults_of_knn{
      [&](Selector& s) { knn(s).k = 0; },
      [&](Selector& s) { knn(s).vote = static_cast<models::KnnVote>(2); },
      [&](Selector& s) { knn(s).label[5] = -1; },
      [&](Selector& s) { knn(s).label.pop_back(); },
      [&](Selector& s) { knn(s).label.clear(), knn(s).points.clear(); },
      [&](Selector& s) { knn(s).points[5] = static_cast<float>(nan); }};
  const std::vector<std::function<void(Selector&)>> faults_of_knn_cost{
      [&](Selector& s) { knn(s).cost.pop_back(); },
      [&](Selector& s) { knn(s).cost.clear(); },
      [&](Selector& s) { knn(s).vote = models::KnnVote::majority; },
      [&](Selector& s) { knn(s).k = 65536; },
      [&](Selector& s) { knn(s).cost_step_ns = 0; },
      [&](Selector& s) { knn(s).cost_step_ns = static_cast<float>(nan); }};
  const auto network = [](Selector& s) -> models::NetworkModel& {
    return std::get<models::NetworkModel>(s.model);
  };
  const std::vector<std::function<void(Selector&)>> faults_of_network{
      [&](Selector& s) { network(s).clip[1] = network(s).clip[0]; },
      [&](Selector& s) { network(s).clip.back() = 8; },
      [&](Selector& s) { network(s).clip.clear(); },
      [&](Selector& s) { network(s).hidden_count = 24; },
      [&](Selector& s) { network(s).hidden_count = 0; },
      [&](Selector& s) { network(s).member_count = 3; },
      [&](Selector& s) { network(s).member_count = 0; },
      [&](Selector& s) { network(s).weights.pop_back(); },
      [&](Selector& s) { network(s).weights[7] = static_cast<float>(nan); },
      [&](Selector& s) { network(s).weights[7] = -2e4F; },
      [&](Selector& s) { network(s).scale_root = 0; },
      [&](Selector& s) { network(s).mean_root = static_cast<float>(nan); },
      [&](Selector& s) { network(s).variance_ns = -1; }};
  const auto pairwise = [](Selector& s) -> models::PairwiseModel& {
    return std::get<models::PairwiseModel>(s.model);
  };
  const std::vector<std::function<void(Selector&)>> faults_of_pairwise{
      [&](Selector& s) { pairwise(s).clip[1] = pairwise(s).clip[0]; },
      [&](Selector& s) { pairwise(s).clip.back() = 8; },
      [&](Selector& s) { pairwise(s).clip.pop_back(); },
      [&](Selector& s) { pairwise(s).clip.clear(), pairwise(s).machine.clear(); },
      [&](Selector& s) { pairwise(s).machine.pop_back(); },
      [&](Selector& s) { pairwise(s).machine[2] = -2; },
      [&](Selector& s) { pairwise(s).machine[2] = 28; },
      [&](Selector& s) { pairwise(s).weights.pop_back(); },
      [&](Selector& s) { pairwise(s).weights.resize(27 * pairwise(s).row_size()); },
      [&](Selector& s) { std::fill_n(pairwise(s).weights.end() - 17, 17, 0x7FFF); },
      [&](Selector& s) { std::fill_n(pairwise(s).weights.begin(), 17, -0x8000); }};
  const auto expect_refused = [](Selector selector, const auto& faults) {
    ASSERT_NO_THROW(train::selector_bytes(selector));
    for (std::size_t i = 0; i < faults.size(); ++i) {
      Selector faulty = selector;
      faults[i](faulty);
      EXPECT_THROW(train::selector_bytes(faulty), Error) << "fault " << i;
    }
  };
  expect_refused(svm_selector(), faults_of_any);
  expect_refused(svm_selector(), faults_of_svm);
  const auto fill = static_cast<std::size_t>(rbf_selector().layout.size());
  expect_refused(rbf_selector(), std::vector<std::function<void(Selector&)>>{
                                     [&](Selector& s) { svm(s).support_vectors[fill] = 1; }});
  expect_refused(knn_selector(), faults_of_knn);
  expect_refused(knn_cost_selector(), faults_of_knn_cost);
  expect_refused(network_selector(), faults_of_network);
  expect_refused(pairwise_selector(), faults_of_pairwise);
}

}  // namespace
}  // namespace flinch::runtime
