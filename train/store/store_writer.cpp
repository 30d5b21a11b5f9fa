// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "database/files/partial_file.h"
#include "motion/error.h"
#include "train/store/file_opening.h"
#include "train/store/sqlite.h"
#include "train/store/store.h"
#include "train/store/store_rows.h"
#include "train/store/store_schema.h"

namespace flinch::train {

namespace {

namespace fs = std::filesystem;

void require_sound(const ScenarioRange& wanted, const std::string& path) {
  if (wanted.count == 0) throw Error(path, "no scenario is wanted; ask for at least one");
  if (wanted.first >= kScenarioNumberEnd || wanted.count > kScenarioNumberEnd - wanted.first)
    throw Error(path, std::to_string(wanted.count) + " scenarios from number " +
                          std::to_string(wanted.first) + " go past the last number, " +
                          std::to_string(kScenarioNumberEnd - 1) + "; ask for lower numbers");
}

void require_wanted(const ScenarioRange& there, const ScenarioRange& wanted,
                    const std::string& path) {
  if (contains(wanted, there)) return;
  const std::string held =
      "holds " + text_of(there) + ", " + std::to_string(there.count) + " in all, ";
  if (wanted.first >= there.end())
    throw Error(path, held + "and --first " + std::to_string(wanted.first) +
                          " is beyond its end; begin at " + std::to_string(there.first) +
                          " to continue it, or choose another --out and merge both");
  throw Error(path, held + "and not all are among the wanted " + text_of(wanted) +
                        "; ask for these too, or choose another --out");
}

/// Rows of an earlier format have other columns.
void require_current(const StoreHeader& stored, int version, const std::string& path) {
  if (stored.format_version != version)
    throw Error(path, "is a store of format " + std::to_string(stored.format_version) +
                          ", which can be read but not continued; choose another --out");
}

/// Writes the whole database anew, so that the bytes depend on its contents only and not on the
/// transactions that made it, as `copy`, which then replaces the file at `path`.
void write_compacted(Database& database, const std::string& copy, const std::string& path) {
  // VACUUM keeps and increments the one number in the header that counts earlier changes.
  database.execute("PRAGMA schema_version = 1");
  database::PartialFile file(copy, path);
  database.prepare("VACUUM INTO ?").bind(plain_file_name(copy)).run();
  file.commit();
}

bool is_empty(Database& database) {
  return !database.prepare("SELECT 1 FROM sqlite_master").step();
}

}  // namespace

database::Output store_output(const std::string& path) {
  return {path, database::FileKind::store, kStoreMark};
}

struct StoreWriter::File {
  std::string path;
  StoreHeader header;
  ScenarioRange wanted;
  database::Overwrite overwrite = database::Overwrite::refuse;
  std::vector<ScenarioRange> missing;
  std::optional<Database> database;

  std::string partial() const { return path + ".partial"; }
  std::string copy() const { return path + ".partial-copy"; }

  bool has_finished() const;
  void check_finished() const;
  void open_database();
  void require_not_removed() const;
  void open_partial();
  void start_partial();
  void remove_partial() const;
};

/// Whether there is a finished store to continue.
bool StoreWriter::File::has_finished() const {
  if (!fs::exists(path)) return false;
  return overwrite == database::Overwrite::refuse ||
         file_kind_at(path) == database::FileKind::store;
}

/// Before anything is written, checks that a finished store, if there is one, can be continued.
void StoreWriter::File::check_finished() const {
  if (!has_finished()) return;
  const StoreSummary finished = summarise_store(path);
  require_current(finished.header, header.format_version, path);
  require_same_run(finished.header, header, path);
  require_wanted(finished.range, wanted, path);
}

void StoreWriter::File::open_database() {
  // SQLite would let everyone read what continues a private store. Of a failure, it tells.
  if (const int created = database::create_partial(partial(), path); created >= 0) ::close(created);
  database.emplace(partial(), Database::Mode::create);
  // All stores of one run must have the same page size. The lock keeps other writers out until the
  // end.
  database->execute("PRAGMA page_size = 16384");
  database->execute("PRAGMA locking_mode = EXCLUSIVE");
}

/// Call inside a transaction.
void StoreWriter::File::require_not_removed() const {
  // The previous holder of the lock may have finished the file and removed it.
  if (!fs::exists(partial()))
    throw Error(path, "another process has just finished it; run the same command again");
}

void StoreWriter::File::open_partial() {
  open_database();
  Transaction transaction(*database);
  require_not_removed();
  if (is_empty(*database)) {
    database->trust();
    start_partial();
  }
  const StoreHeader stored = read_header(*database);
  require_current(stored, header.format_version, partial());
  require_same_run(stored, header, partial());
  require_wanted(range_of_rows(*database), wanted, partial());
  break_seal(*database);
  missing = missing_rows(*database, wanted);
  transaction.commit();
  database->trust();
}

/// Creates the tables and copies what a finished store holds already.
void StoreWriter::File::start_partial() {
  write_header(*database, header);
  if (!has_finished()) return;
  StoreReader finished(path);
  Statement statement = prepare_insert(*database, header);
  Observation observation;
  while (finished.next(observation)) insert(statement, observation, header);
}

/// Removes the partial file and all that belongs to it. Call while holding the lock, which keeps
/// other writers out.
void StoreWriter::File::remove_partial() const {
  // A journal goes before its database, which is committed and needs none.
  for (const std::string& left : {copy() + "-journal", copy(), partial() + "-journal", partial()})
    fs::remove(left);
}

StoreWriter::StoreWriter(const std::string& path, const StoreHeader& header, ScenarioRange wanted,
                         database::Overwrite overwrite)
    : file_(std::make_unique<File>()) {
  require_sound(wanted, path);
  file_->path = database::link_target(path);
  file_->overwrite = overwrite;
  file_->header = header;
  file_->header.format_version =
      header.stances.empty() ? kStoreFormatVersion : kStanceStoreFormatVersion;
  file_->wanted = wanted;
  if (fs::is_directory(path)) throw Error(path, "is a folder; name a file in it");
  file_->check_finished();
  file_->open_partial();
}

StoreWriter::~StoreWriter() = default;

std::vector<ScenarioRange> StoreWriter::missing() const {
  return file_->missing;
}

std::uint64_t StoreWriter::count() const {
  std::uint64_t count = file_->wanted.count;
  for (const ScenarioRange& range : file_->missing) count -= range.count;
  return count;
}

std::string StoreWriter::partial_path() const {
  return file_->partial();
}

bool StoreWriter::holds(const Observation& observation) const {
  Statement row = prepare_select_one(*file_->database, file_->header);
  return row.bind(static_cast<std::int64_t>(observation.number)).step() &&
         have_same_row(observation_of(row, file_->header, file_->partial()), observation);
}

void StoreWriter::append(std::span<const Observation> observations) {
  if (observations.empty()) return;
  std::vector<ScenarioRange> missing = file_->missing;
  take_out({observations.front().number, observations.size()}, missing);
  Transaction transaction(*file_->database);
  Statement statement = prepare_insert(*file_->database, file_->header);
  for (const Observation& observation : observations) insert(statement, observation, file_->header);
  transaction.commit();
  file_->missing = std::move(missing);
}

void StoreWriter::finish() {
  if (!file_->missing.empty())
    throw Error(file_->partial(),
                "lacks " + text_of(file_->missing.front()) + " still; run the same command again");
  Transaction transaction(*file_->database);
  write_seal(*file_->database, file_->wanted);
  transaction.commit();
  write_compacted(*file_->database, file_->copy(), file_->path);
  file_->remove_partial();
  file_->database.reset();
}

void StoreWriter::remove_left_overs(const std::string& path) {
  File file;
  file.path = database::link_target(path);
  const bool is_any_left = fs::exists(file.partial()) || fs::exists(file.copy()) ||
                           fs::exists(file.partial() + "-journal") ||
                           fs::exists(file.copy() + "-journal");
  if (!is_any_left) return;
  try {
    const StoreSummary finished = summarise_store(file.path);
    file.open_database();
    Transaction transaction(*file.database);
    file.require_not_removed();
    if (!is_empty(*file.database)) {
      require_same_run(read_header(*file.database), finished.header, file.partial());
      require_wanted(range_of_rows(*file.database), finished.range, file.partial());
    }
    file.remove_partial();
  } catch (const Error&) {
    // Another process is writing it, it holds more than the finished store, or it may not be
    // touched.
  }
}

}  // namespace flinch::train
