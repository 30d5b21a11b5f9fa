// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace flinch::database {

/// Returns the number of bytes of the character that `text`, which is not empty, begins with; 0 if
/// that is not well-formed UTF-8 (RFC 3629, section 4): no overlong forms, no surrogates, nothing
/// above U+10FFFF.
std::size_t character_size(std::string_view text) noexcept;

/// Whether a character, in UTF-8, is a control character: U+0000 to U+001F, U+007F to U+009F.
bool is_control(std::string_view character) noexcept;

/// Whether bytes are well-formed UTF-8, as TOML and JSON need it.
bool is_utf8(std::string_view bytes) noexcept;

/// Whether a text is well-formed UTF-8 without control characters, so that printing it can neither
/// move a terminal's cursor nor break a line or a JSON document.
bool is_printable(std::string_view text) noexcept;

}  // namespace flinch::database
