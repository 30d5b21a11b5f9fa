// SPDX-License-Identifier: MIT
#include "train/store.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>

#include "motion/error.h"
#include "train/file_opening.h"
#include "train/sqlite.h"
#include "train/store_schema.h"

namespace flinch::train {

namespace {

namespace fs = std::filesystem;

std::int64_t integer(Database& database, const std::string& sql) {
  Statement statement = database.prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

Database open_for_reading(const std::string& path) {
  const database::FileKind kind = file_kind_at(path);
  if (kind != database::FileKind::store)
    throw Error(path,
                "is " + std::string(name_of(kind)) + ", not a store; `flinch simulate` makes one");
  Database database(path, Database::Mode::read);
  // SQLite reads a page that ends early as if zeros followed.
  const auto size = static_cast<std::int64_t>(fs::file_size(path));
  if (integer(database, "PRAGMA page_size") * integer(database, "PRAGMA page_count") != size)
    throw Error(path,
                "the store is damaged (cut short); delete it and run `flinch simulate` again");
  return database;
}

std::uint64_t count_of(Database& database) {
  Statement statement =
      database.prepare("SELECT count(*), coalesce(max(number) + 1, 0) FROM observation");
  statement.step();
  if (statement.integer(0) != statement.integer(1))
    throw Error(database.path(),
                "the store lacks scenarios in its middle; delete it and run "
                "flinch simulate again");
  return static_cast<std::uint64_t>(statement.integer(0));
}

/// Writes the whole database anew: the bytes then depend on its content alone and not on the
/// transactions that made it.
void write_compacted(Database& database, const std::string& path) {
  fs::remove(path);
  // VACUUM keeps, and raises, the one number in the header that counts what went before.
  database.execute("PRAGMA schema_version = 1");
  database.prepare("VACUUM INTO ?").bind(path).run();
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = file >= 0 && ::fsync(file) == 0;
  const int error = errno;
  if (file >= 0) ::close(file);
  if (!synced) throw Error(path, std::string("cannot be written: ") + std::strerror(error));
}

void rename_or_throw(const std::string& from, const std::string& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw Error(to, "cannot be written: " + error.message());
}

bool is_empty(Database& database) {
  return integer(database, "SELECT count(*) FROM sqlite_master") == 0;
}

}  // namespace

void require_same_run(const StoreHeader& stored, const StoreHeader& wanted,
                      const std::string& path) {
  const std::string remedy = "; choose another --out, or delete it";
  if (stored.library_hash != wanted.library_hash)
    throw Error(path, "made from another library (" + stored.library_name + ", " +
                          database::hash_text(stored.library_hash) + "), not from " +
                          wanted.library_name + ", " + database::hash_text(wanted.library_hash) +
                          remedy);
  if (stored.seed != wanted.seed)
    throw Error(path, "made with --seed " + std::to_string(stored.seed) + ", not " +
                          std::to_string(wanted.seed) + remedy);
  if (stored.distribution != wanted.distribution)
    throw Error(path, "made with another scenario distribution, " + stored.distribution + remedy);
  if (stored.simulation != wanted.simulation)
    throw Error(path, "made with another simulation, " + stored.simulation + remedy);
}

Store read_store(const std::string& path) {
  Database database = open_for_reading(path);
  Store store;
  store.header = read_header(database);
  Statement row = prepare_select(database);
  while (row.step()) store.observations.push_back(observation_of(row, store.header, path));
  return store;
}

StoreSummary summarise_store(const std::string& path) {
  Database database = open_for_reading(path);
  StoreSummary summary;
  summary.header = read_header(database);
  summary.observation_count = count_of(database);
  return summary;
}

struct StoreWriter::File {
  std::string path;
  std::optional<Database> database;
  std::uint64_t count = 0;

  std::string partial() const { return path + ".partial"; }
  std::string copy() const { return path + ".partial-copy"; }

  void start_from_finished(const StoreHeader& header) const;
  void open_partial(const StoreHeader& header);
};

/// Where a finished store stands and no partial one: go on from a copy of it.
void StoreWriter::File::start_from_finished(const StoreHeader& header) const {
  if (!fs::exists(path)) return;
  Database finished = open_for_reading(path);
  require_same_run(read_header(finished), header, path);
  if (fs::exists(partial())) return;
  std::error_code error;
  fs::copy_file(path, copy(), fs::copy_options::overwrite_existing, error);
  if (error) throw Error(partial(), "cannot be written: " + error.message());
  rename_or_throw(copy(), partial());
}

void StoreWriter::File::open_partial(const StoreHeader& header) {
  database.emplace(partial(), Database::Mode::create);
  // All of one run must have the same pages; the lock keeps other writers out until the end.
  database->execute("PRAGMA page_size = 4096");
  database->execute("PRAGMA locking_mode = EXCLUSIVE");
  Transaction transaction(*database);
  if (is_empty(*database)) write_header(*database, header);
  require_same_run(read_header(*database), header, partial());
  count = count_of(*database);
  transaction.commit();
}

StoreWriter::StoreWriter(const std::string& path, const StoreHeader& header)
    : file_(std::make_unique<File>()) {
  file_->path = path;
  if (fs::is_directory(path)) throw Error(path, "is a folder; name a file in it");
  file_->start_from_finished(header);
  file_->open_partial(header);
}

StoreWriter::~StoreWriter() = default;

std::uint64_t StoreWriter::count() const {
  return file_->count;
}
std::string StoreWriter::partial_path() const {
  return file_->partial();
}

void StoreWriter::append(std::span<const Observation> observations) {
  Transaction transaction(*file_->database);
  Statement statement = prepare_insert(*file_->database);
  for (const Observation& observation : observations) insert(statement, observation);
  transaction.commit();
  file_->count += observations.size();
}

void StoreWriter::finish() {
  write_compacted(*file_->database, file_->copy());
  rename_or_throw(file_->copy(), file_->path);
  file_->database.reset();
  fs::remove(file_->partial());
}

}  // namespace flinch::train
