// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/library/library_file.h"
#include "models/selector.h"

namespace flinch::tests {

/// Selectors of eight clips, idle last, with numbers that no text or float would bring back: one of
/// each kind of model.
models::Selector selector_without_model();
models::Selector svm_selector();
/// Of features that do not fill a whole row of the model.
models::Selector rbf_selector();
models::Selector knn_selector();
models::Selector knn_cost_selector();
models::Selector network_selector();
models::Selector pairwise_selector();
std::vector<models::Selector> one_of_each();

database::LoadStatus read(const std::string& bytes, models::Selector& selector);

}  // namespace flinch::tests
