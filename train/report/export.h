// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "train/fit/labels.h"
#include "train/store/store.h"

namespace flinch::train {

/// Returns the observations in libsvm's text format: the label (index of the clip) and the scaled
/// features, numbered from 1, with every digit of a double. `scaling` is that of the observations
/// that are fitted to: a selector's own if these are its observations.
std::string libsvm_text(const Store& store, const Labels& labels, const features::Scaling& scaling);

/// Returns the observations as comma-separated values under a line of names: number, target,
/// features (unscaled), index and name of the label, its cost and that of standing idle, and then
/// the cost of each clip of the library, empty if the clip was not tried. Names of columns are
/// valid in R.
std::string csv_text(const Store& store, const Labels& labels);

}  // namespace flinch::train
