// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "train/store/store.h"

namespace flinch::train {

/// Returns the layout of a feature set (features::feature_sets) for the scenarios of a store: with
/// size, mass and kind of the threats where these differ, and with what the character's stance does
/// where there are several.
features::Layout layout_for(std::string_view set, const StoreHeader& header);

/// Computes the features of a layout for observations, from their scenarios and the library in
/// their store's header, as a game computes them. Throws Error if that library cannot be used.
void derive_features(const features::Layout& layout, const StoreHeader& header,
                     std::span<Observation> observations);

/// Does the same for a whole store, and stores the layout in its header.
void derive_features(const features::Layout& layout, Store& store);

}  // namespace flinch::train
