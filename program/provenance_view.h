// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "program/document.h"

namespace flinch::program {

/// Returns the provenance of the file at `path` for `flinch info --json`: null for an empty text.
/// Throws Error for a text that is none.
Json provenance_document(const std::string& text, const std::string& path);

/// Returns it as lines, each input below what was made from it; a line that says so where the text
/// is empty. Throws Error for a text that is none.
std::string provenance_lines(const std::string& text, const std::string& path);

/// Returns a description that a store's header or a selector's record holds. Throws Error at `path`
/// that says `damaged` unless it is a JSON object as `flinch simulate` and `flinch train` write it;
/// printing one that is nested deeply would overflow the stack.
Json description(const std::string& text, const std::string& path, const std::string& damaged);

}  // namespace flinch::program
