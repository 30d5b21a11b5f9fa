// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <filesystem>
#include <string>

#include "train/objective/cost.h"
#include "train/store/store.h"

// The offline part in Python, with the program's own functions and texts.

namespace flinch::python {

/// A store that was read, and what it holds as arrays: one row per scenario.
struct Scenarios {
  /// Reads a store; the features are those of a set (features::feature_sets()).
  Scenarios(const std::filesystem::path& path, const std::string& features);

  std::string feature_set;
  train::Store store;
  pybind11::dict arrays;  ///< by name; made once, and not writable
};

/// Returns the cost model of a store for a brawn and a vulnerability table, shipped or a file.
train::CostModel cost_model_of(const Scenarios& scenarios, double brawn,
                               const std::string& vulnerability);

/// Returns how a file was made (database/files/provenance.h) as Python's values; None for an empty
/// text. Throws Error for another text.
pybind11::object provenance_object(const std::string& text);

void bind_clip_library(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_store(pybind11::module_& module);
void bind_training(pybind11::module_& module);

}  // namespace flinch::python
