// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace flinch::database {

/// Splits BVH text into words and numbers and tracks the line number. Lines end with LF, CRLF or
/// CR. A byte-order mark is skipped, and so is a comment: what follows # or // at the beginning of
/// a word, to the end of the line. `text` must outlive the lexer.
class BvhLexer {
 public:
  /// Throws Error when the text is empty, binary, or begins as UTF-16.
  BvhLexer(std::string_view text, std::string path);

  /// Returns the next word and moves past it; a brace is a word of its own. Empty at the end of the
  /// text.
  std::string_view next_word();
  /// Returns the next word without moving past it.
  std::string_view peek_word();
  /// Returns the rest of the line up to a brace, trimmed: a name.
  std::string_view rest_of_line();
  /// Returns whether the next word, made of letters in any case, is this one. If so, moves past it
  /// and past a colon after it.
  bool accept_label(std::string_view letters);

  /// Returns the next word as a finite number, or as an integer. `of_what` names it in the Error.
  double next_number(std::string_view of_what);
  long long next_whole_number(std::string_view of_what);
  /// Moves to the next number on this line. At the end of the line, returns false and does not
  /// move.
  bool next_number_on_line(double& number);
  /// Moves to the start of the next line. Returns false at the end of the text.
  bool next_line();

  std::size_t line() const { return line_; }  ///< of the last word, from 1
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - position_); }
  const std::string& path() const { return path_; }

  /// Returns "FILE:LINE", for Error and warnings.
  std::string where(std::size_t line) const;
  [[noreturn]] void fail(const std::string& what) const { fail_at(line_, what); }
  [[noreturn]] void fail_at(std::size_t line, const std::string& what) const;

 private:
  void skip_blanks();
  bool at_end() const { return position_ == end_; }

  std::string path_;
  const char* position_;
  const char* end_;
  std::size_t line_ = 1;
};

/// Returns whether two words are equal when the case of ASCII letters is ignored.
bool equals_ignoring_case(std::string_view one, std::string_view other);

/// Formats a word for a one-line message: in back quotes, shortened, as printable_text;
/// "the end of the file" for an empty one.
std::string quoted(std::string_view word);

}  // namespace flinch::database
