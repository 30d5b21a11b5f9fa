// SPDX-License-Identifier: MIT
#include "database/import/file_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

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

[[noreturn]] void fail_to_read(const std::string& path, int error) {
  throw Error(path, std::string("cannot be read: ") + std::strerror(error) +
                        (error == ENOENT ? "; check the path" : ""));
}

}  // namespace

std::string read_file(const std::string& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) fail_to_read(path, errno);
  struct stat about {};
  if (::fstat(file.number(), &about) != 0) fail_to_read(path, errno);
  if (S_ISDIR(about.st_mode)) throw Error(path, "is a folder, not a file");
  std::string bytes;
  if (about.st_size > 0) bytes.reserve(static_cast<std::size_t>(about.st_size));
  // Reads to the end, whatever the reported size: pipes have none.
  std::array<char, 1 << 16> chunk;
  while (true) {
    const ssize_t count = ::read(file.number(), chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_to_read(path, errno);
    if (count == 0) return bytes;
    bytes.append(chunk.data(), static_cast<std::size_t>(count));
  }
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
