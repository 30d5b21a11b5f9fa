// SPDX-License-Identifier: MIT
#include "train/fit/selector_reader.h"

#include <span>

#include "database/files/file_io.h"
#include "database/files/file_kind.h"
#include "motion/error.h"

namespace flinch::train {

runtime::SelectorFile load_selector_file(const std::string& path) {
  const std::string bytes = database::read_file(path);
  runtime::SelectorFile file;
  const database::LoadStatus status =
      runtime::read_selector_file(std::as_bytes(std::span(bytes.data(), bytes.size())), file);
  if (status == database::LoadStatus::ok) return file;
  if (database::file_kind_of(bytes) != database::FileKind::selector)
    throw Error(path, "is " + std::string(database::name_of(database::file_kind_of(bytes))) +
                          ", not a selector; `flinch train` makes one");
  throw Error(path, "the selector " +
                        database::refusal_of(status, database::kSelectorFormat, bytes) +
                        "; run `flinch train` again");
}

runtime::Library load_runtime_library(const std::string& path) {
  runtime::Library library;
  const database::LoadStatus status = library.load(path);
  if (status == database::LoadStatus::ok) return library;
  load_selector_file(path);  // throws what the file is instead, or what is wrong with it
  throw Error(path, std::string("the selector ") + database::message_of(status) +
                        "; run `flinch train` again");
}

}  // namespace flinch::train
