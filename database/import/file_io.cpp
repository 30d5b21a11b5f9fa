// SPDX-License-Identifier: MIT
#include "database/import/file_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "database/library/input_file.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

/// An open file that closes itself.
class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  /// Closes now; returns false with errno set if the system reports a late write error.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

std::string reason_and_remedy(int error) {
  const std::string reason = std::strerror(error);
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return reason + "; free some space or write to another disk";
    case EFBIG:
      return reason + "; raise the limit on file size or write elsewhere";
    case EACCES:
    case EPERM:
    case EROFS:
      return reason + "; choose a place that you may write to or change its permissions";
    case ENOENT:
    case ENOTDIR:
      return reason + "; check the path, and make its folder first";
    default:
      return reason;
  }
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Returns 0, or the error number of the first call that failed.
int write_and_sync(const std::string& path, std::string_view bytes) {
  FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.number() < 0) return errno;
  if (!write_all(file.number(), bytes)) return errno;
  if (::fsync(file.number()) != 0) return errno;
  return file.close() ? 0 : errno;
}

/// Makes the rename durable in a power failure. Some file systems cannot sync a folder; the file is
/// complete anyway, so that is not an error.
void sync_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const FileDescriptor opened(
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) static_cast<void>(::fsync(opened.number()));
}

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
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Error(path, "is a folder; name a file in it");
  }
  const std::string partial = path + ".partial";
  int error = write_and_sync(partial, bytes);
  if (error == 0 && std::rename(partial.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(partial.c_str());
    throw Error(path, "cannot be written: " + reason_and_remedy(error));
  }
  sync_folder_of(path);
}

}  // namespace flinch::database
