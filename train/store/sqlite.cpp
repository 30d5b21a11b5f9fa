// SPDX-License-Identifier: MIT
#include "train/store/sqlite.h"

#include <sqlite3.h>

#include <filesystem>

#include "motion/error.h"

namespace flinch::train {

namespace {

[[noreturn]] void fail(sqlite3* database, int code, const std::string& path) {
  switch (code & 0xFF) {
    case SQLITE_FULL:
      throw Error(path,
                  "the disk is full; make room and run the same command again, what was "
                  "committed is kept");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw Error(path, "another process is using it; wait for that to end, or stop it");
    case SQLITE_NOTADB:
      throw Error(path, "not a store (not a SQLite file); `flinch simulate` makes one");
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // the statements are correct, so the tables are damaged
      throw Error(path, "the store is damaged; delete it and run `flinch simulate` again");
    case SQLITE_CANTOPEN:
      if (code == SQLITE_CANTOPEN_SYMLINK)
        throw Error(path, "is a link, and no file that flinch left; move it elsewhere");
      throw Error(path, "cannot open; check the path and its permissions");
    case SQLITE_READONLY:
      throw Error(path, "cannot write; check the permissions of the file and its folder");
    case SQLITE_IOERR:
      if (code == SQLITE_IOERR_WRITE)
        throw Error(path,
                    "cannot write, the disk or a file size limit may be full; make room and "
                    "run the same command again, what was committed is kept");
      break;
    default:
      break;
  }
  throw Error(path, database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code));
}

}  // namespace

void Statement::Finalizer::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Statement::Statement(sqlite3_stmt* statement, std::string path)
    : statement_(statement), path_(std::move(path)) {}

void Statement::check(int code) const {
  if (code == SQLITE_OK || code == SQLITE_ROW || code == SQLITE_DONE) return;
  sqlite3* database = sqlite3_db_handle(statement_.get());
  fail(database, sqlite3_extended_errcode(database), path_);
}

Statement& Statement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), ++bound_, value));
  return *this;
}

Statement& Statement::bind(double value) {
  check(sqlite3_bind_double(statement_.get(), ++bound_, value));
  return *this;
}

Statement& Statement::bind(const std::string& value) {
  check(sqlite3_bind_text64(statement_.get(), ++bound_, value.data(), value.size(),
                            SQLITE_TRANSIENT, SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind(std::span<const std::byte> value) {
  check(sqlite3_bind_blob64(statement_.get(), ++bound_, value.data(), value.size(),
                            SQLITE_TRANSIENT));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  check(code);
  if (code == SQLITE_ROW) return true;
  check(sqlite3_reset(statement_.get()));
  bound_ = 0;
  return false;
}

void Statement::run() {
  while (step()) {
  }
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
  const unsigned char* text = sqlite3_column_text(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return text == nullptr ? std::string() : std::string(text, text + size);
}

std::span<const std::byte> Statement::blob(int column) const {
  const auto* data = static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return {data, data == nullptr ? 0 : size};
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

bool Statement::is_text(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_TEXT;
}

int Statement::column_count() const {
  return sqlite3_column_count(statement_.get());
}

void Database::Closer::operator()(sqlite3* database) const {
  sqlite3_close_v2(database);
}

std::string plain_file_name(const std::string& path) {
  // The folder's links are followed here, because SQLITE_OPEN_NOFOLLOW refuses links anywhere in a
  // path.
  namespace fs = std::filesystem;
  const fs::path file(path);
  std::error_code error;
  const fs::path folder = fs::canonical(file.has_parent_path() ? file.parent_path() : ".", error);
  return error ? path : (folder / file.filename()).string();
}

Database::Database(const std::string& path, Mode mode) : path_(path) {
  int flags = SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
  if (mode == Mode::read) flags |= SQLITE_OPEN_READONLY;
  if (mode == Mode::write) flags |= SQLITE_OPEN_READWRITE;
  if (mode == Mode::create)
    flags |= SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOFOLLOW;
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(plain_file_name(path).c_str(), &database, flags, nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) fail(database, code, path_);
}

Statement Database::prepare(const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &statement, nullptr);
  if (code != SQLITE_OK) fail(database_.get(), code, path_);
  return Statement(statement, path_);
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(database_.get(), sqlite3_extended_errcode(database_.get()), path_);
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const Error&) {
    // SQLite has already rolled back on its own, as it does on a full disk.
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace flinch::train
