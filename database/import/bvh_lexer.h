// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace flinch::database {

/// Cuts BVH text into words and numbers and knows which line it is on. Lines end with LF, CRLF or
/// CR. A byte-order mark is skipped. `text` must outlive the lexer.
class BvhLexer {
 public:
  /// Throws Error when the text is empty, binary or not UTF-8 to begin with.
  BvhLexer(std::string_view text, std::string path);

  /// The next word; braces are words of their own. Empty at the end of the text.
  std::string_view next_word();
  /// The same without moving on.
  std::string_view peek_word();
  /// The rest of the line up to a brace, without the blanks around it: a name.
  std::string_view rest_of_line();
  /// Whether the next characters, after blanks, are this word of letters in any case; moves past
  /// it, and past a colon after it, if so.
  bool accept_label(std::string_view letters);

  /// The next word as a finite number or a whole one. `of_what` names it in the Error.
  double next_number(std::string_view of_what);
  long long next_whole_number(std::string_view of_what);
  /// Moves to the next number on this line. False at its end, and then stays there.
  bool next_number_on_line(double& number);
  /// Moves to the start of the next line. False at the end of the text.
  bool next_line();

  std::size_t line() const { return line_; }  ///< of the last word, from 1
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - position_); }
  const std::string& path() const { return path_; }

  /// "FILE:LINE", for Error and warnings.
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

/// Whether two words are the same but for the case of ASCII letters.
bool equals_ignoring_case(std::string_view one, std::string_view other);

/// A word as a one-line message may show it: in back quotes, shortened, without control characters;
/// "the end of the file" for an empty one.
std::string quoted(std::string_view word);

}  // namespace flinch::database
