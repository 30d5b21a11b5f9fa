// SPDX-License-Identifier: MIT
#include "train/fit/training.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "models/fit/cross_validation.h"
#include "models/fit/knn_fit.h"
#include "models/fit/network_fit.h"
#include "models/fit/pairwise_linear_fit.h"
#include "models/fit/svm_fit.h"
#include "motion/error.h"
#include "train/fit/labels.h"
#include "train/fit/response_costs.h"

namespace flinch::train {

namespace {

constexpr int kMaxFolds = 5;
constexpr int kMaxDegree = 10;  // (gamma x·y + coef0)^degree: beyond it, floats overflow

/// Result of fitting a method to a training set.
struct Fitted {
  decltype(models::Selector::model) model;
  std::vector<NamedValue> parameters;
  double mean_regret_ns = 0;
};
using Fit = Fitted (*)(const models::TrainingSet&, std::span<const int> folds,
                       const models::LossFunction& regret, const FixedParameters& fixed);

Fitted fit_knn(const models::TrainingSet& set, std::span<const int> folds,
               const models::LossFunction& regret, const FixedParameters& fixed) {
  const std::vector<models::KnnParameters> grid = narrow(models::knn_grid(), fixed);
  const auto chosen = models::choose_parameters(set, grid, folds, regret);
  const models::KnnParameters& parameters = chosen.parameters;
  const bool majority = parameters.vote == models::KnnVote::majority;
  return {models::fit_knn(set, parameters),
          {{"k", parameters.k}, {"vote", majority ? "majority" : "inverse_distance"}},
          chosen.mean_score};
}

Fitted fit_knn_cost(const models::TrainingSet& set, std::span<const int> folds,
                    const models::LossFunction& regret, const FixedParameters& fixed) {
  const std::vector<models::KnnParameters> grid = narrow(models::knn_cost_grid(), fixed);
  const auto chosen = models::choose_parameters(set, grid, folds, regret);
  return {models::fit_knn(set, chosen.parameters), {{"k", chosen.parameters.k}}, chosen.mean_score};
}

/// For models that take long to fit, parameters are chosen on at most 5000 observations and on as
/// few folds as separate the candidates.
template <typename Parameters>
models::TunedParameters<Parameters> choose_on_subset(const models::TrainingSet& set,
                                                     const std::vector<Parameters>& grid,
                                                     std::span<const int> folds,
                                                     const models::LossFunction& regret) {
  constexpr int kMaxTuningObservations = 5000;
  std::vector<int> subset;
  std::vector<int> subset_folds;
  const int step = 1 + (set.size() - 1) / kMaxTuningObservations;
  for (int i = 0; i < set.size(); i += step) {
    subset.push_back(i);
    subset_folds.push_back(folds[static_cast<std::size_t>(i)]);
  }
  const models::LossFunction subset_regret = [&](int observation, int clip) {
    return regret(subset[static_cast<std::size_t>(observation)], clip);
  };
  return models::choose_parameters(models::subset(set, subset), std::span<const Parameters>(grid),
                                   models::limit_folds(subset_folds), subset_regret);
}

Fitted fit_svm_with(models::SvmKernel kernel, const models::TrainingSet& set,
                    std::span<const int> folds, const models::LossFunction& regret,
                    const FixedParameters& fixed) {
  const auto grid = narrow(models::svm_grid(set.feature_count, kernel), fixed, set.feature_count);
  const auto chosen = choose_on_subset(set, grid, folds, regret);
  const models::SvmParameters& parameters = chosen.parameters;
  std::vector<NamedValue> named;
  if (kernel == models::SvmKernel::polynomial) {
    named = {{"kernel", "polynomial"}, {"degree", parameters.degree}, {"coef0", parameters.coef0}};
  } else {
    named = {{"kernel", "rbf"}};
  }
  named.push_back({"gamma", parameters.gamma});
  named.push_back({"c", parameters.cost});
  return {models::fit_svm(set, parameters), named, chosen.mean_score};
}

Fitted fit_svm(const models::TrainingSet& set, std::span<const int> folds,
               const models::LossFunction& regret, const FixedParameters& fixed) {
  return fit_svm_with(models::SvmKernel::polynomial, set, folds, regret, fixed);
}

Fitted fit_svm_rbf(const models::TrainingSet& set, std::span<const int> folds,
                   const models::LossFunction& regret, const FixedParameters& fixed) {
  return fit_svm_with(models::SvmKernel::rbf, set, folds, regret, fixed);
}

Fitted fit_network(const models::TrainingSet& set, std::span<const int> folds,
                   const models::LossFunction& regret, const FixedParameters& /*has none*/) {
  const models::NetworkParameters parameters;
  const auto validation =
      models::validate_network(set, parameters, models::limit_folds(folds), regret);
  models::NetworkModel model = models::fit_network(set, parameters);
  model.variance_ns = static_cast<float>(validation.variance_ns);
  return {std::move(model),
          {{"members", parameters.member_count},
           {"hidden", parameters.hidden_count},
           {"epochs", parameters.epoch_count},
           {"weight_decay", parameters.weight_decay}},
          validation.mean_score};
}

Fitted fit_pairwise_cost(const models::TrainingSet& set, std::span<const int> folds,
                         const models::LossFunction& regret, const FixedParameters& fixed) {
  const auto chosen = choose_on_subset(set, narrow(models::pairwise_grid(), fixed), folds, regret);
  return {models::fit_pairwise(set, chosen.parameters),
          {{"c", chosen.parameters.c}, {"nearness", chosen.parameters.nearness}},
          chosen.mean_score};
}

struct MethodEntry {
  std::string_view name;
  Fit fit;
};
// In the order of the enumeration.
constexpr motion::EnumArray<Method, MethodEntry, 6> kMethodEntries{{{
    {"knn", fit_knn},
    {"svm", fit_svm},
    {"svm_rbf", fit_svm_rbf},
    {"knn_cost", fit_knn_cost},
    {"network", fit_network},
    {"pairwise_cost", fit_pairwise_cost},
}}};
constexpr auto kMethods = motion::all_enumerators<Method, 6>();

const MethodEntry& entry_of(Method method) {
  return kMethodEntries[method];
}

/// Throws Error for a given parameter that the method does not have or that is out of range.
void check(Method method, const FixedParameters& fixed) {
  const bool has_kernel = method == Method::svm || method == Method::svm_rbf;
  const bool has_neighbours = method == Method::knn || method == Method::knn_cost;
  struct Given {
    std::string_view name;
    bool is_given = false;
    bool is_of_method = false;
    bool is_in_range = true;
  };
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  const std::array given{
      Given{"k", fixed.k.has_value(), has_neighbours,
            fixed.k.value_or(1) >= 1 && fixed.k.value_or(1) <= models::kMaxNeighbours},
      Given{"c", fixed.c.has_value(), has_kernel || method == Method::pairwise_cost,
            positive(fixed.c.value_or(1))},
      Given{"gamma", fixed.gamma.has_value(), has_kernel, positive(fixed.gamma.value_or(1))},
      Given{"degree", fixed.degree.has_value(), method == Method::svm,
            fixed.degree.value_or(1) >= 1 && fixed.degree.value_or(1) <= kMaxDegree},
      Given{"coef0", fixed.coef0.has_value(), method == Method::svm,
            std::isfinite(fixed.coef0.value_or(0))},
      Given{"libsvm's defaults", fixed.libsvm_defaults, has_kernel},
  };
  for (const Given& parameter : given) {
    if (!parameter.is_given) continue;
    const std::string name(parameter.name);
    if (!parameter.is_of_method)
      throw Error("", name + " cannot be given for " + std::string(name_of(method)) +
                          ", which has no such parameter");
    if (!parameter.is_in_range) throw Error("", name + " is out of its range");
  }
}

std::string text_of(const NamedValue& parameter) {
  if (const auto* text = std::get_if<std::string>(&parameter.value)) return *text;
  if (const auto* count = std::get_if<int>(&parameter.value)) return std::to_string(*count);
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(),
                                 std::get<double>(parameter.value), std::chars_format::general, 6);
  return {text.data(), end.ptr};
}

std::string text_of(std::span<const NamedValue> parameters) {
  std::string text;
  for (const NamedValue& parameter : parameters)
    text += (text.empty() ? "" : ", ") + parameter.name + ' ' + text_of(parameter);
  return text;
}

}  // namespace

std::string_view name_of(Method method) {
  return entry_of(method).name;
}

std::optional<Method> method_named(std::string_view name) {
  const auto found = std::ranges::find(kMethodEntries, name, &MethodEntry::name);
  if (found == kMethodEntries.end()) return std::nullopt;
  return static_cast<Method>(found - kMethodEntries.begin());
}

std::span<const Method> methods() {
  return kMethods;
}

Training train_selector(const StoreHeader& header, std::span<const Observation> observations,
                        const CostModel& cost_model, Method method, std::uint64_t seed,
                        const FixedParameters& fixed) {
  check(method, fixed);
  if (observations.size() < 2)
    throw Error("", "training needs at least 2 scenarios and there are " +
                        std::to_string(observations.size()) + "; simulate more");
  if (!std::ranges::is_sorted(observations, {}, &Observation::number)) {
    std::vector<Observation> sorted(observations.begin(), observations.end());
    std::ranges::stable_sort(sorted, {}, &Observation::number);
    return train_selector(header, sorted, cost_model, method, seed, fixed);
  }
  const Labels labels = label(observations, cost_model);
  Training training;
  models::Selector& selector = training.selector;
  selector.library_hash = header.library_hash;
  selector.clips = header.clips;
  selector.idle = header.idle;
  selector.layout = header.layout;
  selector.kinds = header.kinds;
  selector.scaling = scaling_of(header, observations);
  selector.brawn = cost_model.brawn;
  selector.target_centres = header.idle_target_centres;
  selector.costs = response_costs(header, observations, cost_model);

  const models::TrainingSet set = make_training_set(header, observations, labels, selector.scaling);
  const std::vector<int> folds =
      models::assign_folds(set.label, std::min(kMaxFolds, set.size()), seed);
  const models::LossFunction regret = [&](int observation, int chosen) {
    const auto i = static_cast<std::size_t>(observation);
    return cost_of_choice(observations, labels, i, chosen) -
           cost_of_choice(observations, labels, i, labels.clip[i]);
  };
  Fitted fitted = entry_of(method).fit(set, folds, regret, fixed);
  selector.model = std::move(fitted.model);
  training.cross_validated_regret_ns = fitted.mean_regret_ns;
  for (int i = 0; i < set.size(); ++i) training.idle_regret_ns += regret(i, header.idle);
  training.idle_regret_ns /= set.size();
  training.parameters = text_of(fitted.parameters);
  training.parameter_values = std::move(fitted.parameters);
  return training;
}

}  // namespace flinch::train
