// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

namespace flinch::database {

/// Returns the file that a program writes which opens `path`: `path` itself or, if that is a
/// symbolic link, where the link leads, whether or not that exists. Throws Error for links that
/// lead in a circle.
std::string link_target(const std::string& path);

/// Returns what the system says about an error, and what the user can do about it.
std::string reason_and_remedy(int error_number);

/// Creates an empty file `partial` anew, never through a link, which can be read by those who can
/// read the file at `path`, if there is one. Returns its descriptor, or -1 with errno set, EEXIST
/// if there is something already.
int create_partial(const std::string& partial, const std::string& path);

/// A file that is written under a temporary name and takes its final name when it is complete.
/// Whatever happens until then, the file that has that name is unchanged. All functions throw
/// Error, which names `path`.
class PartialFile {
 public:
  /// Creates the file `partial`, in the folder of `path`, anew: it never writes through a link. A
  /// regular file that a killed process left there is removed; anything else is refused, and so is
  /// a file that another process is writing. The new file can be read by those who can read `path`.
  PartialFile(const std::string& partial, const std::string& path);
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  /// Removes the partial file unless it has got its final name.
  ~PartialFile();

  void write(std::string_view bytes);

  /// Flushes the file to the disk, gives it the permissions of the file at `path`, if there is one,
  /// renames it to `path`, which may not be a link, and flushes the folder.
  void commit();

 private:
  [[noreturn]] void fail(int error_number) const;

  std::string partial_;
  std::string path_;
  mode_t mode_ = 0;  ///< of the file to be replaced; 0 if there is none
  int descriptor_ = -1;
};

}  // namespace flinch::database
