// SPDX-License-Identifier: MIT
#include "train/store/store.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <span>

#include "database/files/file_io.h"
#include "database/library/content_hash.h"
#include "database/library/library_file.h"
#include "features/feature_vector.h"
#include "motion/error.h"
#include "train/store/file_opening.h"
#include "train/store/sqlite.h"
#include "train/store/store_rows.h"
#include "train/store/store_schema.h"

namespace flinch::train {

namespace {

namespace fs = std::filesystem;

std::int64_t integer(Database& database, const std::string& sql) {
  Statement statement = database.prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

/// SQLite would make files beside a database that says that it has a write-ahead log, which no
/// store has (https://www.sqlite.org/fileformat2.html, section 1.3, bytes 18 and 19).
void require_rollback_journal(const std::string& path) {
  const std::string start = database::read_file_start(path, 20);
  if (start.size() < 20 || start[18] != 1 || start[19] != 1) throw Error(path, kDamagedStore);
}

Database open_for_reading(const std::string& path) {
  const database::FileKind kind = file_kind_at(path);
  if (kind != database::FileKind::store)
    throw Error(path,
                "is " + std::string(name_of(kind)) + ", not a store; `flinch simulate` makes one");
  require_rollback_journal(path);
  Database database(path, Database::Mode::read);
  // SQLite reads an incomplete page as if zeros followed.
  const auto size = static_cast<std::int64_t>(fs::file_size(path));
  if (integer(database, "PRAGMA page_size") * integer(database, "PRAGMA page_count") != size)
    throw Error(path,
                "the store is damaged (cut short); delete it and run `flinch simulate` again");
  return database;
}

bool has_clips_of(const StoreHeader& header, const database::ClipLibrary& library) {
  return std::ranges::equal(header.clips, library.clips, {}, &models::ClipSummary::name,
                            &motion::Clip::name);
}

/// Returns the library, whose stances the features need.
database::ClipLibrary library_of(const StoreHeader& header, const std::string& path) {
  database::ClipLibrary library;
  if (read_library(header.library_file, library) != database::LoadStatus::ok ||
      library.idle != header.idle || !has_clips_of(header, library))
    throw Error(path, kDamagedStore);
  return library;
}

/// The hash of a store before its first row.
std::uint64_t hash_of_run(const StoreHeader& header) {
  const std::string text = database::hash_text(header.library_hash) + ' ' +
                           std::to_string(header.seed) + ' ' + header.distribution + ' ' +
                           header.simulation;
  return database::content_hash(database::bytes_of(text));
}

/// The hash of a store after a row more.
std::uint64_t hash_with(std::uint64_t hash, std::int64_t row_checksum) {
  const std::array numbers{hash, static_cast<std::uint64_t>(row_checksum)};
  return database::content_hash(std::as_bytes(std::span(numbers)));
}

}  // namespace

std::vector<std::string> stance_names(const database::ClipLibrary& library) {
  std::vector<std::string> names;
  for (const int clip : database::stance_clips(library)) names.push_back(library.clip(clip).name);
  return names;
}

void require_same_run(const StoreHeader& stored, const StoreHeader& wanted, const std::string& path,
                      const std::string& remedy) {
  if (stored.library_hash != wanted.library_hash)
    throw Error(path, "made from another library (" + stored.library_name + ", " +
                          database::hash_text(stored.library_hash) + "), not from " +
                          wanted.library_name + ", " + database::hash_text(wanted.library_hash) +
                          "; " + remedy);
  if (stored.seed != wanted.seed)
    throw Error(path, "made with --seed " + std::to_string(stored.seed) + ", not " +
                          std::to_string(wanted.seed) + "; " + remedy);
  if (stored.distribution != wanted.distribution || stored.kinds != wanted.kinds)
    throw Error(path,
                "made with another scenario distribution, " + stored.distribution + "; " + remedy);
  if (stored.simulation != wanted.simulation)
    throw Error(path, "made with another simulation, " + stored.simulation + "; " + remedy);
  if (stored.keeps_places != wanted.keeps_places)
    throw Error(path, std::string("made ") + (stored.keeps_places ? "with" : "without") +
                          " --places; " + remedy);
}

struct StoreReader::File {
  explicit File(const std::string& path)
      : database(open_for_reading(path)),
        header(read_header(database)),
        seal(read_seal(database)),
        library(library_of(header, path)),
        stances(stance_loops(library)),
        hash(hash_of_run(header)),
        row(prepare_select(database, header)) {}

  /// Throws unless this is the number of the next observation.
  void require_next(std::uint64_t number);
  void require_whole() const;

  Database database;
  StoreHeader header;
  std::optional<ScenarioRange> seal;
  database::ClipLibrary library;
  std::vector<motion::Loop> stances;  ///< of the library
  std::uint64_t hash = 0;
  Statement row;
  ScenarioRange taken;
};

void StoreReader::File::require_next(std::uint64_t number) {
  if (taken.count == 0) taken.first = number;
  if (number != taken.end())
    throw Error(database.path(), "the store lacks " + text_of({taken.end(), number - taken.end()}) +
                                     "; run the `flinch simulate` that made it again");
  ++taken.count;
}

void StoreReader::File::require_whole() const {
  if (seal && taken != *seal) throw Error(database.path(), kDamagedStore);
}

StoreReader::StoreReader(const std::string& path) : file_(std::make_unique<File>(path)) {}
StoreReader::~StoreReader() = default;
StoreReader::StoreReader(StoreReader&&) noexcept = default;
StoreReader& StoreReader::operator=(StoreReader&&) noexcept = default;

const StoreHeader& StoreReader::header() const {
  return file_->header;
}

bool StoreReader::next(Observation& observation) {
  if (!file_->row.step()) {
    file_->require_whole();
    return false;
  }
  observation = observation_of(file_->row, file_->header, file_->database.path());
  file_->require_next(observation.number);
  file_->hash = hash_with(file_->hash, file_->row.integer(file_->row.column_count() - 1));
  const auto stance = static_cast<std::size_t>(observation.scenario.state.stance);
  observation.features =
      features::to_vector(features::features_of(observation.scenario, file_->stances[stance]));
  return true;
}

std::uint64_t StoreReader::hash() const {
  return file_->hash;
}

Store read_store(const std::string& path) {
  StoreReader reader(path);
  Store store;
  store.header = reader.header();
  Observation observation;
  while (reader.next(observation)) store.observations.push_back(std::move(observation));
  store.hash = reader.hash();
  return store;
}

StoreSummary summarise_store(const std::string& path) {
  Database database = open_for_reading(path);
  StoreSummary summary;
  summary.header = read_header(database);
  if (const std::optional<ScenarioRange> seal = read_seal(database)) {
    summary.range = *seal;
    summary.observation_count = seal->count;
  } else {
    summary.range = range_of_rows(database);
    summary.observation_count = count_rows(database);
  }
  return summary;
}

StoreContents count_contents(const std::string& path) {
  StoreContents contents;
  contents.bytes = fs::file_size(path);
  StoreReader reader(path);
  Observation observation;
  while (reader.next(observation)) {
    contents.trials += observation.trials.size();
    contents.places += observation.places.size();
    for (const Trial& trial : observation.trials)
      contents.impulses += static_cast<std::uint64_t>(
          std::ranges::count_if(trial.impulse, [](float impulse) { return impulse != 0; }));
  }
  contents.hash = reader.hash();
  return contents;
}

bool StoreSummary::holds(const ScenarioRange& wanted) const {
  return observation_count == range.count && contains(range, wanted);
}

}  // namespace flinch::train
