// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/library/library.h"
#include "program/document.h"

namespace flinch::program {

/// How human a library's clips are: a table of database::measure_quality for people.
std::string quality_text(const database::ClipLibrary& library);

/// The same for machines: `bounds` and, for every clip, its measures and the bounds it breaks.
Json quality_document(const database::ClipLibrary& library);

}  // namespace flinch::program
