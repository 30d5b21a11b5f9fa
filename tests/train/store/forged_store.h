// SPDX-License-Identifier: MIT
#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "tests/train/store/made_up_store.h"
#include "train/store/sqlite.h"
#include "train/store/store_schema.h"

// Stores as an attacker would make them, with any SQL and any bytes, and their checksums right.
namespace flinch::train {

/// Writes a finished store of `count` scenarios.
inline void write_made_up_store(const std::string& path, std::uint64_t count) {
  const StoreHeader header = made_up_header();
  StoreWriter writer(path, header, {0, count});
  writer.append(made_up_observations(header, 0, count));
  writer.finish();
}

/// Runs statements as any SQLite program can, without the bounds of Database.
inline void forge(const std::string& path, const std::string& sql) {
  sqlite3* database = nullptr;
  const bool done = sqlite3_open(path.c_str(), &database) == SQLITE_OK &&
                    sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
  const std::string reason = sqlite3_errmsg(database);
  sqlite3_close(database);
  if (!done) throw std::runtime_error(sql + ": " + reason);
}

/// Makes the checksum of the small tables right again.
inline void seal_again(const std::string& path, std::uint64_t count) {
  Database database(path, Database::Mode::write);
  database.trust();
  break_seal(database);
  write_seal(database, {0, count});
}

inline constexpr std::size_t kPageSize = 16384;

/// Returns the big-endian number of `size` bytes at a place.
inline std::uint32_t number_at(const std::string& file, std::size_t at, std::size_t size) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number = number << 8 | static_cast<unsigned char>(file[at + i]);
  }
  return number;
}

inline void put_number(std::string& file, std::size_t at, std::size_t size, std::uint32_t number) {
  for (std::size_t i = 0; i < size; ++i) {
    file[at + i] = static_cast<char>(number >> (8 * (size - 1 - i)));
  }
}

/// Returns where a page, the first of which is 1, has the header of its tree.
inline std::size_t tree_header(std::uint32_t page) {
  return (page - 1) * kPageSize + (page == 1 ? 100 : 0);
}

/// Returns the root page of a table.
inline std::uint32_t root_of(const std::string& path, const std::string& table) {
  Database database(path, Database::Mode::read);
  Statement row =
      database.prepare("SELECT rootpage FROM sqlite_master WHERE name = '" + table + "'");
  row.step();
  return static_cast<std::uint32_t>(row.integer(0));
}

/// Moves the rows of a table, which are on one page, below `levels` pages that each refer a
/// thousand times to the next: a table of 1000^levels rows that takes a few pages.
inline std::string with_endless_table(std::string file, std::uint32_t root, int levels) {
  constexpr std::uint32_t kCells = 1000;
  const std::string leaf = file.substr((root - 1) * kPageSize, kPageSize);
  const auto next_page = static_cast<std::uint32_t>(file.size() / kPageSize) + 1;
  for (int level = 0; level < levels; ++level) {
    std::string page(kPageSize, '\0');
    const std::uint32_t child = next_page + static_cast<std::uint32_t>(level);
    page[0] = 5;  // an interior page of a table
    put_number(page, 3, 2, kCells);
    put_number(page, 5, 2, static_cast<std::uint32_t>(kPageSize - 5 * kCells));
    put_number(page, 8, 4, child);  // the rightmost child
    for (std::uint32_t cell = 0; cell < kCells; ++cell) {
      const std::size_t at = kPageSize - 5 * (cell + 1);
      put_number(page, at, 4, child);
      page[at + 4] = 100;  // the key, which no one compares while all rows are read
      put_number(page, 12 + 2 * cell, 2, static_cast<std::uint32_t>(at));
    }
    if (level == 0) {
      file.replace((root - 1) * kPageSize, kPageSize, page);
    } else {
      file += page;
    }
  }
  file += leaf;
  put_number(file, 28, 4, static_cast<std::uint32_t>(file.size() / kPageSize));
  return file;
}

}  // namespace flinch::train
