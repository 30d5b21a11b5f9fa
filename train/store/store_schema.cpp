// SPDX-License-Identifier: MIT
#include "train/store/store_schema.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "database/library/content_hash.h"
#include "database/library/file_header.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "train/store/store_rows.h"

namespace flinch::train {

namespace {

void write_clips(Database& database, const StoreHeader& header) {
  Statement statement = database.prepare(
      "INSERT INTO clip(clip, name, work_j, target, direction_degrees, degree, "
      "onset_s, peak_s, end_s) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)");
  Statement unannotated = database.prepare("INSERT INTO clip(clip, name, work_j) VALUES(?, ?, ?)");
  for (std::size_t i = 0; i < header.clips.size(); ++i) {
    const models::ClipSummary& clip = header.clips[i];
    Statement& insert = clip.annotation ? statement : unannotated;
    insert.bind(static_cast<std::int64_t>(i)).bind(clip.name).bind(header.clip_work_j[i]);
    if (const auto& annotation = clip.annotation) {
      insert.bind(std::string(motion::name_of(annotation->target)))
          .bind(std::round(motion::degrees(double{annotation->direction})))
          .bind(std::string(motion::name_of(annotation->degree)))
          .bind(double{annotation->onset_s})
          .bind(double{annotation->peak_s})
          .bind(double{annotation->end_s});
    }
    insert.run();
  }
}

void write_library_file(Database& database, const StoreHeader& header) {
  database.prepare("INSERT INTO library(file) VALUES(?)")
      .bind(std::span<const std::byte>(header.library_file))
      .run();
}

void read_library_file(Database& database, StoreHeader& header) {
  Statement row = database.prepare("SELECT file FROM library");
  if (row.step()) {
    const std::span<const std::byte> bytes = row.blob(0);
    header.library_file.assign(bytes.begin(), bytes.end());
  }
  const database::VerifiedFile file =
      database::verify_file(database::kLibraryFormat, header.library_file);
  if (file.status != database::LoadStatus::ok || file.hash != header.library_hash)
    throw Error(database.path(), kDamagedStore);
}

void read_clips(Database& database, StoreHeader& header) {
  Statement row = database.prepare(
      "SELECT clip, name, work_j, target, direction_degrees, degree, onset_s, peak_s, end_s "
      "FROM clip ORDER BY clip");
  while (row.step()) {
    models::ClipSummary clip;
    clip.name = row.text(1);
    if (row.integer(0) != static_cast<std::int64_t>(header.clips.size()))
      throw Error(database.path(), kDamagedStore);
    if (!row.is_null(3)) {
      const auto target = motion::target_named(row.text(3));
      const auto degree = motion::degree_named(row.text(5));
      if (!target || !degree) throw Error(database.path(), kDamagedStore);
      clip.annotation = motion::Annotation{*target,
                                           static_cast<float>(motion::radians(row.real(4))),
                                           *degree,
                                           static_cast<float>(row.real(6)),
                                           static_cast<float>(row.real(7)),
                                           static_cast<float>(row.real(8))};
    }
    header.clips.push_back(std::move(clip));
    header.clip_work_j.push_back(row.real(2));
  }
}

void write_bodies_and_targets(Database& database, const StoreHeader& header) {
  Statement body = database.prepare("INSERT INTO body(body, name) VALUES(?, ?)");
  for (const motion::Body each : motion::kBodies) {
    body.bind(static_cast<std::int64_t>(each)).bind(std::string(name_of(each))).run();
  }
  Statement target = database.prepare("INSERT INTO target(name, x, y, z) VALUES(?, ?, ?, ?)");
  for (const motion::Target each : motion::kTargets) {
    const Eigen::Vector3d centre = header.idle_target_centres[each].cast<double>();
    target.bind(std::string(motion::name_of(each)))
        .bind(centre.x())
        .bind(centre.y())
        .bind(centre.z())
        .run();
  }
}

template <class Value>
void write_meta(Database& database, const char* key, const Value& value) {
  database.prepare("INSERT INTO meta(key, value) VALUES(?, ?)")
      .bind(std::string(key))
      .bind(value)
      .run();
}

/// Returns a statement whose current row is the value of a key of the meta table.
Statement meta(Database& database, const char* key) {
  Statement statement = database.prepare("SELECT value FROM meta WHERE key = ?");
  if (!statement.bind(std::string(key)).step()) throw Error(database.path(), kDamagedStore);
  return statement;
}

std::int64_t pragma(Database& database, const std::string& name) {
  Statement statement = database.prepare("PRAGMA " + name);
  return statement.step() ? statement.integer(0) : 0;
}

void require_store(Database& database) {
  if (pragma(database, "application_id") != kStoreApplicationId)
    throw Error(database.path(), "not a store; `flinch simulate` makes one");
  const std::int64_t version = pragma(database, "user_version");
  if (version != kStoreFormatVersion)
    throw Error(database.path(), "is a store of format " + std::to_string(version) +
                                     ", and this program reads format " +
                                     std::to_string(kStoreFormatVersion) +
                                     "; delete it and run `flinch simulate` again");
}

void add_bytes(const void* from, std::size_t size, std::vector<std::byte>& to) {
  const auto* first = static_cast<const std::byte*>(from);
  to.insert(to.end(), first, first + size);
}

/// Checksum of the range and of every value of the small tables, row by row: numbers as doubles,
/// texts with their lengths. The library has its own seal, and each observation its own checksum.
std::int64_t checksum_of(Database& database, const ScenarioRange& range) {
  std::vector<std::byte> bytes;
  add_bytes(&range.first, sizeof range.first, bytes);
  add_bytes(&range.count, sizeof range.count, bytes);
  for (const char* table :
       {"meta ORDER BY key", "clip ORDER BY clip", "body ORDER BY body", "target ORDER BY name"}) {
    Statement row = database.prepare(std::string("SELECT * FROM ") + table);
    while (row.step()) {
      for (int column = 0; column < row.column_count(); ++column) {
        const std::string text = row.is_text(column) ? row.text(column) : std::string();
        const double number =
            row.is_text(column) ? static_cast<double>(text.size()) : row.real(column);
        add_bytes(&number, sizeof number, bytes);
        add_bytes(text.data(), text.size(), bytes);
      }
    }
  }
  return static_cast<std::int64_t>(database::content_hash(bytes));
}

}  // namespace

void write_header(Database& database, const StoreHeader& header) {
  database.execute("PRAGMA application_id = " + std::to_string(kStoreApplicationId));
  database.execute("PRAGMA user_version = " + std::to_string(kStoreFormatVersion));
  database.execute("CREATE TABLE library(file BLOB NOT NULL)");
  database.execute("CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID");
  database.execute(
      "CREATE TABLE clip(clip INTEGER PRIMARY KEY, name TEXT NOT NULL, work_j REAL NOT NULL, "
      "target TEXT, direction_degrees REAL, degree TEXT, onset_s REAL, peak_s REAL, end_s REAL)");
  database.execute("CREATE TABLE body(body INTEGER PRIMARY KEY, name TEXT NOT NULL)");
  database.execute(
      "CREATE TABLE target(name TEXT PRIMARY KEY, x REAL NOT NULL, y REAL NOT NULL, "
      "z REAL NOT NULL) WITHOUT ROWID");
  database.execute(
      "CREATE TABLE seal(first INTEGER NOT NULL, scenarios INTEGER NOT NULL, "
      "checksum INTEGER NOT NULL)");
  create_observation_table(database);
  write_meta(database, "library_hash", database::hash_text(header.library_hash));
  write_meta(database, "library_name", header.library_name);
  write_meta(database, "seed", std::to_string(header.seed));
  write_meta(database, "distribution", header.distribution);
  write_meta(database, "simulation", header.simulation);
  write_meta(database, "reference_impulse_ns", header.reference_impulse_ns);
  write_meta(database, "reference_work_j", header.reference_work_j);
  write_meta(database, "idle_clip", std::int64_t{header.idle});
  write_library_file(database, header);
  write_clips(database, header);
  write_bodies_and_targets(database, header);
}

StoreHeader read_header(Database& database) {
  require_store(database);
  StoreHeader header;
  header.library_hash = std::strtoull(meta(database, "library_hash").text(0).c_str(), nullptr, 16);
  header.library_name = meta(database, "library_name").text(0);
  header.seed = std::strtoull(meta(database, "seed").text(0).c_str(), nullptr, 10);
  header.distribution = meta(database, "distribution").text(0);
  header.simulation = meta(database, "simulation").text(0);
  header.reference_impulse_ns = meta(database, "reference_impulse_ns").real(0);
  header.reference_work_j = meta(database, "reference_work_j").real(0);
  header.idle = static_cast<int>(meta(database, "idle_clip").integer(0));
  read_library_file(database, header);
  read_clips(database, header);
  Statement row = database.prepare("SELECT name, x, y, z FROM target");
  while (row.step()) {
    const auto target = motion::target_named(row.text(0));
    if (!target) throw Error(database.path(), kDamagedStore);
    header.idle_target_centres[*target] =
        Eigen::Vector3d(row.real(1), row.real(2), row.real(3)).cast<float>();
  }
  if (header.idle < 0 || header.idle >= static_cast<int>(header.clips.size()) ||
      !(header.reference_work_j > 0) || !(header.reference_impulse_ns > 0))
    throw Error(database.path(), kDamagedStore);
  return header;
}

void write_seal(Database& database, const ScenarioRange& range) {
  database.prepare("INSERT INTO seal(first, scenarios, checksum) VALUES(?, ?, ?)")
      .bind(static_cast<std::int64_t>(range.first))
      .bind(static_cast<std::int64_t>(range.count))
      .bind(checksum_of(database, range))
      .run();
}

void break_seal(Database& database) {
  database.execute("DELETE FROM seal");
}

std::optional<ScenarioRange> read_seal(Database& database) {
  Statement row = database.prepare("SELECT first, scenarios, checksum FROM seal");
  if (!row.step()) return std::nullopt;
  const ScenarioRange range{static_cast<std::uint64_t>(row.integer(0)),
                            static_cast<std::uint64_t>(row.integer(1))};
  if (row.integer(2) != checksum_of(database, range)) throw Error(database.path(), kDamagedStore);
  return range;
}

}  // namespace flinch::train
