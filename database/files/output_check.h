// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "database/files/file_kind.h"

namespace flinch::database {

/// A file that a command is about to write.
struct Output {
  std::string path;
  FileKind kind;  ///< of what it writes
  /// Text among the first bytes of what it writes, where the kind alone does not show that a file
  /// is Flinch's own. Empty: the kind does.
  std::string_view mark;
};

/// What to do with existing files that a command did not write itself.
enum class Overwrite : bool { refuse, force };

/// Checks, before any work starts, that a command can write its outputs without harm. Throws Error
/// for an output
/// - that is one of the files that the command reads, by whatever name or link, or that two outputs
///   share;
/// - that exists and is no regular file;
/// - that exists and is of another kind than the command writes, unless `overwrite` forces it; an
///   empty file may always be replaced;
/// - whose folder is missing or cannot be written to;
/// - whose "PATH.partial", under which it is written, would be refused so itself.
/// `inputs` are the files that the command reads; a folder stands for the motion capture in it, and
/// an empty path for nothing. Changes nothing.
void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs,
                   Overwrite overwrite);

/// Does the same for outputs whose paths are names in a folder that is created if it is missing.
void check_output_folder(const std::string& folder, const std::vector<Output>& outputs,
                         const std::vector<std::string>& inputs, Overwrite overwrite);

}  // namespace flinch::database
