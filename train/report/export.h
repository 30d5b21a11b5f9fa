// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "train/fit/labels.h"
#include "train/store/store.h"

namespace flinch::train {

/// The observations as libsvm's programs read them: the label (index of the clip) and the scaled
/// features from 1 on, every digit that a double has. `scaling` is that of the observations that
/// are fitted to: a selector's own where these are its observations.
std::string libsvm_text(const Store& store, const Labels& labels, const features::Scaling& scaling);

/// The observations as comma-separated values under a line of names: number, target, features
/// (unscaled), the label's index and name, what it and standing idle cost, and then what each clip
/// of the library costs, empty where it was not tried.
std::string csv_text(const Store& store, const Labels& labels);

}  // namespace flinch::train
