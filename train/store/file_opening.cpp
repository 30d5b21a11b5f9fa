// SPDX-License-Identifier: MIT
#include "train/store/file_opening.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "motion/error.h"

namespace flinch::train {

database::FileKind file_kind_at(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw Error(path, "is a folder, not a file");
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw Error(path, std::string("cannot be read: ") + std::strerror(errno) + "; check the path");
  std::string opening(database::kFileOpening, '\0');
  file.read(opening.data(), static_cast<std::streamsize>(opening.size()));
  opening.resize(static_cast<std::size_t>(file.gcount()));
  return database::file_kind_of(opening);
}

}  // namespace flinch::train
