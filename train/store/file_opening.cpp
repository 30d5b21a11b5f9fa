// SPDX-License-Identifier: MIT
#include "train/store/file_opening.h"

#include "database/files/file_io.h"

namespace flinch::train {

database::FileKind file_kind_at(const std::string& path) {
  return database::file_kind_of(database::read_file_start(path, database::kFileOpening));
}

}  // namespace flinch::train
