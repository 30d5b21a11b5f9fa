// SPDX-License-Identifier: MIT
#include "train/store_schema.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include "database/sealed_file.h"
#include "motion/error.h"

namespace flinch::train {

namespace {

static_assert(std::endian::native == std::endian::little, "the trials are kept little-endian");

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr const char* kDamaged = "the store is damaged; delete it and run `flinch simulate` again";

/// The columns before the features, in order, after the number.
constexpr std::array<const char*, 14> kScenarioColumns{"target TEXT NOT NULL",
                                                       "time_to_impact_s REAL NOT NULL",
                                                       "threat_x REAL NOT NULL",
                                                       "threat_y REAL NOT NULL",
                                                       "threat_z REAL NOT NULL",
                                                       "threat_velocity_x REAL NOT NULL",
                                                       "threat_velocity_y REAL NOT NULL",
                                                       "threat_velocity_z REAL NOT NULL",
                                                       "radius_m REAL NOT NULL",
                                                       "mass_kg REAL NOT NULL",
                                                       "idle_time_s REAL NOT NULL",
                                                       "character_x REAL NOT NULL",
                                                       "character_y REAL NOT NULL",
                                                       "character_facing REAL NOT NULL"};
constexpr int kFirstFeatureColumn = 1 + static_cast<int>(kScenarioColumns.size());
constexpr int kTrialsColumn = kFirstFeatureColumn + features::kFeatureCount;

std::string observation_table() {
  std::string sql = "CREATE TABLE observation(number INTEGER PRIMARY KEY";
  for (const char* column : kScenarioColumns) sql += std::string(", ") + column;
  for (const std::string_view name : features::kFeatureNames)
    sql += ", feature_" + std::string(name) + " REAL NOT NULL";
  return sql + ", trials BLOB NOT NULL)";
}

template <class T>
void put(std::vector<std::byte>& bytes, T value) {
  const auto* first = reinterpret_cast<const std::byte*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

template <class T>
T take(std::span<const std::byte>& bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes = bytes.subspan(sizeof value);
  return value;
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
          .bind(std::round(double{annotation->direction} * kDegrees))
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
  if (row.step()) header.library_file = row.blob(0);
  const database::Unsealed file = database::unseal(database::kLibraryKind, header.library_file);
  if (file.status != database::LoadStatus::ok || file.hash != header.library_hash)
    throw Error(database.path(), kDamaged);
}

void read_clips(Database& database, StoreHeader& header) {
  Statement row = database.prepare(
      "SELECT clip, name, work_j, target, direction_degrees, degree, onset_s, peak_s, end_s "
      "FROM clip ORDER BY clip");
  while (row.step()) {
    models::ClipSummary clip;
    clip.name = row.text(1);
    if (row.integer(0) != static_cast<std::int64_t>(header.clips.size()))
      throw Error(database.path(), kDamaged);
    if (!row.is_null(3)) {
      const auto target = motion::target_named(row.text(3));
      const auto degree = motion::degree_named(row.text(5));
      if (!target || !degree) throw Error(database.path(), kDamaged);
      clip.annotation = motion::Annotation{*target,
                                           static_cast<float>(row.real(4) / kDegrees),
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
  for (int i = 0; i < motion::kBodyCount; ++i) {
    body.bind(std::int64_t{i}).bind(std::string(name_of(static_cast<motion::Body>(i)))).run();
  }
  Statement target = database.prepare("INSERT INTO target(name, x, y, z) VALUES(?, ?, ?, ?)");
  for (std::size_t i = 0; i < header.idle_target_centres.size(); ++i) {
    const Eigen::Vector3d centre = header.idle_target_centres[i].cast<double>();
    target.bind(std::string(motion::name_of(static_cast<motion::Target>(i))))
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

/// A statement that stands on the value of a key of the meta table.
Statement meta(Database& database, const char* key) {
  Statement statement = database.prepare("SELECT value FROM meta WHERE key = ?");
  if (!statement.bind(std::string(key)).step()) throw Error(database.path(), kDamaged);
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
    throw Error(database.path(), "a store of format " + std::to_string(version) +
                                     ", this program reads format " +
                                     std::to_string(kStoreFormatVersion) +
                                     "; delete it and run `flinch simulate` again");
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
  database.execute(observation_table());
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
    if (!target) throw Error(database.path(), kDamaged);
    header.idle_target_centres[static_cast<std::size_t>(*target)] =
        Eigen::Vector3d(row.real(1), row.real(2), row.real(3)).cast<float>();
  }
  if (header.idle < 0 || header.idle >= static_cast<int>(header.clips.size()) ||
      !(header.reference_work_j > 0) || !(header.reference_impulse_ns > 0))
    throw Error(database.path(), kDamaged);
  return header;
}

Statement prepare_insert(Database& database) {
  std::string marks = "?";
  for (int column = 0; column < kTrialsColumn; ++column) marks += ", ?";
  return database.prepare("INSERT INTO observation VALUES(" + marks + ")");
}

void insert(Statement& statement, const Observation& observation) {
  const features::Scenario& scenario = observation.scenario;
  statement.bind(static_cast<std::int64_t>(observation.number))
      .bind(std::string(motion::name_of(scenario.target)))
      .bind(double{scenario.time_to_impact_s});
  for (int i = 0; i < 3; ++i) statement.bind(double{scenario.threat.position[i]});
  for (int i = 0; i < 3; ++i) statement.bind(double{scenario.threat.velocity[i]});
  statement.bind(double{scenario.threat.radius})
      .bind(double{scenario.threat.mass_kg})
      .bind(double{scenario.state.idle_time_s})
      .bind(double{scenario.state.position.x()})
      .bind(double{scenario.state.position.y()})
      .bind(double{scenario.state.facing});
  for (const float value : std::span(observation.features).first(features::kFeatureCount))
    statement.bind(double{value});
  const std::vector<std::byte> trials = encode_trials(observation.trials);
  statement.bind(std::span<const std::byte>(trials)).run();
}

Statement prepare_select(Database& database) {
  return database.prepare("SELECT * FROM observation ORDER BY number");
}

Observation observation_of(const Statement& row, const StoreHeader& header,
                           const std::string& path) {
  const auto real = [&row](int column) { return static_cast<float>(row.real(column)); };
  Observation observation;
  observation.number = static_cast<std::uint64_t>(row.integer(0));
  const auto target = motion::target_named(row.text(1));
  const std::vector<std::byte> bytes = row.blob(kTrialsColumn);
  if (!target || bytes.empty() || bytes.size() % kTrialBytes != 0) throw Error(path, kDamaged);
  features::Scenario& scenario = observation.scenario;
  scenario.target = *target;
  scenario.time_to_impact_s = real(2);
  scenario.threat.position = {real(3), real(4), real(5)};
  scenario.threat.velocity = {real(6), real(7), real(8)};
  scenario.threat.radius = real(9);
  scenario.threat.mass_kg = real(10);
  scenario.state = {real(11), {real(12), real(13)}, real(14)};
  bool sound = true;
  for (std::size_t i = 0; i < features::kFeatureCount; ++i) {
    observation.features[i] = real(kFirstFeatureColumn + static_cast<int>(i));
    sound = sound && std::isfinite(observation.features[i]);
  }
  observation.trials = decode_trials(bytes);
  bool tried_idle = false;
  for (const Trial& trial : observation.trials) {
    tried_idle = tried_idle || trial.clip == header.idle;
    sound = sound && trial.clip < static_cast<int>(header.clips.size()) &&
            std::isfinite(trial.work_j) &&
            std::ranges::all_of(trial.impulse, [](float i) { return std::isfinite(i); });
  }
  if (!sound || !tried_idle) throw Error(path, kDamaged);
  return observation;
}

std::vector<std::byte> encode_trials(std::span<const Trial> trials) {
  std::vector<std::byte> bytes;
  bytes.reserve(trials.size() * kTrialBytes);
  for (const Trial& trial : trials) {
    put(bytes, static_cast<std::uint16_t>(trial.clip));
    put(bytes, trial.work_j);
    for (const float impulse : trial.impulse) put(bytes, impulse);
  }
  return bytes;
}

std::vector<Trial> decode_trials(std::span<const std::byte> bytes) {
  std::vector<Trial> trials(bytes.size() / kTrialBytes);
  for (Trial& trial : trials) {
    trial.clip = take<std::uint16_t>(bytes);
    trial.work_j = take<float>(bytes);
    for (float& impulse : trial.impulse) impulse = take<float>(bytes);
  }
  return trials;
}

}  // namespace flinch::train
