// SPDX-License-Identifier: MIT
#include "database/files/file_kind.h"

#include <algorithm>
#include <utility>

#include "motion/enum_array.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

struct FileSignature {
  std::string_view bytes;
  FileKind kind;
};

constexpr std::array kSignatures{
    FileSignature{kLibraryFormat.magic, FileKind::library},
    FileSignature{kSelectorFormat.magic, FileKind::selector},
    FileSignature{std::string_view("SQLite format 3\0", 16), FileKind::store},
    FileSignature{"Kaydara FBX Binary", FileKind::fbx},
    FileSignature{"; FBX", FileKind::fbx},
    FileSignature{"glTF", FileKind::gltf},
    FileSignature{"PK\x03\x04", FileKind::archive},
    FileSignature{"\x1F\x8B", FileKind::archive},
    FileSignature{"\xFD"
                  "7zXZ",
                  FileKind::archive},
};

// With a byte-order mark, as Windows' programs write it, or with the first character's zero byte.
bool opens_as_utf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  return bytes.size() >= 4 && (bytes[0] == '\0') != (bytes[1] == '\0') &&
         (bytes[0] == '\0') == (bytes[2] == '\0') && (bytes[1] == '\0') == (bytes[3] == '\0');
}

bool is_text_byte(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 || (byte >= '\t' && byte <= '\r');
}

// A text whose first word, after at most a byte-order mark, blank lines and comments, is HIERARCHY
// in any case.
bool opens_as_bvh(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\v\f\r\n";
  constexpr std::string_view kWord = "HIERARCHY";
  const auto skip_to = [&](std::size_t position) {
    text.remove_prefix(std::min(position, text.size()));
  };
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  skip_to(text.find_first_not_of(kBlanks));
  while (text.starts_with('#') || text.starts_with("//")) {
    skip_to(text.find_first_of("\r\n"));
    skip_to(text.find_first_not_of(kBlanks));
  }
  const std::size_t end = text.find_first_of(std::string_view(" \t\v\f\r\n{}\0", 9));
  const std::string_view word = text.substr(0, end);
  return std::equal(word.begin(), word.end(), kWord.begin(), kWord.end(),
                    [](char a, char b) { return (a & ~0x20) == b; });
}

// A document of JSON with the member that glTF demands.
bool opens_as_gltf(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{' &&
         bytes.substr(0, kFileOpening).find("\"asset\"") != std::string_view::npos;
}

}  // namespace

bool holds_motion(FileKind kind) {
  return kind == FileKind::bvh || kind == FileKind::fbx || kind == FileKind::gltf;
}

FileKind file_kind_of(std::string_view bytes) {
  if (bytes.empty()) return FileKind::empty;
  const auto opening =
      std::find_if(kSignatures.begin(), kSignatures.end(),
                   [&](const FileSignature& known) { return bytes.starts_with(known.bytes); });
  if (opening != kSignatures.end()) return opening->kind;
  if (opens_as_bvh(bytes)) return FileKind::bvh;
  if (opens_as_gltf(bytes)) return FileKind::gltf;
  if (opens_as_utf16(bytes)) return FileKind::utf16;
  const std::string_view start = bytes.substr(0, 512);
  return std::all_of(start.begin(), start.end(), is_text_byte) ? FileKind::text : FileKind::unknown;
}

bool names_toml_file(std::string_view name) {
  return name.ends_with(".toml");
}

std::string refusal_of(LoadStatus status, const FileFormat& format, std::string_view file) {
  if (status != LoadStatus::other_version) return message_of(status);
  const auto version = static_cast<unsigned char>(file.at(format.magic.size()));
  std::string read = std::to_string(format.version);
  if (format.newest_read != format.version) read += " to " + std::to_string(format.newest_read);
  return "is of format " + std::to_string(version) + ", and this program reads format " + read;
}

std::string_view name_of(FileKind kind) {
  constexpr motion::EnumArray<FileKind, std::string_view, 11> kNames{
      "an empty file",
      "a library",
      "a selector",
      "a store or other SQLite database",
      "a BVH file",
      "an FBX file",
      "a glTF file",
      "an archive",
      "text in UTF-16",
      "a text file",
      "no file that Flinch knows"};
  return kNames[kind];
}

std::string_view word_of(FileKind kind) {
  constexpr motion::EnumArray<FileKind, std::string_view, 11> kWords{
      "empty", "library", "selector", "store", "bvh",    "fbx",
      "gltf",  "archive", "utf16",    "text",  "unknown"};
  return kWords[kind];
}

void require_not_utf16(std::string_view bytes, const std::string& path) {
  if (file_kind_of(bytes) == FileKind::utf16) {
    throw Error(path, "is " + std::string(name_of(FileKind::utf16)) + "; save it as UTF-8");
  }
}

}  // namespace flinch::database
