// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <span>
#include <string>

#include "database/files/file_io.h"
#include "database/files/library_writer.h"
#include "database/library/file_header.h"
#include "features/random.h"
#include "tests/scenes/synthetic_library.h"
#include "tests/scenes/temporary_folder.h"
#include "train/scenario/scenario_sampling.h"
#include "train/store/store.h"

namespace flinch::train {

using database::read_file;
using tests::TemporaryFolder;

/// The header of a store of the synthetic library, with round numbers.
inline StoreHeader made_up_header() {
  const database::ClipLibrary library = scenes::synthetic_library();
  StoreHeader header;
  const std::string file = database::library_bytes(library);
  const auto bytes = std::as_bytes(std::span(file));
  header.library_file.assign(bytes.begin(), bytes.end());
  header.library_hash = database::verify_file(database::kLibraryFormat, bytes).hash;
  header.library_name = library.name;
  header.seed = 5;
  header.distribution = "{\"made\":\"up\"}";
  header.simulation = "{\"made\":\"up too\"}";
  header.reference_impulse_ns = 13.77;
  header.keeps_places = true;
  header.reference_work_j = 250;
  for (const motion::Clip& clip : library.clips) {
    header.clips.push_back({clip.name, clip.annotation});
    header.clip_work_j.push_back(clip.annotation ? 250 : 0);
  }
  for (const motion::Target target : motion::kTargets)
    header.idle_target_centres[target] = {0.01F, 0, 1.6F - 0.35F * static_cast<float>(target)};
  return header;
}

/// A scenario whose best clip follows from the threat's direction, without simulation: the impulse
/// of a clip grows with the angle between its direction and the threat's.
inline Observation made_up_observation(const StoreHeader& header, std::uint64_t number) {
  static const database::ClipLibrary kLibrary = scenes::synthetic_library();
  static const motion::BodyModel kModel = motion::make_body_model(kLibrary.character);
  Observation observation;
  observation.number = number;
  observation.scenario = sample_scenario(kLibrary, kModel, {}, header.seed, number);
  observation.features =
      features::to_vector(features::features_of(observation.scenario, kLibrary.clips[0].motion));
  const float azimuth = azimuth_of(observation.scenario);
  for (int clip = 0; clip < static_cast<int>(header.clips.size()); ++clip) {
    const auto& annotation = header.clips[static_cast<std::size_t>(clip)].annotation;
    if (clip != header.idle && !features::is_allowed(observation.scenario.target, annotation))
      continue;
    Trial trial;
    trial.clip = clip;
    trial.work_j = annotation ? 100.0F + static_cast<float>(clip) : 0;
    trial.impulse[motion::Body::head] =
        annotation ? 2 * (1 - std::cos(azimuth - annotation->direction)) : 5;
    trial.impulse[motion::Body::left_hand] = 0.125F;
    observation.trials.push_back(trial);
    const auto turned = static_cast<std::int16_t>(10 * clip - 40);
    observation.places.push_back({clip, motion::Body::left_hand, 0.125F, {5, turned, -14}});
    observation.places.push_back(
        {clip, motion::Body::head, trial.impulse[motion::Body::head], {90, turned, 120}});
  }
  return observation;
}

inline std::vector<Observation> made_up_observations(const StoreHeader& header, std::uint64_t first,
                                                     std::uint64_t end) {
  std::vector<Observation> observations;
  for (std::uint64_t number = first; number < end; ++number)
    observations.push_back(made_up_observation(header, number));
  return observations;
}

/// More scenarios than any test appends.
inline constexpr ScenarioRange kWanted{0, 200};

/// Writes a whole store, or completes one, in batches of 16 scenarios.
inline void write_store(const std::string& path, const StoreHeader& header, std::uint64_t count) {
  StoreWriter writer(path, header, {0, count});
  while (!writer.missing().empty()) {
    const ScenarioRange missing = writer.missing().front();
    writer.append(
        made_up_observations(header, missing.first, std::min(missing.end(), missing.first + 16)));
  }
  writer.finish();
}

}  // namespace flinch::train
