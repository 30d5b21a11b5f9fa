// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace flinch::database {

/// Returns whether bytes are well-formed UTF-8, as TOML and JSON need it: no overlong forms, no
/// surrogates, nothing above U+10FFFF.
bool is_utf8(std::string_view bytes);

/// Returns text of unknown origin, such as a joint's name or a file's, as UTF-8 that can be printed
/// on one line. Bytes that are not UTF-8 are taken for Latin-1; control characters become `?`.
std::string printable_text(std::string_view bytes);

}  // namespace flinch::database
