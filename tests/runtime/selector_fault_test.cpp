// SPDX-License-Identifier: MIT
// The writer refuses every selector that the reader would refuse.
#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <vector>

#include "motion/error.h"
#include "tests/runtime/selector_samples.h"
#include "tests/scenes/not_finite.h"
#include "train/fit/selector_writer.h"

namespace flinch::runtime {
namespace {

using models::Selector;
using motion::Target;
using tests::kNan;
using tests::kNanDouble;

using Faults = std::vector<std::function<void(Selector&)>>;

void expect_refused(const Selector& sound, const Faults& faults) {
  ASSERT_NO_THROW(train::selector_bytes(sound));
  for (std::size_t i = 0; i < faults.size(); ++i) {
    Selector faulty = sound;
    faults[i](faulty);
    EXPECT_THROW(train::selector_bytes(faulty), Error) << "fault " << i;
  }
}

models::SvmModel& svm(Selector& s) {
  return std::get<models::SvmModel>(s.model);
}
models::KnnModel& knn(Selector& s) {
  return std::get<models::KnnModel>(s.model);
}
models::NetworkModel& network(Selector& s) {
  return std::get<models::NetworkModel>(s.model);
}
models::PairwiseModel& pairwise(Selector& s) {
  return std::get<models::PairwiseModel>(s.model);
}

TEST(SelectorFault, OfAnyModelIsNotWritten) {
  expect_refused(
      tests::svm_selector(),
      {[](Selector& s) { s.idle = 8; }, [](Selector& s) { s.idle = -1; },
       [](Selector& s) { s.clips.clear(); }, [](Selector& s) { s.layout = {}; },
       [](Selector& s) { s.layout = features::feature_set_named("geometry")->layout; },
       [](Selector& s) { s.scaling.min.pop_back(); },
       [](Selector& s) { s.scaling.max[3] = kNanDouble; },
       [](Selector& s) { s.scaling.min[3] = s.scaling.max[3] + 1; },
       [](Selector& s) { s.brawn = kNanDouble; }, [](Selector& s) { s.brawn = 1.5; },
       [](Selector& s) { s.clips[2].annotation->target = static_cast<Target>(4); },
       [](Selector& s) { s.clips[2].annotation->degree = static_cast<motion::Degree>(2); },
       [](Selector& s) { s.clips[2].annotation->direction = kNan; },
       [](Selector& s) { s.target_centres[motion::Target::legs].z() = kNan; }});
}

TEST(SelectorFault, OfKindsIsNotWritten) {
  expect_refused(tests::knn_selector(),
                 {[](Selector& s) { s.kinds.clear(); },
                  [](Selector& s) { s.kinds.resize(features::kMaxThreatKinds + 1); },
                  [](Selector& s) { s.kinds[1].name = ""; },
                  [](Selector& s) { s.kinds[1].name = "bell\a"; },
                  [](Selector& s) { s.kinds[1].mass_kg.min = kNanDouble; },
                  [](Selector& s) {
                    s.kinds[1].speed_mps = {9, 3};
                  },
                  [](Selector& s) { s.kinds[1].radius_m.max = 1e300; },
                  [](Selector& s) { s.kinds[1].bounce.restitution = 1.5; },
                  [](Selector& s) { s.kinds[1].bounce.friction = -1; },
                  [](Selector& s) { s.kinds[1].shape = static_cast<features::ThreatShape>(4); },
                  [](Selector& s) { s.kinds[1].reach_m = {}; },
                  [](Selector& s) { s.kinds[1].falls = true; },
                  [](Selector& s) {
                    s.kinds[0].reach_m = {0.5, 1};
                  },
                  [](Selector& s) { s.kinds[0].rod.balance = 0.5; },
                  [](Selector& s) { s.kinds[2].rod.length_m.max = 5.1; },
                  [](Selector& s) { s.kinds[2].rod.length_m.min = 1.0 / 20; },
                  [](Selector& s) { s.kinds[2].rod.strikes_at.max = 1.1; },
                  [](Selector& s) { s.kinds[2].rod.grip_share.min = -0.1; },
                  [](Selector& s) { s.kinds[2].rod.balance = kNanDouble; },
                  [](Selector& s) { s.kinds[2].rod.grip_mass_kg = -1; },
                  [](Selector& s) { s.kinds[2].reach_m = {}; }});
}

TEST(SelectorFault, OfCostsIsNotWritten) {
  expect_refused(
      tests::knn_selector(),
      {[](Selector& s) { s.costs->vulnerability[motion::Body::head] = kNanDouble; },
       [](Selector& s) { s.costs->vulnerability[motion::Body::head] = -1; },
       [](Selector& s) { s.costs->reference_damage_ns[1] = 0; },
       [](Selector& s) { s.costs->reference_damage_ns.push_back(1); },
       [](Selector& s) { s.costs->reference_work_j = 0; },
       [](Selector& s) { s.costs->reference_work_j = kNanDouble; },
       [](Selector& s) { s.costs->work_j.pop_back(); },
       [](Selector& s) { s.costs->work_j[3] = -1; },
       [](Selector& s) { s.costs->work_j[3] = kNan; },
       [](Selector& s) { s.costs->phase_count = 0, s.costs->work_j.clear(); },
       [](Selector& s) { s.costs->time_count = -3, s.costs->phase_count = -2; },
       [](Selector& s) { s.costs->min_time_s = kNan; },
       [](Selector& s) { s.costs->time_step_s = 0; },
       [](Selector& s) { s.costs->vulnerability_name = "bell\a"; },
       [](Selector& s) { s.costs->of_stance[0].stance = 0; },
       [](Selector& s) { s.costs->of_stance[0].stance = 3; },
       [](Selector& s) { s.costs->of_stance[1].stance = 8; },
       [](Selector& s) { s.costs->of_stance[1].stance = -1; },
       [](Selector& s) { s.costs->of_stance[0].phase_count = 8; },
       [](Selector& s) { s.costs->of_stance[0].phase_count = -4; },
       [](Selector& s) { s.costs->of_stance[0].work_j.pop_back(); },
       [](Selector& s) { s.costs->of_stance[0].work_j.clear(); },
       [](Selector& s) { s.costs->of_stance[1].work_j[3] = -1; },
       [](Selector& s) { s.costs->of_stance[1].work_j[3] = kNan; },
       [](Selector& s) { s.costs->of_kind[0].kind = -1; },
       [](Selector& s) { s.costs->of_kind[0].kind = 2; },
       [](Selector& s) { s.costs->of_kind[1].kind = 3; },
       [](Selector& s) { s.costs->of_kind[1].vulnerability[motion::Body::neck] = kNanDouble; }});
}

TEST(SelectorFault, OfAnSvmIsNotWritten) {
  expect_refused(tests::svm_selector(),
                 {[](Selector& s) { svm(s).label[1] = 8; },
                  [](Selector& s) { svm(s).label[1] = svm(s).label[0]; },
                  [](Selector& s) { svm(s).label.clear(); },
                  [](Selector& s) { svm(s).vectors_of_class[0] += 1; },
                  [](Selector& s) { svm(s).vectors_of_class[0] = -1; },
                  [](Selector& s) { svm(s).vectors_of_class.pop_back(); },
                  [](Selector& s) { svm(s).support_vectors.pop_back(); },
                  [](Selector& s) { svm(s).coefficients.pop_back(); },
                  [](Selector& s) { svm(s).machines.pop_back(); },
                  [](Selector& s) { svm(s).machines[0].rho = kNanDouble; },
                  [](Selector& s) { svm(s).machines[0].count[0] += 1; },
                  [](Selector& s) { svm(s).vectors.pop_back(); },
                  [](Selector& s) { svm(s).vectors[0] = 65535; },
                  [](Selector& s) { svm(s).vectors[1] = svm(s).vectors[0]; },
                  [](Selector& s) { svm(s).bound.pop_back(); },
                  [](Selector& s) { svm(s).bound[0] = kNanDouble; },
                  [](Selector& s) { svm(s).bound[0] = -1; },
                  [](Selector& s) { svm(s).kernel = static_cast<models::SvmKernel>(2); },
                  [](Selector& s) { svm(s).coefficients[2] = -1; },
                  [](Selector& s) { svm(s).gamma = -1; },
                  [](Selector& s) { svm(s).coefficients[2] = kNanDouble; },
                  [](Selector& s) { svm(s).support_vectors[2] = kNan; },
                  [](Selector& s) { svm(s).gamma = kNanDouble; },
                  [](Selector& s) { svm(s).degree = -1; }});
}

TEST(SelectorFault, InThePaddingOfAnSvmIsNotWritten) {
  const Selector selector = tests::rbf_selector();
  const auto fill = static_cast<std::size_t>(selector.layout.size());
  expect_refused(selector, {[fill](Selector& s) { svm(s).support_vectors[fill] = 1; }});
}

TEST(SelectorFault, OfKnnIsNotWritten) {
  expect_refused(
      tests::knn_selector(),
      {[](Selector& s) { knn(s).k = 0; },
       [](Selector& s) { knn(s).vote = static_cast<models::KnnVote>(2); },
       [](Selector& s) { knn(s).label[5] = -1; }, [](Selector& s) { knn(s).label.pop_back(); },
       [](Selector& s) { knn(s).label.clear(), knn(s).points.clear(); },
       [](Selector& s) { knn(s).points[5] = kNan; }});
}

TEST(SelectorFault, OfKnnByCostIsNotWritten) {
  expect_refused(
      tests::knn_cost_selector(),
      {[](Selector& s) { knn(s).cost.pop_back(); }, [](Selector& s) { knn(s).cost.clear(); },
       [](Selector& s) { knn(s).vote = models::KnnVote::majority; },
       [](Selector& s) { knn(s).k = 1001; }, [](Selector& s) { knn(s).cost_step_ns = 0; },
       [](Selector& s) { knn(s).cost_step_ns = kNan; }});
}

TEST(SelectorFault, OfANetworkIsNotWritten) {
  expect_refused(tests::network_selector(),
                 {[](Selector& s) { network(s).clip[1] = network(s).clip[0]; },
                  [](Selector& s) { network(s).clip.back() = 8; },
                  [](Selector& s) { network(s).clip.clear(); },
                  [](Selector& s) { network(s).hidden_count = 24; },
                  [](Selector& s) { network(s).hidden_count = 0; },
                  [](Selector& s) { network(s).member_count = 3; },
                  [](Selector& s) { network(s).member_count = 0; },
                  [](Selector& s) { network(s).weights.pop_back(); },
                  [](Selector& s) { network(s).weights[7] = kNan; },
                  [](Selector& s) { network(s).weights[7] = -2e4F; },
                  [](Selector& s) { network(s).scale_root = 0; },
                  [](Selector& s) { network(s).mean_root = kNan; },
                  [](Selector& s) { network(s).variance_ns = -1; }});
}

TEST(SelectorFault, OfPairwiseMachinesIsNotWritten) {
  expect_refused(tests::pairwise_selector(),
                 {[](Selector& s) { pairwise(s).clip[1] = pairwise(s).clip[0]; },
                  [](Selector& s) { pairwise(s).clip.back() = 8; },
                  [](Selector& s) { pairwise(s).clip.pop_back(); },
                  [](Selector& s) { pairwise(s).clip.clear(), pairwise(s).machine.clear(); },
                  [](Selector& s) { pairwise(s).machine.pop_back(); },
                  [](Selector& s) { pairwise(s).machine[2] = -2; },
                  [](Selector& s) { pairwise(s).machine[2] = 28; },
                  [](Selector& s) { pairwise(s).weights.pop_back(); },
                  [](Selector& s) { pairwise(s).weights.resize(27 * pairwise(s).row_size()); },
                  [](Selector& s) { std::fill_n(pairwise(s).weights.end() - 17, 17, 0x7FFF); },
                  [](Selector& s) { std::fill_n(pairwise(s).weights.begin(), 17, -0x8000); }});
}

}  // namespace
}  // namespace flinch::runtime
