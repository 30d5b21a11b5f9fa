// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/library/library.h"
#include "train/realism/push_example.h"

namespace flinch::train {

/// A judgement of one example.
struct Label {
  PushExample example;
  float quality = 0;    ///< Q, 0 to 1
  std::string judge;    ///< who
  std::string sitting;  ///< labels of one sitting belong together when others are held out
};

/// Labels of the pushed motions of one library.
struct LabelSet {
  std::uint64_t library_hash = 0;
  std::vector<Label> labels;
};

/// A label file is text: a line of JSON that names the library, then one line per label. Lines are
/// only ever appended, each in one write that is flushed to the disk, so that no label is lost and
/// several judges can write one file; files of one library are merged by joining their lines.

/// Creates the file if there is none, and appends the labels of `set` as one block. Throws Error
/// where the file is of another library, is cut short or cannot be written.
void append_labels(const std::string& path, const database::ClipLibrary& library,
                   const std::vector<Label>& labels);

/// Reads a file of labels of this library. Throws Error "PATH:LINE: …" for a file of another
/// library, a line that is cut short or is no label, or a label of clips that the library has not.
LabelSet read_labels(const std::string& path, const database::ClipLibrary& library,
                     const runtime::PushResponses& responses);

}  // namespace flinch::train
