// SPDX-License-Identifier: MIT
#include "database/library/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <new>
#include <utility>

namespace flinch::database {
namespace {

/// A regular file, open for reading; closes itself and keeps errno.
class InputFile {
 public:
  InputFile() = default;
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile() {
    const int error = errno;
    if (descriptor_ >= 0) ::close(descriptor_);
    errno = error;
  }

  LoadStatus open(const std::string& path) {
    // Without O_NONBLOCK, opening a FIFO waits for a writer.
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    struct stat about {};
    if (descriptor_ < 0 || ::fstat(descriptor_, &about) != 0) return LoadStatus::cannot_open;
    if (!S_ISREG(about.st_mode)) return LoadStatus::not_a_file;
    size_ = static_cast<std::uintmax_t>(about.st_size);
    return LoadStatus::ok;
  }

  std::uintmax_t size() const { return size_; }

  /// Reads up to `count` bytes. A file that has been cut short since open() has fewer.
  template <class Bytes>
  LoadStatus read(std::size_t count, Bytes& bytes) const {
    Bytes read(count, typename Bytes::value_type{});
    std::size_t done = 0;
    while (done < count) {
      const ssize_t got = ::read(descriptor_, read.data() + done, count - done);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return LoadStatus::cannot_open;
      if (got == 0) break;
      done += static_cast<std::size_t>(got);
    }
    read.resize(done);
    bytes = std::move(read);
    return LoadStatus::ok;
  }

 private:
  int descriptor_ = -1;
  std::uintmax_t size_ = 0;
};

template <class Bytes>
LoadStatus read_whole(const std::string& path, Bytes& bytes) noexcept try {
  InputFile file;
  const LoadStatus status = file.open(path);
  if (status != LoadStatus::ok) return status;
  if (file.size() > kMaxFileSize) return LoadStatus::too_large;
  return file.read(static_cast<std::size_t>(file.size()), bytes);
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

}  // namespace

LoadStatus read_bytes(const std::string& path, std::vector<std::byte>& bytes) noexcept {
  return read_whole(path, bytes);
}

LoadStatus read_bytes(const std::string& path, std::string& bytes) noexcept {
  return read_whole(path, bytes);
}

LoadStatus read_first_bytes(const std::string& path, std::size_t size, std::string& bytes) noexcept
    try {
  InputFile file;
  const LoadStatus status = file.open(path);
  if (status != LoadStatus::ok) return status;
  return file.read(static_cast<std::size_t>(std::min<std::uintmax_t>(file.size(), size)), bytes);
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

}  // namespace flinch::database
