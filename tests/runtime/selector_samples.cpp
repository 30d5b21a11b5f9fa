// SPDX-License-Identifier: MIT
#include "tests/runtime/selector_samples.h"

#include <numbers>

#include "models/fit/knn_fit.h"
#include "models/fit/network_fit.h"
#include "models/fit/pairwise_linear_fit.h"
#include "models/fit/svm_fit.h"
#include "runtime/selector_file.h"
#include "tests/models/training_sets.h"

namespace flinch::tests {

using models::Selector;
using motion::Target;

namespace {

models::TrainingSet training_set() {
  return models::random_clouds(1, 80, 4, features::kFeatureCount);
}

}  // namespace

Selector selector_without_model() {
  Selector selector;
  selector.library_hash = 0xFEDCBA9876543210;
  for (int clip = 0; clip < 7; ++clip) {
    selector.clips.push_back({"clip \"" + std::to_string(clip) + "\"",
                              motion::Annotation{.target = static_cast<Target>(clip % 4),
                                                 .direction = -std::numbers::pi_v<float> / 4 *
                                                              static_cast<float>(clip % 4),
                                                 .degree = motion::Degree::exaggerated,
                                                 .onset_s = 1.0F / 3,
                                                 .peak_s = 2.0F / 3,
                                                 .end_s = 1}});
  }
  selector.clips.push_back({"idle", std::nullopt});
  selector.idle = 7;
  selector.layout = features::feature_set_named("paper")->layout;
  for (int i = 0; i < features::kFeatureCount; ++i) {
    selector.scaling.min.push_back(-1.0 / (i + 3));
    selector.scaling.max.push_back(1.0 / (i + 7));
  }
  selector.brawn = 0.1;
  for (Eigen::Vector3f& centre : selector.target_centres) centre = {0.1F, -0.2F, 1.0F / 3};
  models::ResponseCosts& costs = selector.costs.emplace();
  for (double& vulnerability : costs.vulnerability) vulnerability = 1.0 / 3;
  costs.reference_damage_ns = {100.0 / 7, 100.0 / 3, 100.0 / 9};
  costs.reference_work_j = 1000.0 / 7;
  costs.phase_count = 2;
  costs.time_count = 3;
  costs.min_time_s = 0.25F;
  costs.time_step_s = 1.0F / 30;
  costs.vulnerability_name = "armour";
  for (const int kind : {1, 2}) {
    costs.of_kind.push_back({kind, costs.vulnerability});
    costs.of_kind.back().vulnerability[motion::Body::head] = 1.0 / (3 + kind);
  }
  selector.kinds.push_back({.name = "stone",
                            .radius_m = {1.0 / 30, 1.0 / 20},
                            .mass_kg = {1.0 / 7, 1.0 / 3},
                            .elevation = {-1.0 / 3, 1},
                            .bounce = {1.0 / 3, 2.0 / 3},
                            .falls = false,
                            .shape = features::ThreatShape::fist,
                            .reach_m = {1.0 / 3, 2.0 / 3}});
  selector.kinds.push_back({.name = "bat",
                            .radius_m = {1.0 / 30, 1.0 / 30},
                            .falls = false,
                            .shape = features::ThreatShape::rod,
                            .reach_m = {1.0 / 3, 2.0 / 3},
                            .rod = {.length_m = {2.0 / 3, 1},
                                    .strikes_at = {1.0 / 3, 1},
                                    .tilt = {-1.0 / 3, 1.0 / 7},
                                    .grip_share = {1.0 / 9, 1.0 / 3},
                                    .balance = 2.0 / 3,
                                    .grip_mass_kg = 2}});
  for (std::size_t i = 0; i < 6 * selector.clips.size(); ++i)
    costs.work_j.push_back(static_cast<float>(i) / 3);
  for (const int stance : {1, 3}) {
    costs.of_stance.push_back({stance, {}, 4});
    for (std::size_t i = 0; i < 12 * selector.clips.size(); ++i)
      costs.of_stance.back().work_j.push_back(static_cast<float>(i) / 7);
  }
  return selector;
}

Selector svm_selector() {
  Selector selector = selector_without_model();
  selector.model = models::fit_svm(training_set(), {3, 1.0 / 3, 1.0 / 7, 10});
  return selector;
}

Selector rbf_selector() {
  Selector selector = selector_without_model();
  selector.layout = features::feature_set_named("geometry")->layout;
  const int features = selector.layout.size();
  selector.scaling.min.assign(static_cast<std::size_t>(features), -1.0 / 3);
  selector.scaling.max.assign(static_cast<std::size_t>(features), 1.0 / 7);
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

database::LoadStatus read(const std::string& bytes, Selector& selector) {
  return runtime::read_selector(database::bytes_of(bytes), selector);
}

}  // namespace flinch::tests
