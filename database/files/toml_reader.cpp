// SPDX-License-Identifier: MIT
#include "database/files/toml_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "database/files/file_io.h"
#include "database/files/file_kind.h"
#include "motion/error.h"

namespace flinch::database {

std::string read_toml_text(const std::string& path) {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 24;
  std::string text = read_file_start(path, kMaxBytes + 1);
  if (text.size() > kMaxBytes)
    throw Error(path, "is larger than 16 MiB, which no TOML file of Flinch is; check the path");
  return text;
}

toml::table read_toml(const std::string& path) {
  return parse_toml(read_toml_text(path), path);
}

toml::table parse_toml(std::string_view text, const std::string& path) {
  require_not_utf16(text, path);
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw Error(path + ":" + std::to_string(error.source().begin.line),
                "not TOML: " + std::string(error.description()));
  }
}

TomlReader::TomlReader(const toml::table& table, std::string path, std::string what)
    : table_(table), path_(std::move(path)), what_(std::move(what)) {}

std::string TomlReader::where(std::string_view key) const {
  const toml::node* node = key.empty() ? nullptr : table_.get(key);
  const toml::source_position at = (node != nullptr ? *node : table_).source().begin;
  return path_ + ":" + std::to_string(std::max<toml::source_index>(at.line, 1));
}

void TomlReader::fail(std::string_view key, const std::string& what) const {
  throw Error(where(key), what_ + " " + what);
}

void TomlReader::expect_keys(std::initializer_list<std::string_view> known) const {
  for (const auto& [key, value] : table_) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    std::string names;
    for (std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
    throw Error(
        path_ + ":" + std::to_string(key.source().begin.line),
        what_ + " has an unknown key \"" + std::string(key.str()) + "\"; it may have: " + names);
  }
}

std::optional<std::string> TomlReader::text(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const std::optional<std::string> value = node->value_exact<std::string>();
  if (!value) fail(key, "needs a string in quotes for " + std::string(key));
  return value;
}

std::optional<double> TomlReader::number(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const std::optional<double> value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value)) fail(key, "needs a number for " + std::string(key));
  return value;
}

std::optional<bool> TomlReader::flag(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const std::optional<bool> value = node->value_exact<bool>();
  if (!value) fail(key, "needs true or false for " + std::string(key));
  return value;
}

std::string TomlReader::needed_text(std::string_view key) const {
  const std::optional<std::string> value = text(key);
  if (!value || value->empty()) fail(key, "needs " + std::string(key) + " = \"…\"");
  return *value;
}

double TomlReader::needed_number(std::string_view key) const {
  const std::optional<double> value = number(key);
  if (!value) fail(key, "needs " + std::string(key) + " = NUMBER");
  return *value;
}

}  // namespace flinch::database
