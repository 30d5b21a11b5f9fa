// SPDX-License-Identifier: MIT
#include "program/provenance_view.h"

#include "database/files/provenance.h"
#include "database/library/library.h"
#include "motion/error.h"
#include "program/printable.h"

namespace flinch::program {
namespace {

database::Provenance read(const std::string& text, const std::string& path) {
  if (auto read = database::provenance_of(text)) return *std::move(read);
  throw Error(path, "its provenance is damaged; make it again");
}

/// So that nobody takes a comma or a space of a name for one between names.
std::string printable_word(const std::string& text) {
  return printable(database::word_of(text));
}

std::string lines_of(const database::Provenance& made, const std::string& indent,
                     const std::string& path) {
  std::string text =
      "Flinch " + printable_word(made.version) + ", flinch " + printable_word(made.command);
  for (const auto& [name, value] : made.options)
    text += (name.size() == 1 ? " -" : " --") + printable_word(name) +
            (value == "true" ? "" : ' ' + printable_word(value));
  if (made.seed) text += ", seed " + std::to_string(*made.seed);
  text += '\n';
  for (const database::ProvenanceInput& input : made.inputs) {
    text += indent + "  " + printable_word(input.role) + ' ' +
            (input.name.empty() ? "" : printable_word(input.name) + ' ') +
            database::hash_text(input.hash);
    text += input.provenance.empty()
                ? "\n"
                : ", made by " + lines_of(read(input.provenance, path), indent + "  ", path);
  }
  return text;
}

}  // namespace

Json provenance_document(const std::string& text, const std::string& path) {
  if (text.empty()) return nullptr;
  read(text, path);
  return Json::parse(text);
}

std::string provenance_lines(const std::string& text, const std::string& path) {
  if (text.empty()) return "made by: not recorded\n";
  return "made by: " + lines_of(read(text, path), "", path);
}

Json description(const std::string& text, const std::string& path, const std::string& damaged) {
  constexpr int kMaxDepth = 6;
  const Error error(path, damaged);
  const auto require_flat = [&error](int depth, Json::parse_event_t, const Json&) {
    if (depth > kMaxDepth) throw Error(error);
    return true;
  };
  Json document = Json::parse(text, require_flat, false);
  if (!document.is_object()) throw Error(error);
  return document;
}

}  // namespace flinch::program
