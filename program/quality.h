// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/library/library.h"
#include "program/document.h"

namespace flinch::program {

/// Formats database::measure_quality of a library's clips as a table.
std::string quality_text(const database::ClipLibrary& library);

/// Returns the same as JSON: `bounds` and, for every clip, its measures and the bounds that it
/// exceeds.
Json quality_document(const database::ClipLibrary& library);

}  // namespace flinch::program
