// SPDX-License-Identifier: MIT
#include "train/program/load.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <string_view>

#include "database/file_io.h"
#include "database/library_file.h"
#include "motion/error.h"
#include "runtime/selector_file.h"
#include "train/store.h"

namespace flinch::train::program {

namespace {

using database::LoadStatus;

/// BVH begins with the word HIERARCHY, in any case, after blanks or a byte-order mark.
bool begins_as_bvh(std::string_view bytes) {
  constexpr std::string_view kKeyword = "hierarchy";
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  return std::ranges::equal(bytes.substr(0, kKeyword.size()), kKeyword, [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

std::span<const std::byte> as_bytes(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

}  // namespace

FileKind kind_of(const std::string& path) {
  const std::string bytes = database::read_file(path);
  if (bytes.empty()) return FileKind::empty;
  if (looks_like_store(path)) return FileKind::store;
  if (begins_as_bvh(bytes)) return FileKind::bvh;
  database::Library library;
  if (database::read_library(as_bytes(bytes), library) != LoadStatus::not_a_library)
    return FileKind::library;
  models::Selector selector;
  if (runtime::read_selector(as_bytes(bytes), selector) != LoadStatus::not_a_library)
    return FileKind::selector;
  return FileKind::other;
}

std::string describe(FileKind kind) {
  switch (kind) {
    case FileKind::library:
      return "a library";
    case FileKind::store:
      return "a store";
    case FileKind::selector:
      return "a selector";
    case FileKind::bvh:
      return "BVH motion";
    case FileKind::empty:
      return "empty";
    case FileKind::other:
      break;
  }
  return "none of Flinch's files";
}

models::Selector load_selector(const std::string& path) {
  const std::string bytes = database::read_file(path);
  models::Selector selector;
  switch (runtime::read_selector(as_bytes(bytes), selector)) {
    case LoadStatus::ok:
      return selector;
    case LoadStatus::other_version:
      throw Error(path,
                  "a selector of another version of the format, or with other features than "
                  "this program computes; run flinch train again");
    case LoadStatus::damaged:
      throw Error(path, "the selector is damaged; run flinch train again");
    default:
      throw Error(path,
                  "not a selector but " + describe(kind_of(path)) + "; make one with flinch train");
  }
}

}  // namespace flinch::train::program
