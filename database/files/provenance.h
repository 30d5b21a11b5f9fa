// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace flinch::database {

/// A file that went into another one. Files of Flinch are known by their hash and have no name, so
/// that renaming one changes nothing that is made from it.
struct ProvenanceInput {
  std::string role;        ///< what it is used for: "library", "manifest"
  std::string name;        ///< without its folder; empty for a file of Flinch
  std::uint64_t hash = 0;  ///< of a library or store its own, of others XXH64 of the whole file
  std::string provenance;  ///< how it was made, as text; empty where that is not known
};

/// How a file was made: enough to make it again. The same content, options and seed give the same
/// text: it has no time, no user, no machine and no folder.
struct Provenance {
  std::string version{};  ///< of Flinch, which provenance_text() writes; set by reading
  std::string command{};  ///< of the program, or the one that does the same
  /// Options that are not at their defaults, as the command line has them, without dashes.
  std::vector<std::pair<std::string, std::string>> options{};
  std::optional<std::uint64_t> seed{};
  std::vector<ProvenanceInput> inputs{};
};

/// The version of Flinch.
std::string_view flinch_version();

/// Returns the provenance as one line of JSON in ASCII, which provenance_of() reads: without what
/// inputs say of themselves where it is none, or nested more than four deep. Throws Error where it
/// is longer than kMaxProvenanceSize.
std::string provenance_text(const Provenance& provenance);

/// Reads such a text; nothing for another one: wrong or missing keys, control characters in a
/// value, inputs of inputs that are nested more than four deep.
std::optional<Provenance> provenance_of(std::string_view text);

/// Describes a file: a library by its hash and provenance, another one by its name and its hash.
/// Throws Error where it cannot be read.
ProvenanceInput input_of(const std::string& role, const std::string& path);

/// Adds the files, in their order. More than 500 become one input whose hash is that of their
/// hashes, 8 bytes each, least significant first.
void add_inputs(const std::string& role, const std::vector<std::string>& paths,
                Provenance& provenance);

/// An option's value as the command line has it: a number by the fewest digits that read back the
/// same.
template <class Value>
std::string option_text(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_arithmetic_v<Value>) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
  } else {
    return std::string(value);
  }
}

/// A text as one word among others: in single quotes, as a shell reads them, unless it has only
/// letters, digits, characters beyond ASCII and -_.:=+/@%^.
std::string word_of(const std::string& text);

/// Adds an option unless it has its default.
template <class Value>
void add_option(const std::string& name, const Value& value, const Value& unless,
                Provenance& provenance) {
  if (value != unless) provenance.options.emplace_back(name, option_text(value));
}
template <class Value>
void add_option(const std::string& name, const std::optional<Value>& value,
                Provenance& provenance) {
  if (value) provenance.options.emplace_back(name, option_text(*value));
}

}  // namespace flinch::database
