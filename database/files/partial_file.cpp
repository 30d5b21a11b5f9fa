// SPDX-License-Identifier: MIT
#include "database/files/partial_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "motion/error.h"

namespace flinch::database {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kPermissions = 0777;
constexpr mode_t kNewFile = 0666;  // before the umask
constexpr mode_t kOwnerMayWrite = 0600;

/// Removes what a killed process left at `path`. Returns 0 or an error number; EEXIST if it is no
/// regular file, EBUSY if a living process is writing it.
int remove_left_over(const std::string& path) {
  struct stat about {};
  if (::lstat(path.c_str(), &about) != 0) return errno == ENOENT ? 0 : errno;
  if (!S_ISREG(about.st_mode)) return EEXIST;
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  const bool is_locked = file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (file >= 0) ::close(file);
  if (is_locked) return EBUSY;
  return ::unlink(path.c_str()) == 0 || errno == ENOENT ? 0 : errno;
}

/// Makes a rename durable in a power failure. Returns 0, also where the file system cannot flush a
/// folder or this user cannot open it, or an error number.
int sync_folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  const int opened =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return 0;
  const int error = ::fsync(opened) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
  ::close(opened);
  return error;
}

}  // namespace

std::string link_target(const std::string& path) {
  constexpr int kMaxLinks = 40;  // as the kernel
  fs::path target = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    if (links == kMaxLinks) throw Error(path, "leads through too many links; check them");
    const fs::path next = fs::read_symlink(target, error);
    if (error) throw Error(path, "cannot be read: " + error.message());
    target = target.parent_path() / next;  // just `next` if that is absolute
  }
  return target.string();
}

std::string reason_and_remedy(int error_number) {
  const std::string reason = std::strerror(error_number);
  switch (error_number) {
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

int create_partial(const std::string& partial, const std::string& path) {
  struct stat replaced {};
  const bool is_new = ::lstat(path.c_str(), &replaced) != 0;
  const mode_t mode = is_new ? kNewFile : (replaced.st_mode & kNewFile) | kOwnerMayWrite;
  return ::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
}

PartialFile::PartialFile(const std::string& partial, const std::string& path)
    : partial_(partial), path_(path) {
  struct stat replaced {};
  if (::lstat(path_.c_str(), &replaced) == 0) {
    if (!S_ISREG(replaced.st_mode)) throw Error(path_, "is no regular file; name another file");
    mode_ = replaced.st_mode & kPermissions;
  }
  if (const int error = remove_left_over(partial_); error == EEXIST) {
    throw Error(partial_, "is in the way, and no file that flinch left; move it elsewhere");
  } else if (error == EBUSY) {
    throw Error(path_, "another process is writing it; wait for that to end, or stop it");
  } else if (error != 0) {
    fail(error);
  }
  descriptor_ = create_partial(partial_, path_);
  if (descriptor_ < 0) fail(errno);
  // Shows other processes that this one is alive. File systems without locks do without.
  static_cast<void>(::flock(descriptor_, LOCK_EX | LOCK_NB));
}

PartialFile::~PartialFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!partial_.empty()) ::unlink(partial_.c_str());
}

void PartialFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void PartialFile::commit() {
  struct stat about {};
  if (::fstat(descriptor_, &about) != 0) fail(errno);
  const bool is_other_mode = mode_ != 0 && (about.st_mode & kPermissions) != mode_;
  if (is_other_mode && ::fchmod(descriptor_, mode_) != 0) fail(errno);
  if (::fsync(descriptor_) != 0) fail(errno);
  // The file stays open, and so locked, until it has its name: nothing is written after the flush.
  if (std::rename(partial_.c_str(), path_.c_str()) != 0) fail(errno);
  partial_.clear();
  if (const int error = sync_folder_of(path_); error != 0) {
    throw Error(path_,
                "is complete, but may be lost in a power failure, because its folder cannot "
                "be flushed: " +
                    reason_and_remedy(error));
  }
}

void PartialFile::fail(int error_number) const {
  throw Error(path_, "cannot be written: " + reason_and_remedy(error_number));
}

}  // namespace flinch::database
