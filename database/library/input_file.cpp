// SPDX-License-Identifier: MIT
#include "database/library/input_file.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <system_error>
#include <utility>

namespace flinch::database {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A regular file, open for reading.
struct InputFile {
  std::unique_ptr<std::FILE, CloseFile> file;
  std::uintmax_t size = 0;
};

LoadStatus open(const std::string& path, InputFile& input) {
  std::error_code error;
  // What it is comes first: opening a FIFO would wait for a writer.
  const std::filesystem::file_status about = std::filesystem::status(path, error);
  if (!std::filesystem::exists(about)) return LoadStatus::cannot_open;
  if (!std::filesystem::is_regular_file(about)) return LoadStatus::not_a_file;
  input.file.reset(std::fopen(path.c_str(), "rb"));
  if (!input.file) return LoadStatus::cannot_open;
  input.size = std::filesystem::file_size(path, error);
  return error ? LoadStatus::cannot_open : LoadStatus::ok;
}

/// Reads up to `count` bytes. A file that has been cut short since open() has fewer.
template <class Bytes>
LoadStatus read(const InputFile& input, std::uintmax_t count, Bytes& bytes) {
  Bytes read(static_cast<std::size_t>(count), typename Bytes::value_type{});
  read.resize(std::fread(read.data(), 1, read.size(), input.file.get()));
  if (std::ferror(input.file.get()) != 0) return LoadStatus::cannot_open;
  bytes = std::move(read);
  return LoadStatus::ok;
}

template <class Bytes>
LoadStatus read_whole(const std::string& path, Bytes& bytes) noexcept try {
  InputFile input;
  if (const LoadStatus status = open(path, input); status != LoadStatus::ok) return status;
  if (input.size > kMaxFileSize) return LoadStatus::too_large;
  return read(input, input.size, bytes);
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
  InputFile input;
  if (const LoadStatus status = open(path, input); status != LoadStatus::ok) return status;
  return read(input, std::min<std::uintmax_t>(input.size, size), bytes);
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

}  // namespace flinch::database
