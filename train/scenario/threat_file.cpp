// SPDX-License-Identifier: MIT
#include "train/scenario/threat_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "database/files/file_kind.h"
#include "database/files/toml_reader.h"
#include "database/library/library_bounds.h"
#include "motion/error.h"
#include "threats_embedded.h"

namespace flinch::train {

namespace {

using database::TomlReader;

std::string shown(double number) {
  std::string text = std::to_string(number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// The numbers that a key may have.
struct Bounds {
  double min = 0;
  double max = 0;
  const char* unit = "";
};

constexpr Bounds kRadius{0.001, 1, " m"};
constexpr Bounds kMass{0.001, 100, " kg"};
constexpr Bounds kSpeed{0.1, 200, " m/s"};
constexpr Bounds kAzimuth{-360, 360, " degrees"};
constexpr Bounds kElevation{-89, 89, " degrees"};
constexpr Bounds kTime{0.05, 10, " s"};
constexpr Bounds kReach{0.05, 5, " m"};
constexpr Bounds kLength{0.05, double{features::kMaxRodLength_m}, " m"};
constexpr Bounds kShare{0, 1, ""};
constexpr Bounds kGripMass{0, 100, " kg"};
constexpr Bounds kSpin{0, 20, " turns per second"};
constexpr Bounds kAimRadius{0, 1, " m"};
constexpr Bounds kWeight{0, 1e6, ""};
constexpr Bounds kRestitution{0, 1, ""};
constexpr Bounds kFriction{0, 2, ""};
/// Of a kind. More would not fit into a store's description of its scenarios.
constexpr std::size_t kMaxSectors = 16;

void require_in(const TomlReader& reader, std::string_view key, double value,
                const Bounds& bounds) {
  if (value >= bounds.min && value <= bounds.max) return;  // false for NaN
  reader.fail(key, "has " + std::string(key) + " " + shown(value) + ", which is not from " +
                       shown(bounds.min) + " to " + shown(bounds.max) + bounds.unit);
}

double number(const TomlReader& reader, std::string_view key, double otherwise,
              const Bounds& bounds) {
  const double value = reader.number(key).value_or(otherwise);
  require_in(reader, key, value, bounds);
  return value;
}

/// Returns the range that two numbers are, if they are two.
std::optional<ValueRange> pair_of(const toml::node& node) {
  const toml::array* values = node.as_array();
  if (values == nullptr || values->size() != 2 || !(*values)[0].is_number() ||
      !(*values)[1].is_number())
    return std::nullopt;
  return ValueRange{*(*values)[0].value<double>(), *(*values)[1].value<double>()};
}

void require_sound(const TomlReader& reader, std::string_view key, const ValueRange& range,
                   const Bounds& bounds) {
  require_in(reader, key, range.min, bounds);
  require_in(reader, key, range.max, bounds);
  if (range.min > range.max)
    reader.fail(key, "has " + std::string(key) + " from " + shown(range.min) + " to " +
                         shown(range.max) + "; give the smaller number first");
}

ValueRange range(const TomlReader& reader, std::string_view key, const ValueRange& otherwise,
                 const Bounds& bounds) {
  const toml::node* node = reader.table().get(key);
  if (node == nullptr) return otherwise;
  std::optional<ValueRange> given = pair_of(*node);
  if (node->is_number()) {
    const double value = *node->value<double>();
    given = {value, value};
  }
  if (!given) reader.fail(key, "needs a number or [min, max] for " + std::string(key));
  require_sound(reader, key, *given, bounds);
  return *given;
}

ValueRange in_radians(const ValueRange& degrees) {
  return {motion::radians(degrees.min), motion::radians(degrees.max)};
}

ValueRange elevation(const TomlReader& reader, const ValueRange& otherwise) {
  constexpr std::string_view kKey = "elevation_degrees";
  return reader.has(kKey) ? in_radians(range(reader, kKey, {}, kElevation)) : otherwise;
}

std::vector<ValueRange> azimuth(const TomlReader& reader,
                                const std::vector<ValueRange>& otherwise) {
  constexpr std::string_view kKey = "azimuth_degrees";
  const toml::node* node = reader.table().get(kKey);
  if (node == nullptr) return otherwise;
  std::vector<ValueRange> sectors;
  const toml::array* list = node->as_array();
  if (list != nullptr && list->size() > kMaxSectors)
    reader.fail(kKey, "has more than " + std::to_string(kMaxSectors) + " sectors for " +
                          std::string(kKey) + "; join some of them");
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    const std::optional<ValueRange> sector = pair_of((*list)[i]);
    if (!sector) {
      sectors.clear();
      break;
    }
    require_sound(reader, kKey, *sector, kAzimuth);
    sectors.push_back(in_radians(*sector));
  }
  if (sectors.empty())
    reader.fail(kKey, "needs sectors for " + std::string(kKey) + ", such as [[-60, 60]]");
  return sectors;
}

motion::PerTarget<double> target_weights(const TomlReader& reader,
                                         const motion::PerTarget<double>& otherwise) {
  if (!reader.has("targets")) return otherwise;
  const toml::table* table = reader.table()["targets"].as_table();
  if (table == nullptr) reader.fail("targets", "needs targets = { head = 1, … }");
  const TomlReader targets(*table, reader.path(), "targets");
  targets.expect_keys({"head", "trunk", "pelvis", "legs"});
  motion::PerTarget<double> weights;
  for (const motion::Target target : motion::kTargets)
    weights[target] = number(targets, name_of(target), 0, kWeight);
  if (sum(weights) <= 0) targets.fail({}, "need one with a weight above 0");
  return weights;
}

bool falls(const TomlReader& reader, bool otherwise) {
  const std::optional<std::string> flight = reader.text("flight");
  if (!flight) return otherwise;
  if (*flight != "falling" && *flight != "straight")
    reader.fail("flight",
                "has an unknown flight \"" + *flight + "\"; known are: falling, straight");
  return *flight == "falling";
}

features::ThreatShape shape(const TomlReader& reader) {
  const std::optional<std::string> name = reader.text("shape");
  if (!name) return features::ThreatShape::ball;
  if (const auto known = features::threat_shape_named(*name)) return *known;
  reader.fail("shape", "has an unknown shape \"" + *name + "\"; known are: ball, blade, fist, rod");
}

ValueRange tilt(const TomlReader& reader) {
  constexpr std::string_view kKey = "tilt_degrees";
  return in_radians(range(reader, kKey, {-45, 45}, kAzimuth));
}

/// Reads what makes a kind one of rods.
features::RodRanges rod_ranges(const TomlReader& reader, const ThreatKind& kind) {
  const bool is_swung = reader.has("reach_m");
  features::RodRanges rod;
  if (!reader.has("length_m")) reader.fail({}, "needs length_m, how long the rod is");
  rod.length_m = range(reader, "length_m", {}, kLength);
  if (rod.length_m.min <= 2 * kind.radius_m.max)
    reader.fail("length_m", "has a rod that is not longer than it is thick, " +
                                shown(2 * kind.radius_m.max) + " m");
  const double nearest = is_swung ? 0.05 : 0;
  rod.strikes_at = range(reader, "strikes_at", {0.8, 0.8}, {nearest, 1, ""});
  rod.tilt = tilt(reader);
  rod.balance = number(reader, "balance", 0.5, kShare);
  if (is_swung) {
    rod.grip_share = range(reader, "grip_share", {0.2, 0.2}, kShare);
    rod.grip_mass_kg = number(reader, "grip_mass_kg", 0, kGripMass);
  } else {
    const ValueRange turns = range(reader, "spin_per_s", {}, kSpin);
    rod.spin = {2 * std::numbers::pi * turns.min, 2 * std::numbers::pi * turns.max};
  }
  return rod;
}

/// A key that only some shapes have.
struct KeyOfShape {
  std::string_view key;
  bool is_of_kind;
  std::string_view owner;  ///< "only a rod has it"
};

void require_keys_of_shape(const TomlReader& reader, const ThreatKind& kind) {
  const bool is_rod = kind.shape == features::ThreatShape::rod;
  const bool is_swung = is_rod && reader.has("reach_m");
  const bool is_fist = kind.shape == features::ThreatShape::fist;
  for (const KeyOfShape& it :
       {KeyOfShape{"reach_m", is_fist || is_rod, "a fist and a swung rod have"},
        KeyOfShape{"length_m", is_rod, "a rod has"}, KeyOfShape{"strikes_at", is_rod, "a rod has"},
        KeyOfShape{"balance", is_rod, "a rod has"}, KeyOfShape{"tilt_degrees", is_rod, "a rod has"},
        KeyOfShape{"grip_share", is_swung, "a swung rod has, one with reach_m"},
        KeyOfShape{"grip_mass_kg", is_swung, "a swung rod has, one with reach_m"},
        KeyOfShape{"spin_per_s", is_rod && !is_swung, "a thrown rod has, one without reach_m"}}) {
    if (reader.has(it.key) && !it.is_of_kind)
      reader.fail(it.key, "has " + std::string(it.key) + ", which only " + std::string(it.owner));
  }
}

/// Reads what depends on the shape: how it bounces and flies, its reach, and what rods have.
void read_by_shape(const TomlReader& reader, ThreatKind& kind) {
  using features::ThreatShape;
  kind.shape = shape(reader);
  require_keys_of_shape(reader, kind);
  const bool is_driven = reader.has("reach_m");
  if (kind.shape == ThreatShape::fist && !is_driven)
    reader.fail({}, "needs reach_m, how far the fist moves before the impact");
  if (kind.shape != ThreatShape::ball) kind.bounce.restitution = 0;
  if (is_driven) kind.falls = false;
  kind.bounce.restitution = number(reader, "restitution", kind.bounce.restitution, kRestitution);
  kind.bounce.friction = number(reader, "friction", kind.bounce.friction, kFriction);
  kind.falls = falls(reader, kind.falls);
  if (kind.shape == ThreatShape::blade && kind.bounce.restitution > 0)
    reader.fail("restitution", "has a blade that bounces; a blade's restitution is 0");
  if (is_driven && kind.falls)
    reader.fail("flight", "has a " + std::string(name_of(kind.shape)) +
                              " that falls; what is driven has the flight \"straight\"");
  if (is_driven) kind.reach_m = range(reader, "reach_m", {}, kReach);
  if (kind.shape == ThreatShape::rod) kind.rod = rod_ranges(reader, kind);
}

ThreatKind kind_of(const TomlReader& reader) {
  reader.expect_keys({"name",         "weight",          "radius_m",          "mass_kg",
                      "speed_mps",    "azimuth_degrees", "elevation_degrees", "time_to_impact_s",
                      "targets",      "aim_radius_m",    "restitution",       "friction",
                      "flight",       "shape",           "reach_m",           "length_m",
                      "strikes_at",   "balance",         "tilt_degrees",      "grip_share",
                      "grip_mass_kg", "spin_per_s"});
  ThreatKind kind;
  kind.name = reader.needed_text("name");
  if (const char* fault = database::fault_of_name(kind.name)) reader.fail("name", fault);
  kind.weight = number(reader, "weight", kind.weight, kWeight);
  kind.radius_m = range(reader, "radius_m", kind.radius_m, kRadius);
  kind.mass_kg = range(reader, "mass_kg", kind.mass_kg, kMass);
  kind.speed_mps = range(reader, "speed_mps", kind.speed_mps, kSpeed);
  kind.azimuth = azimuth(reader, kind.azimuth);
  kind.elevation = elevation(reader, kind.elevation);
  kind.time_to_impact_s = range(reader, "time_to_impact_s", kind.time_to_impact_s, kTime);
  kind.target_weight = target_weights(reader, kind.target_weight);
  kind.aim_radius_m = number(reader, "aim_radius_m", kind.aim_radius_m, kAimRadius);
  read_by_shape(reader, kind);
  return kind;
}

bool is_on_grid(double time_s, double from_s, double step_s) {
  const double steps = (time_s - from_s) / step_s;
  return std::abs(steps - std::round(steps)) < 1e-6;
}

/// Scenarios share responses, so the times of all kinds are on one grid. Checks the last kind.
void require_grid(const TomlReader& reader, const std::vector<ThreatKind>& kinds) {
  const double step_s = ScenarioDistribution{{}}.time_to_impact_step_s;
  const double from_s = kinds.front().time_to_impact_s.min;
  const ValueRange& time_s = kinds.back().time_to_impact_s;
  if (is_on_grid(time_s.min, from_s, step_s) && is_on_grid(time_s.max, from_s, step_s)) return;
  reader.fail("time_to_impact_s", "has time_to_impact_s that is not a whole number of steps of " +
                                      shown(step_s) + " s from " + shown(from_s) + " s");
}

}  // namespace

std::span<const ThreatFile> threat_files() {
  static constexpr std::array<ThreatFile, 3> kFiles{
      {{"default", kThreatFiles[0]}, {"balls", kThreatFiles[1]}, {"kinds", kThreatFiles[2]}}};
  return kFiles;
}

ScenarioDistribution parse_threats(std::string_view text, const std::string& path) {
  const toml::table table = database::parse_toml(text, path);
  const TomlReader whole(table, path, "the file");
  whole.expect_keys({"kind"});
  const toml::array* kinds = table["kind"].as_array();
  if (kinds == nullptr || kinds->empty() || !kinds->is_array_of_tables())
    whole.fail("kind", "needs at least one [[kind]]");
  if (kinds->size() > features::kMaxThreatKinds)
    whole.fail("kind", "has more than " + std::to_string(features::kMaxThreatKinds) + " kinds");
  std::vector<ThreatKind> read;
  double total_weight = 0;
  for (const toml::node& node : *kinds) {
    const TomlReader reader(*node.as_table(), path, "[[kind]]");
    ThreatKind kind = kind_of(reader);
    if (std::ranges::find(read, kind.name, &ThreatKind::name) != read.end())
      reader.fail("name", "has the name of another, " + kind.name);
    total_weight += kind.weight;
    read.push_back(std::move(kind));
    require_grid(reader, read);
  }
  if (total_weight <= 0) whole.fail("kind", "has only kinds of weight 0; give one more");
  return {std::move(read)};
}

ScenarioDistribution find_threats(const std::string& name_or_file) {
  if (database::names_toml_file(name_or_file))
    return parse_threats(database::read_toml_text(name_or_file), name_or_file);
  std::string names;
  for (const ThreatFile& file : threat_files()) {
    if (file.name == name_or_file) return parse_threats(file.text, std::string(file.name));
    names += (names.empty() ? "" : ", ") + std::string(file.name);
  }
  throw Error("", "there are no threats named " + name_or_file + "; shipped are: " + names +
                      "; a name that ends in .toml is that of a file");
}

}  // namespace flinch::train
