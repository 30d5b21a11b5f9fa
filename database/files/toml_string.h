// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace flinch::database {

/// Returns a text as a basic string of TOML, in double quotes. Control characters are escaped.
std::string toml_string(std::string_view text);

}  // namespace flinch::database
