// SPDX-License-Identifier: MIT
#include "evolve/label/pain_labels.h"

#include <algorithm>

#include "database/library/library_file.h"
#include "motion/error.h"

namespace flinch::evolve {
namespace {

using motion::Body;

/// The largest multiplier on each body.
motion::PerBody<double> largest_multipliers(const PainMap& map) {
  motion::PerBody<double> largest;
  for (const Body body : motion::kBodies)
    for (const PainRegion region : regions_of(body))
      largest[body] = std::max(largest[body], map.multiplier[region]);
  return largest;
}

motion::BodyModel body_model_of(const train::StoreHeader& header, const std::string& path) {
  database::ClipLibrary library;
  if (database::read_embedded_library(header.library_file, library) != database::LoadStatus::ok)
    throw Error(path, "its library is damaged; delete it and run `flinch simulate` again");
  return motion::make_body_model(library.character);
}

}  // namespace

train::VulnerabilityProfile largest_pain(const PainMap& map, const std::string& name) {
  train::VulnerabilityProfile profile{name, largest_multipliers(map)};
  const double worst = *std::ranges::max_element(profile.vulnerability);
  for (double& value : profile.vulnerability) value /= worst;
  return profile;
}

void relabel_by_pain(const PainMap& map, train::Store& store, const std::string& path) {
  if (!store.header.keeps_places)
    throw Error(path,
                "keeps no places of hits, which --pain needs; simulate it again with --places");
  const motion::BodyModel bodies = body_model_of(store.header, path);
  const motion::PerBody<double> largest = largest_multipliers(map);
  for (train::Observation& observation : store.observations) {
    auto place = observation.places.begin();
    for (train::Trial& trial : observation.trials) {
      motion::PerBody<double> pain;
      for (; place != observation.places.end() && place->clip == trial.clip; ++place)
        pain[place->body] += map.multiplier[pain_region_at(bodies, place->body, point_of(*place))] *
                             double{place->impulse_ns};
      for (const Body body : motion::kBodies)
        trial.impulse[body] =
            static_cast<float>(largest[body] > 0 ? pain[body] / largest[body] : 0);
    }
  }
}

}  // namespace flinch::evolve
