// SPDX-License-Identifier: MIT
#include "train/store/sqlite.h"

#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>

#include "database/library/input_file.h"
#include "motion/error.h"

namespace flinch::train {

namespace {

/// Of a text or blob: a store holds the library's file in one.
constexpr std::uint64_t kMaxLength = database::kMaxFileSize;

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
    case SQLITE_INTERRUPT:  // by count_steps
    case SQLITE_TOOBIG:
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

/// Number of steps between two calls of count_steps.
constexpr int kStepInterval = 1000;

/// Returns whether SQLite has to stop.
int count_steps(void* of) {
  auto& usage = *static_cast<ReadUsage*>(of);
  usage.steps += kStepInterval;
  return usage.steps > usage.max_steps ? 1 : 0;
}

/// Nothing in the file is executed, and no value, statement or depth is larger than a store has.
void harden(sqlite3* database, std::uint64_t file_size) {
  for (const int off :
       {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_TRIGGER, SQLITE_DBCONFIG_ENABLE_VIEW,
        SQLITE_DBCONFIG_DQS_DDL, SQLITE_DBCONFIG_DQS_DML}) {
    sqlite3_db_config(database, off, 0, nullptr);
  }
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  constexpr std::uint64_t kLeastLength = 1 << 20;
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH,
                static_cast<int>(std::clamp(file_size, kLeastLength, kMaxLength)));
  sqlite3_limit(database, SQLITE_LIMIT_SQL_LENGTH, 1 << 14);
  sqlite3_limit(database, SQLITE_LIMIT_COLUMN, 64);
  sqlite3_limit(database, SQLITE_LIMIT_EXPR_DEPTH, 32);
}

}  // namespace

void Statement::Finalizer::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Statement::Statement(sqlite3_stmt* statement, std::string path, std::shared_ptr<ReadUsage> usage)
    : statement_(statement), path_(std::move(path)), usage_(std::move(usage)) {}

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
  // A null pointer would bind NULL, not an empty blob.
  const void* bytes = value.empty() ? static_cast<const void*>("") : value.data();
  check(sqlite3_bind_blob64(statement_.get(), ++bound_, bytes, value.size(), SQLITE_TRANSIENT));
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  check(code);
  if (code == SQLITE_ROW) {
    count_row();
    return true;
  }
  check(sqlite3_reset(statement_.get()));
  bound_ = 0;
  return false;
}

/// Forged rows may share their content, so that a small file holds a large sum of texts.
void Statement::count_row() const {
  for (int column = 0; column < column_count(); ++column) {
    const int type = sqlite3_column_type(statement_.get(), column);
    if (type != SQLITE_TEXT && type != SQLITE_BLOB) continue;
    usage_->bytes += static_cast<std::uint64_t>(sqlite3_column_bytes(statement_.get(), column));
  }
  if (usage_->bytes > usage_->max_bytes) fail(nullptr, SQLITE_CORRUPT, path_);
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

  std::error_code ignored;  // there may be no file yet
  const std::uintmax_t found = std::filesystem::file_size(path, ignored);
  const std::uint64_t size = ignored ? 0 : found;
  harden(database, mode == Mode::read ? size : kMaxLength);
  // A row takes some 25 steps and 150 bytes. Checksums read the small tables a second time.
  constexpr std::uint64_t kSpare = 1 << 20;
  usage_->max_steps = kSpare + size;
  usage_->max_bytes = kSpare + 4 * size;
  sqlite3_progress_handler(database, kStepInterval, count_steps, usage_.get());
  execute("PRAGMA cell_size_check = ON");
  execute("PRAGMA mmap_size = 0");
}

// Finishing a store sets its schema version, which defensive connections may not.
void Database::trust() {
  usage_->max_steps = usage_->max_bytes = std::numeric_limits<std::uint64_t>::max();
  sqlite3_progress_handler(database_.get(), 0, nullptr, nullptr);
  sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
}

Statement Database::prepare(const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &statement, nullptr);
  if (code != SQLITE_OK) fail(database_.get(), code, path_);
  return Statement(statement, path_, usage_);
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
