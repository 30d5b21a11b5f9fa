// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "motion/error.h"

// Common main function of programs that measure and print tables.
namespace flinch::bench {

/// The arguments after the program's name.
class StudyArguments {
 public:
  explicit StudyArguments(std::vector<std::string> texts) : texts_(std::move(texts)) {}

  std::size_t count() const { return texts_.size(); }
  bool has(std::size_t index) const { return index < texts_.size(); }
  const std::string& text(std::size_t index) const { return texts_.at(index); }
  /// Returns the number in this position, which must be at least 0. Throws Error for anything else.
  template <class Number>
  Number number(std::size_t index) const {
    const std::string& text = texts_.at(index);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= Number{})) {
      throw Error("", "'" + text + "' is not a number that can stand there");
    }
    return value;
  }
  /// Returns the same, or `otherwise` if the argument is missing.
  template <class Number>
  Number number_or(std::size_t index, Number otherwise) const {
    return has(index) ? number<Number>(index) : otherwise;
  }

 private:
  std::vector<std::string> texts_;
};

/// Usage of a study.
struct StudyUsage {
  std::string_view text;  ///< its name, then its arguments
  std::size_t min_arguments = 0;
  std::size_t max_arguments = 0;
};

/// Runs a study and returns the exit code of its program: 0; 1 after an exception, whose message it
/// prints; 2 if there are too few or too many arguments, after printing the usage.
template <class Run>
int study_main(int count, char** arguments, const StudyUsage& usage, Run run) {
  const StudyArguments given(std::vector<std::string>(arguments + 1, arguments + count));
  if (given.count() < usage.min_arguments || given.count() > usage.max_arguments) {
    std::fprintf(stderr, "Usage: %s\n", std::string(usage.text).c_str());
    return 2;
  }
  try {
    run(given);
  } catch (const std::exception& error) {
    const std::string name(usage.text.substr(0, usage.text.find(' ')));
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return 1;
  }
  return 0;
}

}  // namespace flinch::bench
