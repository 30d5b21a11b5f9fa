// SPDX-License-Identifier: MIT
#include "models/selector.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace flinch::models {

std::vector<Candidate> candidates(const SvmModel& model, std::span<const double> scaled,
                                  const std::vector<bool>& allowed_clips, int idle) {
  std::vector<char> allowed(model.label.size());
  std::vector<std::size_t> classes;
  for (std::size_t c = 0; c < model.label.size(); ++c) {
    allowed[c] = allowed_clips[static_cast<std::size_t>(model.label[c])];
    if (allowed[c]) {
      classes.push_back(c);
    }
  }
  if (classes.empty()) {
    return {{idle, 0.0F}};
  }
  if (classes.size() == 1) {
    return {{model.label[classes[0]], 1.0F}};
  }
  std::vector<int> votes(model.label.size());
  vote(model, scaled, allowed, votes);
  std::stable_sort(classes.begin(), classes.end(),
                   [&](std::size_t a, std::size_t b) { return votes[a] > votes[b]; });
  const auto machines = static_cast<float>(classes.size() * (classes.size() - 1) / 2);
  std::vector<Candidate> ranked;
  ranked.reserve(classes.size());
  for (const std::size_t c : classes) {
    ranked.push_back({model.label[c], static_cast<float>(votes[c]) / machines});
  }
  return ranked;
}

std::vector<Candidate> candidates(const KnnModel& model, std::span<const double> scaled,
                                  const std::vector<bool>& allowed_clips, int idle) {
  std::vector<Candidate> ranked =
      count_votes(nearest(model, scaled, model.k, allowed_clips), model.label, model.vote);
  if (ranked.empty()) {
    ranked.push_back({idle, 0.0F});
  }
  return ranked;
}

std::vector<Candidate> candidates(const Selector& selector, const features::FeatureVector& x,
                                  motion::Target threatened) {
  std::array<double, features::kFeatureCount> scaled{};
  selector.scaling.apply(x, scaled);
  const std::vector<bool> allowed = allowed_clips(selector.clips, selector.idle, threatened);
  return std::visit(
      [&](const auto& model) { return candidates(model, scaled, allowed, selector.idle); },
      selector.model);
}

int select(const Selector& selector, const features::FeatureVector& x, motion::Target threatened) {
  return candidates(selector, x, threatened).front().clip;
}

std::vector<bool> allowed_clips(std::span<const ClipSummary> clips, int idle,
                                motion::Target threatened) {
  std::vector<bool> allowed(clips.size());
  for (std::size_t i = 0; i < clips.size(); ++i) {
    allowed[i] =
        static_cast<int>(i) == idle || features::is_allowed(threatened, clips[i].annotation);
  }
  return allowed;
}

}  // namespace flinch::models
