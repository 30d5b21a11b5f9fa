// SPDX-License-Identifier: MIT
#include "train/report/csv.h"

#include <array>
#include <charconv>
#include <set>
#include <string_view>

namespace flinch::train {
namespace {

constexpr std::string_view kNameCharacters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._";

}  // namespace

std::string exact_text(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 17);
  return {text.data(), end.ptr};
}

std::vector<std::string> column_names(const std::string& prefix,
                                      const std::vector<std::string>& texts) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const std::string& text : texts) {
    std::string name = prefix;
    for (const char c : text) name += kNameCharacters.find(c) == std::string_view::npos ? '_' : c;
    std::string unique = name;
    for (int count = 2; !taken.insert(unique).second; ++count)
      unique = name + '_' + std::to_string(count);
    names.push_back(unique);
  }
  return names;
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += c;
  }
  return quoted + '"';
}

}  // namespace flinch::train
