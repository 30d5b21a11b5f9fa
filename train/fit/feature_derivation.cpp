// SPDX-License-Identifier: MIT
#include "train/fit/feature_derivation.h"

#include "database/library/library_file.h"
#include "motion/error.h"

namespace flinch::train {

features::Layout layout_for(std::string_view set, const StoreHeader& header) {
  const features::Layout layout =
      features::with_kinds(features::feature_set_named(set)->layout, header.kinds);
  return header.stances.empty() ? layout : features::with_stances(layout);
}

void derive_features(const features::Layout& layout, const StoreHeader& header,
                     std::span<Observation> observations) {
  database::ClipLibrary library;
  const database::LoadStatus status = database::read_embedded_library(header.library_file, library);
  if (status != database::LoadStatus::ok)
    throw Error("", std::string("the library in the store ") + database::message_of(status) +
                        "; simulate it again");
  const motion::BodyModel model = motion::make_body_model(library.character);
  const std::vector<motion::Loop> stances = stance_loops(library);
  for (Observation& observation : observations) {
    const auto stance = static_cast<std::size_t>(observation.scenario.state.stance);
    const features::IdlingFigure figure{&library.character.skeleton, &model, stances[stance]};
    observation.features = features::feature_vector(layout, observation.scenario, figure);
  }
}

void derive_features(const features::Layout& layout, Store& store) {
  derive_features(layout, store.header, store.observations);
  store.header.layout = layout;
}

}  // namespace flinch::train
