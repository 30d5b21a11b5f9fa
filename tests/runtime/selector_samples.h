// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "database/library/library_file.h"
#include "models/selector.h"

namespace flinch::tests {

/// Selectors of eight clips, idle last, one for each kind of model. Their numbers would not survive
/// a conversion to text or float.
models::Selector selector_without_model();
models::Selector svm_selector();
/// Its features do not fill a whole row of the model.
models::Selector rbf_selector();
models::Selector knn_selector();
models::Selector knn_cost_selector();
models::Selector network_selector();
models::Selector pairwise_selector();
std::vector<models::Selector> one_of_each();

database::LoadStatus read(const std::string& bytes, models::Selector& selector);

}  // namespace flinch::tests
