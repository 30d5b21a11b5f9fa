// SPDX-License-Identifier: MIT
#include "database/files/provenance.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "database/files/file_io.h"
#include "database/files/file_kind.h"
#include "database/files/library_writer.h"
#include "database/files/text_encoding.h"
#include "database/library/library_bounds.h"
#include "database/library/text_check.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxInputDepth = 4;
constexpr std::size_t kMaxInputs = 500;

/// Leaves out the provenance of inputs that are nested deeper than provenance_of() reads.
void cut(Json& document, int depth) {
  for (Json& input : document["inputs"]) {
    if (!input.contains("provenance")) continue;
    if (depth == kMaxInputDepth) {
      input.erase("provenance");
    } else {
      cut(input["provenance"], depth + 1);
    }
  }
}

Json document_of(const ProvenanceInput& input) {
  Json document{{"role", input.role}};
  if (!input.name.empty()) document["name"] = input.name;
  document["hash"] = hash_text(input.hash);
  // A file may say anything of itself: what is no provenance is not passed on.
  if (provenance_of(input.provenance)) {
    Json made = Json::parse(input.provenance);
    cut(made, 1);
    document["provenance"] = std::move(made);
  }
  return document;
}

/// The text of a key; nothing where it is missing, no text, or has control characters.
std::optional<std::string> text_at(const Json& document, const char* key) {
  const auto found = document.find(key);
  if (found == document.end() || !found->is_string()) return std::nullopt;
  auto text = found->get<std::string>();
  return is_printable(text) ? std::optional(std::move(text)) : std::nullopt;
}

std::optional<Provenance> read_document(const Json& document, int depth);

bool read_input(const Json& document, int depth, ProvenanceInput& input) {
  if (!document.is_object()) return false;
  const auto role = text_at(document, "role");
  const auto hash = text_at(document, "hash");
  constexpr std::string_view kDigits = "0123456789abcdef";
  if (!role || !hash || hash->size() != 16 || hash->find_first_not_of(kDigits) != std::string::npos)
    return false;
  input.role = *role;
  input.hash = std::strtoull(hash->c_str(), nullptr, 16);
  if (document.contains("name")) {
    const auto name = text_at(document, "name");
    if (!name) return false;
    input.name = *name;
  }
  if (!document.contains("provenance")) return true;
  if (depth == kMaxInputDepth || !read_document(document["provenance"], depth + 1)) return false;
  input.provenance = document["provenance"].dump(-1, ' ', true);
  return true;
}

bool read_options(const Json& document, Provenance& provenance) {
  if (!document.is_object()) return false;
  for (const auto& [name, value] : document.items()) {
    const auto text = text_at(document, name.c_str());
    if (!text || !is_printable(name)) return false;
    provenance.options.emplace_back(name, *text);
  }
  return true;
}

std::optional<Provenance> read_document(const Json& document, int depth) {
  if (!document.is_object() || !document.contains("options") || !document.contains("inputs") ||
      !document["inputs"].is_array())
    return std::nullopt;
  const auto version = text_at(document, "flinch_version");
  const auto command = text_at(document, "command");
  Provenance provenance;
  if (!version || !command || !read_options(document["options"], provenance)) return std::nullopt;
  provenance.version = *version;
  provenance.command = *command;
  if (document.contains("seed")) {
    if (!document["seed"].is_number_unsigned()) return std::nullopt;
    provenance.seed = document["seed"].get<std::uint64_t>();
  }
  for (const Json& input : document["inputs"])
    if (!read_input(input, depth, provenance.inputs.emplace_back())) return std::nullopt;
  return provenance;
}

}  // namespace

std::string_view flinch_version() {
  return FLINCH_VERSION;
}

std::string word_of(const std::string& text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           static_cast<unsigned char>(c) >= 0x80 ||
           std::string_view("-_.:=+/@%^").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, is_plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

std::string provenance_text(const Provenance& provenance) {
  Json document{{"flinch_version", flinch_version()},
                {"command", provenance.command},
                {"options", Json::object()}};
  for (const auto& [name, value] : provenance.options)
    document["options"][name] = printable_text(value);
  if (provenance.seed) document["seed"] = *provenance.seed;
  document["inputs"] = Json::array();
  for (const ProvenanceInput& input : provenance.inputs)
    document["inputs"].push_back(document_of(input));
  std::string text = document.dump(-1, ' ', true);
  if (text.size() > kMaxProvenanceSize)
    throw Error("", "the provenance takes more than " + std::to_string(kMaxProvenanceSize) +
                        " bytes; give files shorter names, or import from fewer files");
  return text;
}

std::optional<Provenance> provenance_of(std::string_view text) {
  // A document that is nested deeply would overflow the stack.
  bool is_flat = true;
  const auto require_flat = [&is_flat](int depth, Json::parse_event_t, const Json&) {
    is_flat = is_flat && depth <= 4 * (kMaxInputDepth + 1);
    return is_flat;
  };
  if (text.size() > kMaxProvenanceSize) return std::nullopt;
  const Json document = Json::parse(text, require_flat, false);
  return is_flat ? read_document(document, 0) : std::nullopt;
}

ProvenanceInput input_of(const std::string& role, const std::string& path) {
  const std::string bytes = read_file(path);
  if (file_kind_of(bytes) == FileKind::library) {
    const ClipLibrary library = load_library(path);
    return {role, "", library.hash, library.provenance};
  }
  return {role, printable_text(std::filesystem::path(path).filename().string()),
          content_hash(bytes_of(bytes)), ""};
}

void add_inputs(const std::string& role, const std::vector<std::string>& paths,
                Provenance& provenance) {
  std::vector<ProvenanceInput> inputs;
  for (const std::string& path : paths) inputs.push_back(input_of(role, path));
  if (inputs.size() > kMaxInputs) {
    std::string hashes;
    for (const ProvenanceInput& input : inputs)
      for (unsigned shift = 0; shift < 64; shift += 8)
        hashes += static_cast<char>((input.hash >> shift) & 0xFF);
    inputs = {{role, std::to_string(paths.size()) + " files", content_hash(bytes_of(hashes)), ""}};
  }
  provenance.inputs.insert(provenance.inputs.end(), inputs.begin(), inputs.end());
}

}  // namespace flinch::database
