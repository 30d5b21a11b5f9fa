// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace flinch::train {

struct ReadUsage;

/// A prepared SQL statement. Columns and parameters count from 0. Throws Error as Database does.
class Statement {
 public:
  /// Each call binds the next parameter.
  Statement& bind(std::int64_t value);
  Statement& bind(double value);
  Statement& bind(const std::string& value);
  Statement& bind(std::span<const std::byte> value);

  /// Moves to the next row. Returns false if there is none; the statement can then be bound and run
  /// again.
  bool step();
  /// Runs the statement to its end.
  void run();

  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  /// Valid until the statement moves on.
  std::span<const std::byte> blob(int column) const;
  bool is_null(int column) const;
  bool is_text(int column) const;
  int column_count() const;

 private:
  friend class Database;
  Statement(sqlite3_stmt* statement, std::string path, std::shared_ptr<ReadUsage> usage);
  void check(int code) const;
  void count_row() const;

  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
  std::string path_;
  std::shared_ptr<ReadUsage> usage_;
  int bound_ = 0;
};

/// What reading a database has taken, and may take, of steps of SQLite's virtual machine and of
/// bytes in texts and blobs.
struct ReadUsage {
  std::uint64_t steps = 0;
  std::uint64_t bytes = 0;
  std::uint64_t max_steps = 0;
  std::uint64_t max_bytes = 0;
};

/// Returns a path by which SQLite opens the file that other programs open by `path`: SQLite would
/// take names such as ":memory:" or "file:a?mode=memory" for something else.
std::string plain_file_name(const std::string& path);

/// A SQLite database file. Every failure throws Error with the file's name and what to do; a full
/// disk, a lock held by another process and a file that is not a database have messages of their
/// own.
///
/// The file may be forged: pages that refer to each other in circles, rows that share their
/// content, views, triggers. So nothing in it is executed, and all statements of a connection
/// together may read a few times its size and take a number of steps in proportion to it; after
/// that they fail as for a damaged file. A clock plays no part. One step is short, but not that of
/// count(*), which visits every row: do not use it.
class Database {
 public:
  enum class Mode : std::uint8_t {
    read,
    write,
    create,  ///< also write, and refuse a path that is a link
  };
  Database(const std::string& path, Mode mode);

  /// Lifts the bounds, once the content has been checked and what follows is our own.
  void trust();

  const std::string& path() const { return path_; }
  Statement prepare(const std::string& sql);
  void execute(const std::string& sql);

 private:
  struct Closer {
    void operator()(sqlite3* database) const;
  };
  std::string path_;
  std::shared_ptr<ReadUsage> usage_ = std::make_shared<ReadUsage>();
  std::unique_ptr<sqlite3, Closer> database_;
};

/// Either all changes between its construction and commit() take effect, or none.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace flinch::train
