// SPDX-License-Identifier: MIT
#include "train/store.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
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

/// From the lowest number to the highest.
ScenarioRange range_of(Database& database) {
  Statement statement = database.prepare(
      "SELECT coalesce((SELECT min(number) FROM observation), 0), "
      "coalesce((SELECT max(number) + 1 FROM observation), 0)");
  statement.step();
  const auto first = static_cast<std::uint64_t>(statement.integer(0));
  return {first, static_cast<std::uint64_t>(statement.integer(1)) - first};
}

std::string text_of(const ScenarioRange& range) {
  return "scenarios " + std::to_string(range.first) + " to " + std::to_string(range.end() - 1);
}

bool contains(const ScenarioRange& outer, const ScenarioRange& inner) {
  return inner.count == 0 || (inner.first >= outer.first && inner.end() <= outer.end());
}

/// SQLite's row numbers end where signed integers do.
constexpr std::uint64_t kScenarioNumberEnd = std::uint64_t{1} << 63;

void require_sound(const ScenarioRange& wanted, const std::string& path) {
  if (wanted.count == 0) throw Error(path, "no scenario is wanted; ask for at least one");
  if (wanted.first >= kScenarioNumberEnd || wanted.count > kScenarioNumberEnd - wanted.first)
    throw Error(path, std::to_string(wanted.count) + " scenarios from number " +
                          std::to_string(wanted.first) + " go past the last one, " +
                          std::to_string(kScenarioNumberEnd - 1) + "; ask for fewer or lower ones");
}

void require_wanted(const ScenarioRange& there, const ScenarioRange& wanted,
                    const std::string& path) {
  if (!contains(wanted, there))
    throw Error(path, "holds " + text_of(there) + ", which are not all among the wanted " +
                          text_of(wanted) +
                          "; ask for a range around them or choose another --out");
}

/// The numbers of `wanted` that have no row.
std::vector<ScenarioRange> missing_in(Database& database, const ScenarioRange& wanted) {
  std::vector<ScenarioRange> missing;
  std::uint64_t next = wanted.first;
  Statement row = database.prepare("SELECT number FROM observation ORDER BY number");
  while (row.step()) {
    const auto number = static_cast<std::uint64_t>(row.integer(0));
    if (number > next) missing.push_back({next, number - next});
    next = number + 1;
  }
  if (next < wanted.end()) missing.push_back({next, wanted.end() - next});
  return missing;
}

/// Takes `range`, which is all missing, out of what is missing.
void take_out(const ScenarioRange& range, std::vector<ScenarioRange>& missing) {
  const auto found =
      std::ranges::find_if(missing, [&](const ScenarioRange& gap) { return contains(gap, range); });
  const ScenarioRange gap = *found;
  const auto at = missing.erase(found);
  const ScenarioRange before{gap.first, range.first - gap.first};
  const ScenarioRange after{range.end(), gap.end() - range.end()};
  const auto inserted = after.count > 0 ? missing.insert(at, after) : at;
  if (before.count > 0) missing.insert(inserted, before);
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
  while (row.step()) {
    store.observations.push_back(observation_of(row, store.header, path));
    if (store.observations.back().number - store.observations.front().number !=
        store.observations.size() - 1)
      throw Error(path,
                  "the store lacks scenarios in its middle; run the `flinch simulate` that made it "
                  "again, or delete it");
  }
  return store;
}

StoreSummary summarise_store(const std::string& path) {
  Database database = open_for_reading(path);
  StoreSummary summary;
  summary.header = read_header(database);
  summary.range = range_of(database);
  summary.observation_count =
      static_cast<std::uint64_t>(integer(database, "SELECT count(*) FROM observation"));
  return summary;
}

bool StoreSummary::holds(const ScenarioRange& wanted) const {
  return observation_count == range.count && contains(range, wanted);
}

struct StoreWriter::File {
  std::string path;
  ScenarioRange wanted;
  std::vector<ScenarioRange> missing;
  std::optional<Database> database;

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
  require_wanted(range_of(finished), wanted, path);
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
  require_wanted(range_of(*database), wanted, partial());
  missing = missing_in(*database, wanted);
  transaction.commit();
}

StoreWriter::StoreWriter(const std::string& path, const StoreHeader& header, ScenarioRange wanted)
    : file_(std::make_unique<File>()) {
  require_sound(wanted, path);
  file_->path = path;
  file_->wanted = wanted;
  if (fs::is_directory(path)) throw Error(path, "is a folder; name a file in it");
  file_->start_from_finished(header);
  file_->open_partial(header);
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

void StoreWriter::append(std::span<const Observation> observations) {
  if (observations.empty()) return;
  const ScenarioRange range{observations.front().number, observations.size()};
  Transaction transaction(*file_->database);
  Statement statement = prepare_insert(*file_->database);
  for (const Observation& observation : observations) insert(statement, observation);
  transaction.commit();
  take_out(range, file_->missing);
}

void StoreWriter::finish() {
  write_compacted(*file_->database, file_->copy());
  rename_or_throw(file_->copy(), file_->path);
  file_->database.reset();
  fs::remove(file_->partial());
}

}  // namespace flinch::train
