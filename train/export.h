// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "train/labels.h"
#include "train/store.h"

namespace flinch::train {

/// The observations as libsvm's programs read them: the label (index of the clip) and the scaled
/// features from 1 on, every digit that a double has. Scaled as a selector trained on the same
/// observations scales.
std::string libsvm_text(std::span<const Observation> observations, const Labels& labels);

/// The observations as comma-separated values under a line of names: number, target, features
/// (unscaled), the label's index and name, and what it and standing idle cost.
std::string csv_text(const Store& store, const Labels& labels);

/// A double with every digit, as "%.17g" writes it, whatever the locale.
std::string exact(double value);

/// A cell of comma-separated values, quoted where it needs to be (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace flinch::train
