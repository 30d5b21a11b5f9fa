// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace flinch::database {

/// Reads a TOML file of at most 16 MiB: parsing takes much longer than reading. Throws Error.
std::string read_toml_text(const std::string& path);
/// Parses a TOML file as read_toml_text reads it. Throws Error "FILE:LINE: …".
toml::table read_toml(const std::string& path);
/// Parses the text of a TOML file; `path` is for messages. Throws Error as read_toml does.
toml::table parse_toml(std::string_view text, const std::string& path);

/// Reads a TOML table with known keys of known types. All errors are thrown as Error "FILE:LINE:
/// …".
class TomlReader {
 public:
  /// `what` names the table in messages, such as "[[clip]]". The table must outlive this object.
  TomlReader(const toml::table& table, std::string path, std::string what);

  /// Throws Error for a key that is not in this list; the message contains the list.
  void expect_keys(std::initializer_list<std::string_view> known) const;

  bool has(std::string_view key) const { return table_.contains(key); }
  std::optional<std::string> text(std::string_view key) const;
  std::optional<double> number(std::string_view key) const;  ///< finite
  std::optional<bool> flag(std::string_view key) const;
  std::string needed_text(std::string_view key) const;  ///< and not empty
  double needed_number(std::string_view key) const;

  /// Throws the error at the key's line, or at the table's if there is no such key.
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

  const toml::table& table() const { return table_; }
  const std::string& path() const { return path_; }
  const std::string& what() const { return what_; }
  /// Returns "FILE:LINE" of the key, or of the table if there is no such key.
  std::string where(std::string_view key = {}) const;

 private:
  const toml::table& table_;
  std::string path_;
  std::string what_;
};

}  // namespace flinch::database
