// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "database/files/library_writer.h"
#include "database/library/file_header.h"
#include "models/fit/knn_fit.h"
#include "models/fit/network_fit.h"
#include "models/fit/pairwise_linear_fit.h"
#include "models/fit/svm_fit.h"
#include "tests/models/training_sets.h"
#include "tests/scenes/synthetic_library.h"
#include "train/fit/selector_writer.h"

namespace flinch::tests {

/// The synthetic library's motions, repeated under as many names as requested, each held at its end
/// until it has `pose_count` poses. Clip 0 is the idle clip.
inline database::ClipLibrary made_up_library(int clip_count, std::size_t pose_count) {
  database::ClipLibrary library = scenes::synthetic_library();
  const std::vector<motion::Clip> posed(library.clips.begin() + 1, library.clips.end());
  library.clips.resize(1);
  for (std::size_t i = 1; i < static_cast<std::size_t>(clip_count); ++i) {
    motion::Clip clip = posed[i % posed.size()];
    clip.name.append(1, '_').append(std::to_string(i));
    clip.motion.poses.resize(pose_count, clip.motion.poses.back());
    library.clips.push_back(clip);
  }
  return library;
}

/// A library file, and a selector of its clips that was fitted to made-up observations, which
/// choose from all of its clips except stances.
struct MadeUpSelector {
  std::string library_file;
  models::Selector selector;

  std::span<const std::byte> library_bytes() const {
    return std::as_bytes(std::span(library_file));
  }
  /// The selector's file, with its clips.
  std::string file() const { return train::selector_bytes(selector, library_bytes()); }
};

enum class ModelKind : std::uint8_t { svm, knn, knn_cost, network, pairwise };

/// Another `seed` makes up other observations.
inline MadeUpSelector made_up_selector(const database::ClipLibrary& library, int observation_count,
                                       ModelKind model, std::uint64_t seed = 1) {
  MadeUpSelector made{database::library_bytes(library), {}};
  models::Selector& selector = made.selector;
  selector.library_hash =
      database::verify_file(database::kLibraryFormat, made.library_bytes()).hash;
  for (const motion::Clip& clip : library.clips)
    selector.clips.push_back({clip.name, clip.annotation});
  selector.idle = library.idle;
  selector.layout = features::feature_set_named("paper")->layout;
  selector.scaling.min.assign(features::kFeatureCount, -1);
  selector.scaling.max.assign(features::kFeatureCount, 1);
  const auto class_count =
      static_cast<int>(library.clips.size() - database::stance_clips(library).size());
  models::TrainingSet set =
      models::random_clouds(seed, observation_count, class_count, features::kFeatureCount);
  for (int& label : set.label) label = 1 + label / 2;
  set.masks = {models::ClipMask(library.clips.size(), true)};
  switch (model) {
    case ModelKind::svm:
      selector.model =
          models::fit_svm(set, models::default_svm_parameters(features::kFeatureCount));
      break;
    case ModelKind::knn:
      selector.model = models::fit_knn(set, {10, models::KnnVote::inverse_distance});
      break;
    case ModelKind::knn_cost:
      selector.model = models::fit_knn(models::with_costs(set, 2), {10, models::KnnVote::cost});
      break;
    case ModelKind::network:
      selector.model = models::fit_network(models::with_costs(set, 2), {.epoch_count = 1});
      break;
    case ModelKind::pairwise:
      selector.model = models::fit_pairwise(models::with_costs(set, 2), {});
      break;
  }
  return made;
}

/// The same with made-up costs of its clips, which looking ahead needs.
inline MadeUpSelector with_response_costs(MadeUpSelector made) {
  models::ResponseCosts& costs = made.selector.costs.emplace();
  for (double& vulnerability : costs.vulnerability) vulnerability = 0.5;
  costs.reference_damage_ns = {13};
  costs.reference_work_j = 300;
  costs.work_j.assign(made.selector.clips.size(), 40);
  return made;
}

}  // namespace flinch::tests
