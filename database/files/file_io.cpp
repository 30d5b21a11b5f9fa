// SPDX-License-Identifier: MIT
#include "database/files/file_io.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "database/files/partial_file.h"
#include "database/library/input_file.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

/// Throws unless the file was read. `error` is errno of the failure.
void require_read(LoadStatus status, const std::string& path, int error) {
  std::error_code ignored;
  switch (status) {
    case LoadStatus::ok:
      return;
    case LoadStatus::cannot_open:
      throw Error(path, std::string("cannot be read: ") + std::strerror(error) +
                            (error == ENOENT ? "; check the path" : ""));
    case LoadStatus::not_a_file:
      if (std::filesystem::is_directory(path, ignored)) {
        throw Error(path, "is a folder, not a file");
      }
      throw Error(path, "is a pipe or a device, not a file; write it to a file first");
    case LoadStatus::too_large:
      throw Error(path, "is larger than 1 GiB, which no input of Flinch is; check the path");
    default:
      throw Error(path, message_of(status));
  }
}

}  // namespace

std::string read_file(const std::string& path) {
  std::string bytes;
  const LoadStatus status = read_bytes(path, bytes);
  require_read(status, path, errno);
  return bytes;
}

std::string read_file_start(const std::string& path, std::size_t size) {
  std::string bytes;
  const LoadStatus status = read_first_bytes(path, size, bytes);
  require_read(status, path, errno);
  return bytes;
}

void write_file_atomically(const std::string& path, std::string_view bytes) {
  const std::string target = link_target(path);
  std::error_code ignored;
  if (std::filesystem::is_directory(target, ignored)) {
    throw Error(path, "is a folder; name a file in it");
  }
  PartialFile file(target + ".partial", target);
  file.write(bytes);
  file.commit();
}

}  // namespace flinch::database
