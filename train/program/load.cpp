// SPDX-License-Identifier: MIT
#include "train/program/load.h"

#include <span>

#include "database/file_io.h"
#include "database/file_kind.h"
#include "motion/error.h"
#include "runtime/selector_file.h"

namespace flinch::train::program {

models::Selector load_selector(const std::string& path) {
  const std::string bytes = database::read_file(path);
  models::Selector selector;
  const database::LoadStatus status =
      runtime::read_selector(std::as_bytes(std::span(bytes.data(), bytes.size())), selector);
  if (status == database::LoadStatus::ok) return selector;
  if (database::file_kind_of(bytes) != database::FileKind::selector)
    throw Error(path, "is " + std::string(name_of(database::file_kind_of(bytes))) +
                          ", not a selector; `flinch train` makes one");
  throw Error(path, std::string("the selector ") + database::message_of(status) +
                        "; run `flinch train` again");
}

}  // namespace flinch::train::program
