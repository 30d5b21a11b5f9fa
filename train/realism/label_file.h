// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/library/library.h"
#include "train/realism/push_example.h"
#include "train/realism/recording_study.h"

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

/// What joining files did.
struct MergedLabels {
  std::size_t added = 0;
  std::size_t known = 0;       ///< that were there already
  std::size_t unanswered = 0;  ///< lines whose "realism" is null: questions that nobody answered
};
/// Appends the labels of other files of this library, except for those that are there. Throws as
/// read_labels(); then none is added.
MergedLabels merge_labels(const std::string& path, const database::ClipLibrary& library,
                          const runtime::PushResponses& responses,
                          const std::vector<std::string>& files);

/// A motion that someone is to judge.
struct Question {
  PushExample example;
  std::optional<float> estimate;  ///< of its realism
  std::string motion;             ///< file that shows it
};
/// Writes questions as a label file without answers: whoever judges fills in "judge", "sitting" and
/// "realism". Throws Error where the file cannot be written.
void write_questions(const std::string& path, const database::ClipLibrary& library,
                     const std::vector<Question>& questions);

/// What judges said in the test whether a motion is a recording.
struct StudyFile {
  StudyTable table{};
  std::size_t judges = 0;  ///< different ones
};
/// Reads a file of answers: a line that names the library, then lines of JSON with "judge", "shown"
/// and "answer" ("yes", "unsure" or "no"). Throws Error as read_labels().
StudyFile read_study(const std::string& path, const database::ClipLibrary& library);

}  // namespace flinch::train
