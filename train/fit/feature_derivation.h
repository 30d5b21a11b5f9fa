// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "train/store/store.h"

namespace flinch::train {

/// Gives observations the features of a layout, from their scenarios and the library that stands in
/// their store's header, as a game computes them. Throws Error when that library cannot be used.
void derive_features(const features::Layout& layout, const StoreHeader& header,
                     std::span<Observation> observations);

/// The same of a whole store, which keeps the layout.
void derive_features(const features::Layout& layout, Store& store);

}  // namespace flinch::train
