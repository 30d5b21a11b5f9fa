// SPDX-License-Identifier: MIT
#include "train/store/store_schema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "database/library/content_hash.h"
#include "database/library/file_header.h"
#include "database/library/library_bounds.h"
#include "database/library/library_file.h"
#include "database/library/text_check.h"
#include "motion/error.h"
#include "motion/rotation.h"
#include "train/store/store_rows.h"

namespace flinch::train {

namespace {

/// Of numbers that only have to be finite and leave room for sums.
constexpr double kMaxMeasure = 1e12;
/// Bytes of a text in `meta`. Ours have some hundred, and at most 32 KiB: see parse_threats.
constexpr std::size_t kMaxDescription = 1 << 16;

/// The numbers of a kind of threat, one per column after `kind` and `name`.
constexpr std::array<const char*, 12> kKindColumns{
    "min_radius_m",         "max_radius_m",         "min_mass_kg",   "max_mass_kg",
    "min_speed_mps",        "max_speed_mps",        "min_elevation", "max_elevation",
    "min_time_to_impact_s", "max_time_to_impact_s", "restitution",   "friction"};
static_assert(kKindColumns.size() == features::KindNumbers{}.size());

/// The names of these columns, each after a comma and before `rest`.
std::string number_columns(const std::string& rest = "") {
  std::string text;
  for (const char* column : kKindColumns) text += std::string(", ") + column + rest;
  return text;
}

/// The numbers of a kind of rods, one per column at the end of the table; all 0 for other shapes.
constexpr std::array<const char*, 12> kRodColumns{
    "min_length_m", "max_length_m", "min_strikes_at", "max_strikes_at",
    "min_tilt",     "max_tilt",     "min_grip_share", "max_grip_share",
    "min_spin",     "max_spin",     "balance",        "grip_mass_kg"};
static_assert(kRodColumns.size() == features::RodNumbers{}.size());

std::string rod_columns(const std::string& rest = "") {
  std::string text;
  for (const char* column : kRodColumns) text += std::string(", ") + column + rest;
  return text;
}

/// A table of a store, as SQLite keeps its text.
struct StoreTable {
  std::string_view name;
  std::string sql;  ///< the statement that creates it
};

/// All tables of a store of this version, in the order in which they are created.
std::vector<StoreTable> store_tables(int version) {
  std::vector<StoreTable> tables{
      {"library", "CREATE TABLE library(file BLOB NOT NULL)"},
      {"meta", "CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID"},
      {"clip",
       "CREATE TABLE clip(clip INTEGER PRIMARY KEY, name TEXT NOT NULL, work_j REAL NOT NULL, "
       "target TEXT, direction_degrees REAL, degree TEXT, onset_s REAL, peak_s REAL, end_s REAL)"},
      {"body", "CREATE TABLE body(body INTEGER PRIMARY KEY, name TEXT NOT NULL)"},
      {"target",
       "CREATE TABLE target(name TEXT PRIMARY KEY, x REAL NOT NULL, y REAL NOT NULL, "
       "z REAL NOT NULL) WITHOUT ROWID"},
      {"seal",
       "CREATE TABLE seal(first INTEGER NOT NULL, scenarios INTEGER NOT NULL, "
       "checksum INTEGER NOT NULL)"},
      {"observation", observation_table_sql(version)},
  };
  std::string shape =
      version < 5 ? ""
                  : ", shape TEXT NOT NULL, min_reach_m REAL NOT NULL, max_reach_m REAL NOT NULL";
  if (version >= 6) shape += rod_columns(" REAL NOT NULL");
  if (version >= 4)
    tables.push_back({"kind", "CREATE TABLE kind(kind INTEGER PRIMARY KEY, name TEXT NOT NULL" +
                                  number_columns(" REAL NOT NULL") + ", falls INTEGER NOT NULL" +
                                  shape + ")"});
  return tables;
}

void write_kinds(Database& database, const StoreHeader& header) {
  std::string marks = "?, ?, ?, ?, ?, ?";
  for (std::size_t i = 0; i < kKindColumns.size() + kRodColumns.size(); ++i) marks += ", ?";
  Statement insert = database.prepare("INSERT INTO kind(kind, name" + number_columns() +
                                      ", falls, shape, min_reach_m, max_reach_m" + rod_columns() +
                                      ") VALUES(" + marks + ")");
  for (std::size_t i = 0; i < header.kinds.size(); ++i) {
    insert.bind(static_cast<std::int64_t>(i)).bind(header.kinds[i].name);
    for (const double number : numbers_of(header.kinds[i])) insert.bind(number);
    insert.bind(std::int64_t{header.kinds[i].falls})
        .bind(std::string(name_of(header.kinds[i].shape)))
        .bind(header.kinds[i].reach_m.min)
        .bind(header.kinds[i].reach_m.max);
    for (const double number : numbers_of(header.kinds[i].rod)) insert.bind(number);
    insert.run();
  }
}

void read_kinds(Database& database, StoreHeader& header) {
  if (header.format_version < 4) return;
  header.kinds.clear();
  const bool has_shapes = header.format_version >= 5;
  const bool has_rods = header.format_version >= 6;
  Statement row = database.prepare("SELECT kind, name, falls" + number_columns() +
                                   (has_shapes ? ", shape, min_reach_m, max_reach_m" : "") +
                                   (has_rods ? rod_columns() : "") + " FROM kind ORDER BY kind");
  while (row.step()) {
    features::KindNumbers numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = row.real(3 + static_cast<int>(i));
    features::KnownKind kind = features::kind_of(row.text(1), numbers, row.integer(2) != 0);
    if (has_shapes) {
      constexpr int kShapeColumn = 3 + static_cast<int>(numbers.size());
      const auto shape = features::threat_shape_named(row.text(kShapeColumn));
      if (!shape) throw Error(database.path(), kDamagedStore);
      kind.shape = *shape;
      kind.reach_m = {row.real(kShapeColumn + 1), row.real(kShapeColumn + 2)};
      features::RodNumbers rod{};
      for (std::size_t i = 0; has_rods && i < rod.size(); ++i)
        rod[i] = row.real(kShapeColumn + 3 + static_cast<int>(i));
      kind.rod = features::rod_ranges_of(rod);
    }
    if (row.integer(0) != static_cast<std::int64_t>(header.kinds.size()) ||
        header.kinds.size() == features::kMaxThreatKinds || !features::is_sound(kind) ||
        database::fault_of_name(kind.name) != nullptr)
      throw Error(database.path(), kDamagedStore);
    header.kinds.push_back(kind);
  }
  if (header.kinds.empty()) throw Error(database.path(), kDamagedStore);
}

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
  if (header.format_version < kStanceStoreFormatVersion) return;
  database::ClipLibrary library;
  if (database::read_library(header.library_file, library) != database::LoadStatus::ok)
    throw Error(database.path(), kDamagedStore);
  header.stances = stance_names(library);
}

/// A number that a float can hold. One that is out of its bounds stays so.
double bounded(const Statement& row, int column) {
  return std::clamp(row.real(column), -kMaxMeasure, kMaxMeasure);
}

/// Throws Error unless the clip's values are within their bounds.
void require_sound(const models::ClipSummary& clip, double work_j, const std::string& path) {
  if (database::fault_of_name(clip.name) != nullptr || !(std::abs(work_j) <= kMaxMeasure) ||
      (clip.annotation && database::fault_of(*clip.annotation, database::kMaxTime_s) != nullptr))
    throw Error(path, kDamagedStore);
}

void read_clips(Database& database, StoreHeader& header) {
  Statement row = database.prepare(
      "SELECT clip, name, work_j, target, direction_degrees, degree, onset_s, peak_s, end_s "
      "FROM clip ORDER BY clip");
  while (row.step()) {
    models::ClipSummary clip;
    clip.name = row.text(1);
    if (row.integer(0) != static_cast<std::int64_t>(header.clips.size()) ||
        header.clips.size() == database::kMaxClips)
      throw Error(database.path(), kDamagedStore);
    if (!row.is_null(3)) {
      const auto target = motion::target_named(row.text(3));
      const auto degree = motion::degree_named(row.text(5));
      if (!target || !degree) throw Error(database.path(), kDamagedStore);
      clip.annotation =
          motion::Annotation{.target = *target,
                             .direction = static_cast<float>(motion::radians(bounded(row, 4))),
                             .degree = *degree,
                             .onset_s = static_cast<float>(bounded(row, 6)),
                             .peak_s = static_cast<float>(bounded(row, 7)),
                             .end_s = static_cast<float>(bounded(row, 8))};
    }
    require_sound(clip, row.real(2), database.path());
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

/// Returns the text of a key of the meta table; an empty one where the key is missing.
std::string optional_meta(Database& database, const char* key) {
  Statement statement = database.prepare("SELECT value FROM meta WHERE key = ?");
  return statement.bind(std::string(key)).step() ? statement.text(0) : std::string();
}

std::int64_t pragma(Database& database, const std::string& name) {
  Statement statement = database.prepare("PRAGMA " + name);
  return statement.step() ? statement.integer(0) : 0;
}

/// Throws Error unless the file holds the tables of a store as write_header() makes them, and
/// nothing else: no view, trigger, index or virtual table, no column that is computed.
void require_tables(Database& database, int version) {
  const std::vector<StoreTable> tables = store_tables(version);
  std::size_t found = 0;
  Statement row = database.prepare("SELECT type, name, tbl_name, sql FROM sqlite_master");
  while (row.step()) {
    const auto is_this = [&row](const StoreTable& table) {
      return row.text(1) == table.name && row.text(2) == table.name && row.text(3) == table.sql;
    };
    if (row.text(0) != "table" || !std::ranges::any_of(tables, is_this))
      throw Error(database.path(),
                  "holds something else than the tables of a store; delete it and run `flinch "
                  "simulate` again");
    ++found;
  }
  Statement encoding = database.prepare("PRAGMA encoding");
  if (found != tables.size() || !encoding.step() || encoding.text(0) != "UTF-8")
    throw Error(database.path(), kDamagedStore);
}

/// Returns the version of its format.
int require_store(Database& database) {
  if (pragma(database, "application_id") != kStoreApplicationId)
    throw Error(database.path(), "not a store; `flinch simulate` makes one");
  const std::int64_t version = pragma(database, "user_version");
  if (version < kMinStoreFormatVersion || version > kStanceStoreFormatVersion)
    throw Error(database.path(),
                "is a store of format " + std::to_string(version) +
                    ", and this program reads format " + std::to_string(kStanceStoreFormatVersion) +
                    " and those before it from " + std::to_string(kMinStoreFormatVersion) + " on" +
                    "; delete it and run `flinch simulate` again");
  require_tables(database, static_cast<int>(version));
  return static_cast<int>(version);
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
  std::vector<const char*> tables{"meta ORDER BY key", "clip ORDER BY clip", "body ORDER BY body",
                                  "target ORDER BY name"};
  if (pragma(database, "user_version") >= 4) tables.push_back("kind ORDER BY kind");
  for (const char* table : tables) {
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

/// Throws Error unless a table has so many rows. To copy or to empty one that never ends would
/// never end.
void require_row_count(Database& database, const char* table, int min, int max) {
  Statement row = database.prepare(std::string("SELECT 1 FROM ") + table);
  int count = 0;
  while (count <= max && row.step()) ++count;
  if (count < min || count > max) throw Error(database.path(), kDamagedStore);
}

}  // namespace

void write_header(Database& database, const StoreHeader& header) {
  database.execute("PRAGMA application_id = " + std::to_string(kStoreApplicationId));
  database.execute("PRAGMA user_version = " + std::to_string(header.format_version));
  for (const StoreTable& table : store_tables(header.format_version)) database.execute(table.sql);
  write_meta(database, "library_hash", database::hash_text(header.library_hash));
  write_meta(database, "library_name", header.library_name);
  write_meta(database, "seed", std::to_string(header.seed));
  write_meta(database, "distribution", header.distribution);
  write_meta(database, "simulation", header.simulation);
  write_meta(database, "reference_impulse_ns", header.reference_impulse_ns);
  write_meta(database, "reference_work_j", header.reference_work_j);
  write_meta(database, "idle_clip", std::int64_t{header.idle});
  write_meta(database, "keeps_places", std::int64_t{header.keeps_places});
  if (!header.provenance.empty()) write_meta(database, "provenance", header.provenance);
  write_library_file(database, header);
  write_clips(database, header);
  write_bodies_and_targets(database, header);
  write_kinds(database, header);
}

StoreHeader read_header(Database& database) {
  StoreHeader header;
  header.format_version = require_store(database);
  require_row_count(database, "library", 1, 1);
  require_row_count(database, "body", motion::kBodyCount, motion::kBodyCount);
  require_row_count(database, "target", motion::kTargetCount, motion::kTargetCount);
  require_row_count(database, "seal", 0, 1);
  header.library_hash = std::strtoull(meta(database, "library_hash").text(0).c_str(), nullptr, 16);
  header.library_name = meta(database, "library_name").text(0);
  header.seed = std::strtoull(meta(database, "seed").text(0).c_str(), nullptr, 10);
  header.distribution = meta(database, "distribution").text(0);
  header.simulation = meta(database, "simulation").text(0);
  header.provenance = optional_meta(database, "provenance");
  const int meta_rows = (header.format_version < 6 ? 8 : 9) + (header.provenance.empty() ? 0 : 1);
  require_row_count(database, "meta", meta_rows, meta_rows);
  header.reference_impulse_ns = meta(database, "reference_impulse_ns").real(0);
  header.reference_work_j = meta(database, "reference_work_j").real(0);
  header.idle = static_cast<int>(meta(database, "idle_clip").integer(0));
  if (header.format_version >= 6)
    header.keeps_places = meta(database, "keeps_places").integer(0) != 0;
  read_library_file(database, header);
  read_clips(database, header);
  read_kinds(database, header);
  Statement row = database.prepare("SELECT name, x, y, z FROM target");
  while (row.step()) {
    const auto target = motion::target_named(row.text(0));
    if (!target) throw Error(database.path(), kDamagedStore);
    header.idle_target_centres[*target] =
        Eigen::Vector3d(bounded(row, 1), bounded(row, 2), bounded(row, 3)).cast<float>();
  }
  const auto is_measure = [](double x) { return x > 0 && x <= kMaxMeasure; };
  const auto is_description = [](const std::string& text) {
    return text.size() <= kMaxDescription && database::is_printable(text);
  };
  const auto is_near = [](const Eigen::Vector3f& place) {
    return (place.array().abs() <= database::kMaxDistance_m).all();  // false for NaN
  };
  if (header.idle < 0 || header.idle >= static_cast<int>(header.clips.size()) ||
      !is_measure(header.reference_work_j) || !is_measure(header.reference_impulse_ns) ||
      database::fault_of_name(header.library_name) != nullptr ||
      header.provenance.size() > database::kMaxProvenanceSize ||
      !database::is_printable(header.provenance) || !is_description(header.distribution) ||
      !is_description(header.simulation) ||
      !std::ranges::all_of(header.idle_target_centres, is_near))
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
  if (range.first >= kScenarioNumberEnd || range.count > kScenarioNumberEnd - range.first ||
      row.integer(2) != checksum_of(database, range))
    throw Error(database.path(), kDamagedStore);
  return range;
}

}  // namespace flinch::train
