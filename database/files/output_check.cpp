// SPDX-License-Identifier: MIT
#include "database/files/output_check.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <vector>

#include "database/files/partial_file.h"
#include "database/library/input_file.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

namespace fs = std::filesystem;

/// Returns what is at a path, links followed, or nothing.
std::optional<struct stat> status_of(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) return std::nullopt;
  return about;
}

bool is_same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

/// Returns the first bytes of a file; none if it cannot be read.
std::string opening_of(const std::string& path) {
  std::string bytes;
  static_cast<void>(read_first_bytes(path, kFileOpening, bytes));
  return bytes;
}

/// Whether a file is, or a folder holds as motion capture, the file described by `about`.
bool holds(const std::string& input, const std::string& output, const struct stat& about) {
  const std::optional<struct stat> there = status_of(input);
  if (!there) return false;
  if (!S_ISDIR(there->st_mode)) return is_same_file(*there, about);
  if (!holds_motion(file_kind_of(opening_of(output)))) return false;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(
           input, fs::directory_options::skip_permission_denied, ignored)) {
    const std::optional<struct stat> file = status_of(entry.path().string());
    if (file && is_same_file(*file, about)) return true;
  }
  return false;
}

void require_no_input(const std::string& path, const struct stat& about,
                      const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (!holds(input, path, about)) continue;
    throw Error(path, (input == path ? std::string("is") : "is the same file as " + input + ",") +
                          " an input of this command; name another output");
  }
}

/// Whether a command may replace the regular file at `path` without being forced.
bool is_replaceable(const Output& output, const std::string& path, const struct stat& about) {
  if (about.st_size == 0) return true;
  const std::string opening = opening_of(path);
  return file_kind_of(opening) == output.kind && opening.find(output.mark) != std::string::npos;
}

void require_replaceable(const Output& output, const std::string& path, const struct stat& about) {
  if (is_replaceable(output, path, about)) return;
  const FileKind kind = file_kind_of(opening_of(path));
  throw Error(path, "is " + std::string(name_of(kind)) +
                        (kind == output.kind ? ", but not made by this command" : "") +
                        "; give --force to replace it, or name another output");
}

/// Throws Error that names `where` unless a file can be created at `path`.
void require_writable_folder(const std::string& path, const std::string& where) {
  const fs::path parent = fs::path(path).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  const std::optional<struct stat> about = status_of(folder);
  int error = about ? 0 : errno;
  if (about && !S_ISDIR(about->st_mode)) error = ENOTDIR;
  if (about && error == 0 && ::access(folder.c_str(), W_OK | X_OK) != 0) error = errno;
  if (error != 0) throw Error(where, "cannot be written: " + reason_and_remedy(error));
}

void check_partial(const Output& output, const std::string& partial,
                   const std::vector<std::string>& inputs, Overwrite overwrite) {
  struct stat about {};
  if (::lstat(partial.c_str(), &about) != 0) return;
  if (!S_ISREG(about.st_mode)) {
    throw Error(partial, "is in the way, and no file that flinch left; move it elsewhere");
  }
  require_no_input(partial, about, inputs);
  if (overwrite == Overwrite::refuse) require_replaceable(output, partial, about);
}

void check_output(const Output& output, const std::vector<std::string>& inputs,
                  Overwrite overwrite) {
  if (output.path.empty()) throw Error("", "the output has no name; name a file");
  if (const std::optional<struct stat> about = status_of(output.path)) {
    if (S_ISDIR(about->st_mode)) throw Error(output.path, "is a folder; name a file in it");
    if (!S_ISREG(about->st_mode)) {
      throw Error(output.path, "is a device, pipe or socket; name a file");
    }
    require_no_input(output.path, *about, inputs);
    if (overwrite == Overwrite::refuse) require_replaceable(output, output.path, *about);
  }
  const std::string target = link_target(output.path);
  require_writable_folder(target, output.path);
  check_partial(output, target + ".partial", inputs, overwrite);
}

/// Returns a path by which two names of one file, which need not exist, are the same.
fs::path comparable(const std::string& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(link_target(path)), ignored);
}

}  // namespace

void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs,
                   Overwrite overwrite) {
  for (const Output& output : outputs) check_output(output, inputs, overwrite);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (comparable(outputs[i].path) != comparable(outputs[k].path)) continue;
      throw Error(outputs[i].path, "is named as two outputs; name two files");
    }
  }
}

void check_output_folder(const std::string& folder, const std::vector<Output>& outputs,
                         const std::vector<std::string>& inputs, Overwrite overwrite) {
  if (const std::optional<struct stat> about = status_of(folder)) {
    if (!S_ISDIR(about->st_mode)) throw Error(folder, "is a file; name a folder");
    std::vector<Output> placed = outputs;
    for (Output& output : placed) output.path = (fs::path(folder) / output.path).string();
    check_outputs(placed, inputs, overwrite);
    return;
  }
  // All folders above it that are missing are created too.
  fs::path first_missing = fs::absolute(folder).lexically_normal();
  if (!first_missing.has_filename()) first_missing = first_missing.parent_path();
  while (first_missing.has_relative_path() && !status_of(first_missing.parent_path().string())) {
    first_missing = first_missing.parent_path();
  }
  require_writable_folder(first_missing.string(), folder);
}

}  // namespace flinch::database
