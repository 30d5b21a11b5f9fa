// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "runtime/library.h"
#include "runtime/selector_file.h"

namespace flinch::train {

/// Reads a selector file, with its clips if it has any. Throws Error that says what is wrong and,
/// if known, what the file is instead.
runtime::SelectorFile load_selector_file(const std::string& path);

/// Loads a selector with its clips, as a game does: those in its file, or those of its library, a
/// .flinchlib file in the same folder. Throws Error as load_selector_file does, and also where
/// there are no clips.
runtime::Library load_runtime_library(const std::string& path);

}  // namespace flinch::train
