// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "database/library/text_check.h"

namespace flinch::database {

/// Returns text of unknown origin, such as a joint's name or a file's, as UTF-8 that can be printed
/// on one line. Bytes that are not UTF-8 are taken for Latin-1; control characters become `?`.
std::string printable_text(std::string_view bytes);

}  // namespace flinch::database
