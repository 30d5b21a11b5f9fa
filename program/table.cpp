// SPDX-License-Identifier: MIT
#include "program/table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "program/printable.h"

namespace flinch::program {

Table::Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

void Table::add(std::vector<std::string> cells) {
  for (std::string& cell : cells) cell = printable(cell);
  rows_.push_back(std::move(cells));
}

std::string Table::text() const {
  std::vector<std::size_t> width;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    width.push_back(columns_[i].title.size());
    for (const auto& row : rows_) width[i] = std::max(width[i], row[i].size());
  }
  std::ostringstream out;
  const auto line = [&](const auto& cell) {
    std::string text;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string& content = cell(i);
      const std::string padding(width[i] - content.size(), ' ');
      if (i > 0) text += "  ";
      text += columns_[i].align == Align::left ? content + padding : padding + content;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    out << text << '\n';
  };
  line([this](std::size_t i) -> const std::string& { return columns_[i].title; });
  for (const auto& row : rows_)
    line([&row](std::size_t i) -> const std::string& { return row[i]; });
  return out.str();
}

std::string fixed(double value, int decimals) {
  if (std::isnan(value)) return "-";
  std::ostringstream out;
  out << std::fixed << std::setprecision(decimals) << value;
  return out.str();
}

}  // namespace flinch::program
