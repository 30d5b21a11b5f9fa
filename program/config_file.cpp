// SPDX-License-Identifier: MIT
#include "program/config_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include "database/files/toml_reader.h"
#include "motion/error.h"

namespace flinch::program {
namespace {

/// Returns the shortest text that reads back as the same number.
template <class Number>
std::string number_text(Number number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

/// Returns a string, number or truth value as a command line has it; an empty list for others.
std::vector<std::string> text_of(const toml::node& value) {
  if (const auto text = value.value_exact<std::string>()) return {*text};
  if (const auto flag = value.value_exact<bool>()) return {*flag ? "true" : "false"};
  if (const auto whole = value.value_exact<std::int64_t>()) return {number_text(*whole)};
  if (const auto real = value.value_exact<double>()) return {number_text(*real)};
  return {};
}

/// The values of one key: those of a list, or one.
std::vector<std::string> texts_of(const toml::node& value) {
  const toml::array* list = value.as_array();
  if (list == nullptr) return text_of(value);
  std::vector<std::string> texts;
  for (const toml::node& element : *list) {
    const std::vector<std::string> text = text_of(element);
    if (text.empty()) return {};
    texts.push_back(text.front());
  }
  return texts;
}

}  // namespace

std::vector<ConfigValue> read_config(const std::string& path, const std::string& command,
                                     std::span<const std::string> commands) {
  const toml::table file = database::read_toml(path);
  const database::TomlReader reader(file, path, "the file");
  for (const auto& [key, value] : file) {
    const std::string name(key.str());
    if (!value.is_table() || std::ranges::find(commands, name) == commands.end())
      reader.fail(
          name, "has \"" + name + "\" outside of a table of a command, such as [" + command + "]");
  }
  const toml::table* table = file[command].as_table();
  if (table == nullptr)
    throw Error(path, "has no table [" + command + "] with the command's options");
  const database::TomlReader options(*table, path, "[" + command + "]");
  std::vector<ConfigValue> values;
  for (const auto& [key, value] : *table) {
    const std::string name(key.str());
    values.push_back({name, texts_of(value), options.where(name)});
    if (values.back().values.empty())
      options.fail(name, "needs a string, a number, true, false or a list of these for " + name);
  }
  return values;
}

}  // namespace flinch::program
