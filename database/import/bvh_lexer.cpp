// SPDX-License-Identifier: MIT
#include "database/import/bvh_lexer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "database/files/text_encoding.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view kUtf16Marks[] = {"\xFF\xFE", "\xFE\xFF"};

// The functions of <cctype> depend on the locale.
bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
bool is_blank_on_line(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
bool is_blank(char c) {
  return is_blank_on_line(c) || is_line_end(c);
}
bool is_brace(char c) {
  return c == '{' || c == '}';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string_view between(const char* first, const char* last) {
  return {first, static_cast<std::size_t>(last - first)};
}

/// Skips one end of line, which may be two characters.
const char* past_line_end(const char* position, const char* end) {
  const bool carriage_return = *position++ == '\r';
  return carriage_return && position != end && *position == '\n' ? position + 1 : position;
}

bool begins_comment(const char* position, const char* end) {
  const std::string_view rest = between(position, end);
  return rest.starts_with('#') || rest.starts_with("//");
}

/// Parses a number up to a blank or the end. Returns its end; null if it is not a number that fits
/// into a double.
const char* parse_number(const char* first, const char* end, double& number) {
  // from_chars does not accept a plus sign; "+-1" remains invalid.
  if (end - first >= 2 && *first == '+' && first[1] != '-') ++first;
  const auto [last, error] = std::from_chars(first, end, number);
  const bool whole_word = last == end || is_blank(*last);
  return error == std::errc{} && whole_word && std::isfinite(number) ? last : nullptr;
}

std::string not_a_number(std::string_view of_what, std::string_view word) {
  return std::string(of_what) + " should be a finite number with a decimal point, but is " +
         quoted(word);
}

}  // namespace

bool equals_ignoring_case(std::string_view one, std::string_view other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](char a, char b) { return lower(a) == lower(b); });
}

std::string quoted(std::string_view word) {
  if (word.empty()) return "the end of the file";
  constexpr std::size_t kLongest = 40;
  std::string_view start = word.substr(0, kLongest);
  // Not in the middle of a character of UTF-8, which has at most four bytes.
  for (int i = 0; i < 3 && is_utf8(word) && !is_utf8(start); ++i) start.remove_suffix(1);
  std::string text = "`";
  text += printable_text(start);
  text += word.size() > kLongest ? "...`" : "`";
  return text;
}

BvhLexer::BvhLexer(std::string_view text, std::string path)
    : path_(std::move(path)), position_(text.data()), end_(text.data() + text.size()) {
  for (const std::string_view mark : kUtf16Marks) {
    if (text.starts_with(mark)) throw Error(path_, "is UTF-16 text; save it as UTF-8");
  }
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) {
    throw Error(path_ + ": byte " + std::to_string(zero), "is binary, not BVH text");
  }
  if (text.starts_with(kUtf8Mark)) position_ += kUtf8Mark.size();
  if (peek_word().empty()) throw Error(path_, "is empty; expected BVH text");
}

void BvhLexer::skip_blanks() {
  while (!at_end()) {
    if (is_line_end(*position_)) {
      position_ = past_line_end(position_, end_);
      ++line_;
    } else if (is_blank_on_line(*position_)) {
      ++position_;
    } else if (begins_comment(position_, end_)) {
      position_ = std::find_if(position_, end_, is_line_end);
    } else {
      return;
    }
  }
}

std::string_view BvhLexer::peek_word() {
  skip_blanks();
  if (at_end()) return {};
  const char* last = position_ + 1;
  if (!is_brace(*position_)) {
    last = std::find_if(last, end_, [](char c) { return is_blank(c) || is_brace(c); });
  }
  return between(position_, last);
}

std::string_view BvhLexer::next_word() {
  const std::string_view word = peek_word();
  position_ += word.size();
  return word;
}

std::string_view BvhLexer::rest_of_line() {
  while (!at_end() && is_blank_on_line(*position_)) ++position_;
  const char* const first = position_;
  position_ = std::find_if(position_, end_, [](char c) { return is_line_end(c) || is_brace(c); });
  const char* last = position_;
  while (last != first && is_blank_on_line(last[-1])) --last;
  return between(first, last);
}

bool BvhLexer::accept_label(std::string_view letters) {
  skip_blanks();
  const char* const last = std::find_if(position_, end_, [](char c) { return !is_letter(c); });
  if (!equals_ignoring_case(between(position_, last), letters)) return false;
  position_ = last;
  while (!at_end() && is_blank_on_line(*position_)) ++position_;
  if (!at_end() && *position_ == ':') ++position_;
  return true;
}

double BvhLexer::next_number(std::string_view of_what) {
  const std::string_view word = next_word();
  double number = 0;
  if (parse_number(word.data(), word.data() + word.size(), number) == nullptr) {
    fail(not_a_number(of_what, word));
  }
  return number;
}

long long BvhLexer::next_whole_number(std::string_view of_what) {
  const std::string_view word = next_word();
  long long number = 0;
  const char* const end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc{} || last != end) {
    fail(std::string(of_what) + " should be a whole number, but is " + quoted(word));
  }
  return number;
}

bool BvhLexer::next_number_on_line(double& number) {
  while (!at_end() && is_blank_on_line(*position_)) ++position_;
  if (at_end() || is_line_end(*position_)) return false;
  const char* const last = parse_number(position_, end_, number);
  if (last == nullptr) {
    if (begins_comment(position_, end_)) return false;
    fail(not_a_number("a value of the motion", peek_word()));
  }
  position_ = last;
  return true;
}

bool BvhLexer::next_line() {
  position_ = std::find_if(position_, end_, is_line_end);
  if (at_end()) return false;
  position_ = past_line_end(position_, end_);
  ++line_;
  return true;
}

std::string BvhLexer::where(std::size_t line) const {
  return path_ + ":" + std::to_string(line);
}

void BvhLexer::fail_at(std::size_t line, const std::string& what) const {
  throw Error(where(line), what);
}

}  // namespace flinch::database
