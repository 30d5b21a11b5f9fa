// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace flinch::database {

/// Whether a text is valid UTF-8 without control characters (U+0000 to U+001F, U+007F to U+009F),
/// so that printing it can neither move a terminal's cursor nor break a line or a JSON document.
bool is_printable(std::string_view text) noexcept;

/// The text with a question mark in place of each byte and each control character that
/// is_printable() refuses.
std::string printable(std::string_view text);

}  // namespace flinch::database
