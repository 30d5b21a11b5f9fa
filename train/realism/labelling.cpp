// SPDX-License-Identifier: MIT
#include "train/realism/labelling.h"

#include <algorithm>
#include <cmath>

namespace flinch::train {
namespace {

bool is_above(float quality) {
  return quality > runtime::kGoodRealism;
}

}  // namespace

bool agrees(std::size_t count, double same_side, double mean_error, std::size_t good) {
  constexpr double kSameSide = 0.85;
  constexpr double kMeanError = 0.15;
  constexpr std::size_t kOfEitherSide = 5;
  return count >= kRecentAnswers && same_side >= kSameSide && mean_error <= kMeanError &&
         good >= kOfEitherSide && count - good >= kOfEitherSide;
}

Labelling::Labelling(const runtime::PushResponses& responses, std::uint64_t seed)
    : responses_(responses), seed_(seed) {
  next();
}

void Labelling::add(std::span<const Label> labels) {
  LabelledConfigurations more =
      configurations_of(responses_, std::vector<Label>(labels.begin(), labels.end()));
  std::ranges::move(more.labels, std::back_inserter(all_.labels));
  std::ranges::move(more.character, std::back_inserter(all_.character));
  std::ranges::move(more.response, std::back_inserter(all_.response));
  fit();
}

void Labelling::next() {
  features::Random random(seed_, features::RandomStream::realism, drawn_++);
  example_ = sample_example(responses_, random);
  estimate_.reset();
  if (!model_) return;
  const LabelledConfigurations one = configurations_of(responses_, {{example_, 0, "", ""}});
  estimate_ = models::estimate_realism(*model_, features_of(*model_, one, 0));
}

void Labelling::judge(float quality) {
  if (estimate_) {
    recent_.push_back({*estimate_, quality});
    if (recent_.size() > kRecentAnswers) recent_.pop_front();
    double same = 0;
    double error = 0;
    std::size_t good = 0;
    for (const Answer& answer : recent_) {
      same += is_above(answer.estimate) == is_above(answer.quality) ? 1 : 0;
      error += std::abs(double{answer.estimate} - double{answer.quality});
      good += is_above(answer.quality) ? 1 : 0;
    }
    const double count = static_cast<double>(recent_.size());
    agreement_ = {recent_.size(), same / count, error / count,
                  agrees(recent_.size(), same / count, error / count, good)};
  }
  const Label label{example_, quality, "", ""};
  add(std::span(&label, 1));
}

void Labelling::fit() {
  const std::size_t count = all_.labels.size();
  if (count <= models::kRealismNeighbours || count > models::kMaxRealismExamples) return;
  if (count * 10 >= fitted_count_ * 11) {
    factors_ = fit_factors(all_);
    fitted_count_ = count;
  }
  model_ = fit_realism_with(all_, factors_, "");
}

}  // namespace flinch::train
