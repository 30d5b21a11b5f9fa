// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace flinch::program {

/// Text in columns for people: words to the left, numbers to the right.
class Table {
 public:
  enum class Align : bool { left, right };
  struct Column {
    std::string title;
    Align align = Align::left;
  };
  explicit Table(std::vector<Column> columns);

  /// One cell a column.
  void add(std::vector<std::string> cells);
  std::string text() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// A number with so many decimals; "-" for what is not a number.
std::string fixed(double value, int decimals);

}  // namespace flinch::program
