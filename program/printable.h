// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace flinch::program {

/// Returns a text as it is shown on a terminal: control characters, which could move the cursor or
/// forge lines, and bytes that are not UTF-8 become escapes such as "\n" or "\x1b". Names in files
/// and of files may hold them.
std::string printable(std::string_view text);

}  // namespace flinch::program
