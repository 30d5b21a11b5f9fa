// SPDX-License-Identifier: MIT
#include "train/store/store_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "database/library/content_hash.h"
#include "motion/error.h"
#include "train/store/store_places.h"
#include "train/store/store_schema.h"
#include "train/store/store_trials.h"

namespace flinch::train {

namespace {

/// The numbers of a scenario, one per column after `number` and `target`. Version 6 lacks the
/// stance, version 5 also those of rods, version 4 those of strokes too, and version 3 the kind as
/// well.
constexpr std::array<const char*, 25> kScenarioColumns{"time_to_impact_s",
                                                       "threat_x",
                                                       "threat_y",
                                                       "threat_z",
                                                       "threat_velocity_x",
                                                       "threat_velocity_y",
                                                       "threat_velocity_z",
                                                       "radius_m",
                                                       "mass_kg",
                                                       "idle_time_s",
                                                       "character_x",
                                                       "character_y",
                                                       "character_facing",
                                                       "kind",
                                                       "stroke_starts_in_s",
                                                       "stroke_lasts_s",
                                                       "rod_axis_x",
                                                       "rod_axis_y",
                                                       "rod_axis_z",
                                                       "rod_turn_x",
                                                       "rod_turn_y",
                                                       "rod_turn_z",
                                                       "rod_to_butt_m",
                                                       "rod_to_tip_m",
                                                       "stance"};
constexpr std::size_t kKindColumn = 13;
constexpr std::size_t kRodColumn = kKindColumn + 3;
constexpr std::size_t kStanceColumn = kScenarioColumns.size() - 1;
using ScenarioNumbers = std::array<double, kScenarioColumns.size()>;

std::size_t scenario_column_count(int version) {
  if (version >= kStanceStoreFormatVersion) return kScenarioColumns.size();
  if (version == 6) return kStanceColumn;
  if (version == 5) return kRodColumn;
  return kKindColumn + (version < 4 ? 0 : 1);
}

std::span<const char* const> scenario_columns(int version) {
  return std::span(kScenarioColumns).first(scenario_column_count(version));
}

ScenarioNumbers numbers_of(const features::Scenario& scenario) {
  const features::Threat& threat = scenario.threat;
  const features::CharacterState& state = scenario.state;
  const features::Stroke stroke = threat.stroke.value_or(features::Stroke{});
  const features::Rod none{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(), 0, 0, 0, 0};
  const features::Rod rod = threat.rod.value_or(none);
  const std::array<float, kScenarioColumns.size()> numbers{scenario.time_to_impact_s,
                                                           threat.position.x(),
                                                           threat.position.y(),
                                                           threat.position.z(),
                                                           threat.velocity.x(),
                                                           threat.velocity.y(),
                                                           threat.velocity.z(),
                                                           threat.radius,
                                                           threat.mass_kg,
                                                           state.idle_time_s,
                                                           state.position.x(),
                                                           state.position.y(),
                                                           state.facing,
                                                           static_cast<float>(threat.kind),
                                                           stroke.starts_in_s,
                                                           stroke.lasts_s,
                                                           rod.axis.x(),
                                                           rod.axis.y(),
                                                           rod.axis.z(),
                                                           rod.angular_velocity.x(),
                                                           rod.angular_velocity.y(),
                                                           rod.angular_velocity.z(),
                                                           rod.to_butt_m,
                                                           rod.to_tip_m,
                                                           static_cast<float>(state.stance)};
  ScenarioNumbers exact{};
  std::ranges::copy(numbers, exact.begin());
  return exact;
}

/// Returns the scenario, whose kind must exist.
features::Scenario scenario_of(const ScenarioNumbers& numbers, motion::Target target,
                               const StoreHeader& header) {
  std::array<float, kScenarioColumns.size()> n{};
  std::ranges::transform(numbers, n.begin(), [](double x) { return static_cast<float>(x); });
  features::Scenario scenario;
  scenario.target = target;
  scenario.time_to_impact_s = n[0];
  const auto index = static_cast<std::size_t>(n[kKindColumn]);
  const features::KnownKind& kind = header.kinds[index];
  scenario.threat = {{n[1], n[2], n[3]}, {n[4], n[5], n[6]},     n[7], n[8], kind.bounce,
                     kind.falls,         static_cast<int>(index)};
  if (kind.is_driven()) scenario.threat.stroke = {n[kKindColumn + 1], n[kKindColumn + 2]};
  if (kind.shape == features::ThreatShape::rod) {
    const float* at = &n[kRodColumn];
    scenario.threat.rod =
        features::rod_of_kind(kind, {at[0], at[1], at[2]}, {at[3], at[4], at[5]}, at[6], at[7]);
  }
  scenario.state = {n[9], {n[10], n[11]}, n[12], static_cast<int>(n[kStanceColumn])};
  return scenario;
}

/// Checksum of the whole row: the number, the target's index, the scenario's numbers, the trials
/// and the places. Half of a 64-bit hash is enough to detect accidental damage.
std::int64_t checksum_of(std::uint64_t number, motion::Target target,
                         std::span<const double> numbers, std::span<const std::byte> trials,
                         std::span<const std::byte> places) {
  const auto place = static_cast<std::uint64_t>(target);
  std::vector<std::byte> bytes(sizeof number + sizeof place + numbers.size_bytes() + trials.size() +
                               places.size());
  std::byte* to = bytes.data();
  const auto put = [&to](const void* from, std::size_t size) {
    if (size > 0) std::memcpy(to, from, size);
    to += size;
  };
  put(&number, sizeof number);
  put(&place, sizeof place);
  put(numbers.data(), numbers.size_bytes());
  put(trials.data(), trials.size());
  put(places.data(), places.size());
  return static_cast<std::int32_t>(database::content_hash(bytes));
}

constexpr float kMaxOfTrial = 1e9F;  // J, N s

bool are_sound(std::span<const Trial> trials, const StoreHeader& header) {
  const auto is_bounded = [](float x) { return std::abs(x) <= kMaxOfTrial; };  // false for NaN
  return std::ranges::find(trials, header.idle, &Trial::clip) != trials.end() &&
         trials.back().clip < static_cast<int>(header.clips.size()) &&
         std::ranges::all_of(trials, [&](const Trial& trial) {
           return is_bounded(trial.work_j) && std::ranges::all_of(trial.impulse, is_bounded);
         });
}

/// Whether each place is of a trial, and no trial has too many.
bool are_sound(std::span<const HitPlace> places, std::span<const Trial> trials,
               const StoreHeader& header) {
  if (!places.empty() && !header.keeps_places) return false;
  auto trial = trials.begin();
  std::size_t count = 0;
  for (const HitPlace& place : places) {
    for (; trial != trials.end() && trial->clip < place.clip; ++trial) count = 0;
    if (trial == trials.end() || trial->clip != place.clip || ++count > kMaxPlacesPerTrial ||
        !(place.impulse_ns >= 0 && place.impulse_ns <= kMaxOfTrial))
      return false;
  }
  return true;
}

/// Whether a float can hold the numbers, and they are those of a scenario.
bool are_sound(const ScenarioNumbers& numbers, motion::Target target, const StoreHeader& header) {
  const auto is_bounded = [](double x) { return std::abs(x) <= double{features::kMaxExtent}; };
  const auto is_index = [](double x, std::size_t count) {
    return x >= 0 && x < static_cast<double>(count) && x == std::floor(x);
  };
  return std::ranges::all_of(numbers, is_bounded) &&
         is_index(numbers[kKindColumn], header.kinds.size()) &&
         is_index(numbers[kStanceColumn], std::max<std::size_t>(header.stances.size(), 1)) &&
         features::is_usable(scenario_of(numbers, target, header).threat);
}

std::string columns(int version) {
  std::string names = "number, target";
  for (const char* column : scenario_columns(version)) names += std::string(", ") + column;
  return names + ", trials" + (version < 6 ? "" : ", places") + ", checksum";
}

}  // namespace

std::string observation_table_sql(int version) {
  std::string sql = "CREATE TABLE observation(number INTEGER PRIMARY KEY, target TEXT NOT NULL";
  for (const char* column : scenario_columns(version))
    sql += std::string(", ") + column + " REAL NOT NULL";
  return sql + ", trials BLOB NOT NULL" + (version < 6 ? "" : ", places BLOB NOT NULL") +
         ", checksum INTEGER NOT NULL)";
}

Statement prepare_insert(Database& database, const StoreHeader& header) {
  std::string marks = "?, ?";
  for (std::size_t i = 0; i < scenario_column_count(header.format_version); ++i) marks += ", ?";
  return database.prepare("INSERT INTO observation(" + columns(header.format_version) +
                          ") VALUES(" + marks + ", ?, ?, ?)");
}

void insert(Statement& statement, const Observation& observation, const StoreHeader& header) {
  const motion::Target target = observation.scenario.target;
  const ScenarioNumbers all = numbers_of(observation.scenario);
  const auto numbers = std::span(all).first(scenario_column_count(header.format_version));
  const std::vector<std::byte> trials = encode_trials(observation.trials);
  const std::vector<std::byte> places = encode_places(observation.places);
  statement.bind(static_cast<std::int64_t>(observation.number))
      .bind(std::string(motion::name_of(target)));
  for (const double number : numbers) statement.bind(number);
  statement.bind(std::span<const std::byte>(trials))
      .bind(std::span<const std::byte>(places))
      .bind(checksum_of(observation.number, target, numbers, trials, places))
      .run();
}

Statement prepare_select(Database& database, const StoreHeader& header) {
  return database.prepare("SELECT " + columns(header.format_version) +
                          " FROM observation ORDER BY number");
}

Statement prepare_select_one(Database& database, const StoreHeader& header) {
  return database.prepare("SELECT " + columns(header.format_version) +
                          " FROM observation WHERE number = ?");
}

Observation observation_of(const Statement& row, const StoreHeader& header,
                           const std::string& path) {
  Observation observation;
  observation.number = static_cast<std::uint64_t>(row.integer(0));
  const auto target = motion::target_named(row.text(1));
  ScenarioNumbers numbers{};
  const std::span stored = std::span(numbers).first(scenario_column_count(header.format_version));
  for (std::size_t i = 0; i < stored.size(); ++i) stored[i] = row.real(2 + static_cast<int>(i));
  const int trials_column = 2 + static_cast<int>(stored.size());
  const std::span<const std::byte> trials = row.blob(trials_column);
  const bool has_places = header.format_version >= 6;
  const std::span<const std::byte> places =
      has_places ? row.blob(trials_column + 1) : std::span<const std::byte>{};
  if (!target || trials.size() > header.clips.size() * kMaxTrialBytes ||
      places.size() > header.clips.size() * kMaxPlacesPerTrial * kPlaceBytes ||
      row.integer(trials_column + (has_places ? 2 : 1)) !=
          checksum_of(observation.number, *target, stored, trials, places))
    throw Error(path, kDamagedStore);
  if (!are_sound(numbers, *target, header)) throw Error(path, kDamagedStore);
  observation.scenario = scenario_of(numbers, *target, header);
  observation.trials = decode_trials(trials);
  observation.places = decode_places(places);
  if (!are_sound(observation.trials, header) ||
      !are_sound(observation.places, observation.trials, header))
    throw Error(path, kDamagedStore);
  return observation;
}

ScenarioRange range_of_rows(Database& database) {
  Statement row = database.prepare(
      "SELECT coalesce((SELECT min(number) FROM observation), 0), "
      "coalesce((SELECT max(number) + 1 FROM observation), 0)");
  row.step();
  const auto first = static_cast<std::uint64_t>(row.integer(0));
  return {first, static_cast<std::uint64_t>(row.integer(1)) - first};
}

// Not count(*): see Database.
std::uint64_t count_rows(Database& database) {
  std::uint64_t count = 0;
  for (Statement row = database.prepare("SELECT number FROM observation"); row.step();) ++count;
  return count;
}

std::vector<ScenarioRange> missing_rows(Database& database, const ScenarioRange& wanted) {
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

bool have_same_row(const Observation& a, const Observation& b) {
  return a.number == b.number && a.scenario.target == b.scenario.target &&
         numbers_of(a.scenario) == numbers_of(b.scenario) &&
         encode_trials(a.trials) == encode_trials(b.trials) &&
         encode_places(a.places) == encode_places(b.places);
}

}  // namespace flinch::train
