// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace flinch::program {

/// Text in columns: words aligned left, numbers aligned right.
class Table {
 public:
  enum class Align : bool { left, right };
  struct Column {
    std::string title;
    Align align = Align::left;
  };
  explicit Table(std::vector<Column> columns);

  /// Adds a line with one cell per column, which is shown as printable() makes it.
  void add(std::vector<std::string> cells);
  std::string text() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Formats a number with this many decimals; "-" for not-a-number.
std::string fixed(double value, int decimals);

}  // namespace flinch::program
