// SPDX-License-Identifier: MIT
#include "train/realism/realism_evaluation.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace flinch::train {
namespace {

bool is_good(float quality) {
  return quality > runtime::kGoodRealism;
}

/// At most `count` of the indices, spread evenly.
std::vector<std::size_t> thinned(const std::vector<std::size_t>& indices, std::size_t count) {
  if (indices.size() <= count) return indices;
  std::vector<std::size_t> some;
  for (std::size_t k = 0; k < count; ++k) some.push_back(indices[k * indices.size() / count]);
  return some;
}

}  // namespace

double area_under_curve(std::span<const float> scores, const std::vector<bool>& good) {
  double won = 0;
  double pairs = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!good[i]) continue;
    for (std::size_t j = 0; j < scores.size(); ++j) {
      if (good[j]) continue;
      pairs += 1;
      won += scores[i] > scores[j] ? 1 : scores[i] < scores[j] ? 0 : 0.5;
    }
  }
  return pairs > 0 ? won / pairs : 0.5;
}

RealismAgreement held_out_agreement(const LabelledConfigurations& all, RealismKind kind,
                                    std::size_t most_labels) {
  const std::size_t count = all.labels.size();
  std::set<std::string> sittings;
  for (const Label& label : all.labels) sittings.insert(label.sitting);
  std::vector<float> estimates(count);
  for (const std::string& sitting : sittings) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < count; ++i) {
      if (all.labels[i].sitting != sitting) others.push_back(i);
    }
    const models::RealismModel model =
        fit_realism(part_of(all, thinned(others, most_labels)), kind, "");
    for (std::size_t i = 0; i < count; ++i) {
      if (all.labels[i].sitting == sitting)
        estimates[i] = models::estimate_realism(model, features_of(model, all, i));
    }
  }
  RealismAgreement result;
  result.count = count;
  std::vector<bool> good;
  std::vector<float> nearness;
  double agreeing = 0;
  for (std::size_t i = 0; i < count; ++i) {
    good.push_back(is_good(all.labels[i].quality));
    nearness.push_back(-(all.character[i] - all.response[i]).norm());
    agreeing += is_good(estimates[i]) == good[i] ? 1 : 0;
  }
  const double total = static_cast<double>(count);
  const double good_share = static_cast<double>(std::ranges::count(good, true)) / total;
  result.agreement = agreeing / total;
  result.chance = std::max(good_share, 1 - good_share);
  result.auc = area_under_curve(estimates, good);
  result.baseline_auc = area_under_curve(nearness, good);
  return result;
}

}  // namespace flinch::train
