// SPDX-License-Identifier: MIT
#include "database/import/manifest.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "database/files/toml_reader.h"
#include "database/import/role_overrides.h"
#include "database/library/library_bounds.h"
#include "motion/error.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

std::string in_quotes(const std::string& text) {
  return "\"" + text + "\"";
}

// Returns an enumerator by its name; the error lists the names.
template <class Enum, class Find>
Enum named(const TomlReader& reader, std::string_view key, Find find,
           std::initializer_list<std::string_view> known) {
  const std::string text = reader.needed_text(key);
  if (const std::optional<Enum> found = find(text)) return *found;
  std::string names;
  for (std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
  reader.fail(
      key, "has an unknown " + std::string(key) + " " + in_quotes(text) + "; known are: " + names);
}

double positive(const TomlReader& reader, std::string_view key) {
  const double value = reader.needed_number(key);
  if (value <= 0) reader.fail(key, "needs " + std::string(key) + " above 0");
  return value;
}

double within(const TomlReader& reader, std::string_view key, double min, double max) {
  const double value = reader.needed_number(key);
  if (value < min || value > max) {
    char range[64];
    std::snprintf(range, sizeof range, " from %g to %g", min, max);
    reader.fail(key, "needs " + std::string(key) + range);
  }
  return value;
}

double degrees_within_half_turn(const TomlReader& reader, std::string_view key) {
  const double degrees = reader.needed_number(key);
  if (std::abs(degrees) > 180) {
    reader.fail(key, "needs " + std::string(key) + " from -180 to 180 degrees");
  }
  return degrees;
}

// Rounds to the nearest of the eight directions, in (-pi, pi].
float direction(const TomlReader& reader) {
  double degrees = 45 * std::round(degrees_within_half_turn(reader, "direction") / 45);
  if (degrees <= -180) degrees = 180;
  return static_cast<float>(motion::radians(degrees));
}

void check_within(const TomlReader& reader, std::string_view key, double time_s,
                  const ManifestEntry& entry) {
  const bool early = time_s < entry.start_s.value_or(0);
  if (early || (entry.end_s && time_s > *entry.end_s)) {
    reader.fail(key, "has its " + std::string(key) + " outside start to end");
  }
}

std::optional<motion::Annotation> read_annotation(const TomlReader& reader,
                                                  const ManifestEntry& entry) {
  constexpr std::array<std::string_view, 5> kKeys{"target", "direction", "degree", "onset", "peak"};
  const auto has = [&](std::string_view key) { return reader.has(key); };
  if (std::none_of(kKeys.begin(), kKeys.end(), has)) return std::nullopt;
  const auto missing = std::find_if_not(kKeys.begin(), kKeys.end(), has);
  if (missing != kKeys.end()) {
    reader.fail(*std::find_if(kKeys.begin(), kKeys.end(), has),
                "is annotated but has no " + std::string(*missing) +
                    "; give target, direction, degree, onset and peak, or none of them");
  }
  motion::Annotation annotation;
  annotation.target = named<motion::Target>(reader, "target", motion::target_named,
                                            {"head", "trunk", "pelvis", "legs"});
  annotation.degree =
      named<motion::Degree>(reader, "degree", motion::degree_named, {"mild", "exaggerated"});
  annotation.direction = direction(reader);
  const double onset = reader.needed_number("onset");
  const double peak = reader.needed_number("peak");
  check_within(reader, "onset", onset, entry);
  check_within(reader, "peak", peak, entry);
  if (onset >= peak) reader.fail("peak", "needs its peak after its onset");
  annotation.onset_s = static_cast<float>(onset);
  annotation.peak_s = static_cast<float>(peak);
  return annotation;
}

ManifestEntry read_entry(const TomlReader& reader, motion::Purpose purpose) {
  ManifestEntry entry;
  entry.purpose = purpose;
  entry.where = reader.where();
  entry.name = reader.needed_text("name");
  entry.file = reader.needed_text("file");
  entry.start_s = reader.number("start");
  entry.end_s = reader.number("end");
  if (entry.start_s && *entry.start_s < 0) reader.fail("start", "starts before its file");
  if (entry.end_s && *entry.end_s <= entry.start_s.value_or(0)) {
    reader.fail("end", "must end after it starts");
  }
  if (reader.has("heading")) {
    entry.heading = motion::radians(degrees_within_half_turn(reader, "heading"));
  }
  return entry;
}

ManifestEntry read_idle(const TomlReader& reader) {
  reader.expect_keys({"name", "file", "start", "end", "heading"});
  ManifestEntry entry = read_entry(reader, motion::Purpose::idle);
  entry.kind = "idle";
  return entry;
}

ManifestEntry read_clip(const TomlReader& reader) {
  reader.expect_keys({"name", "file", "start", "end", "heading", "kind", "target", "direction",
                      "degree", "onset", "peak"});
  ManifestEntry entry = read_entry(reader, motion::Purpose::anticipation);
  entry.kind = reader.text("kind").value_or("");
  entry.annotation = read_annotation(reader, entry);
  return entry;
}

motion::Role read_push_place(const TomlReader& reader) {
  return named<motion::Role>(reader, "place", motion::push_place_named,
                             {"chest", "neck", "head", "left_shoulder", "right_shoulder"});
}

// Strength is a word for people: how strong the push is, the motion says.
ManifestEntry read_push(const TomlReader& reader) {
  reader.expect_keys(
      {"name", "file", "start", "end", "heading", "contact", "direction", "strength", "place"});
  ManifestEntry entry = read_entry(reader, motion::Purpose::push);
  entry.kind = "push";
  PushEntry& push = entry.push.emplace();
  push.contact_s = reader.number("contact");
  if (push.contact_s) check_within(reader, "contact", *push.contact_s, entry);
  if (reader.has("direction")) {
    push.direction =
        static_cast<float>(motion::radians(degrees_within_half_turn(reader, "direction")));
  }
  if (reader.has("place")) push.place = read_push_place(reader);
  if (const std::optional<std::string> strength = reader.text("strength")) {
    if (*strength != "mild" && *strength != "strong") {
      reader.fail("strength",
                  "has an unknown strength " + in_quotes(*strength) + "; known are: mild, strong");
    }
  }
  return entry;
}

ManifestEntry read_stance(const TomlReader& reader) {
  reader.expect_keys({"name", "file", "start", "end", "heading", "kind"});
  ManifestEntry entry = read_entry(reader, motion::Purpose::stance);
  entry.kind = reader.text("kind").value_or("");
  return entry;
}

template <class Read>
void read_entries(const toml::table& file, const std::string& key, Read read, Manifest& manifest) {
  const toml::node* node = file.get(key);
  if (node == nullptr) return;
  const TomlReader whole(file, manifest.path, "the manifest");
  const toml::array* tables = node->as_array();
  if (tables == nullptr) whole.fail(key, "needs [[" + key + "]], in double brackets");
  for (const toml::node& element : *tables) {
    const toml::table* table = element.as_table();
    if (table == nullptr) whole.fail(key, "needs tables in " + key);
    manifest.entries.push_back(read(TomlReader(*table, manifest.path, "[[" + key + "]]")));
  }
}

void check_names(const Manifest& manifest) {
  std::map<std::string, std::string> seen;
  const auto add = [&](const std::string& name, const ManifestEntry& entry) {
    const auto [at, is_new] = seen.emplace(name, entry.where);
    if (!is_new) {
      throw Error(entry.where, "the name " + in_quotes(name) + " is already taken at " +
                                   at->second + "; every clip needs its own");
    }
  };
  for (const ManifestEntry& entry : manifest.entries) add(entry.name, entry);
  for (const ManifestEntry& entry : manifest.entries) {
    if (is_mirrored(entry)) add(entry.name + "_mirrored", entry);
  }
}

const toml::table* table_in(const toml::table& file, const std::string& key,
                            const Manifest& manifest) {
  const toml::node* node = file.get(key);
  if (node == nullptr) return nullptr;
  if (node->as_table() == nullptr) {
    TomlReader(file, manifest.path, "the manifest").fail(key, "needs [" + key + "] as a table");
  }
  return node->as_table();
}

void read_library(const toml::table& table, Manifest& manifest) {
  const TomlReader reader(table, manifest.path, "[library]");
  reader.expect_keys({"name", "rate", "skeleton"});
  manifest.name = reader.text("name").value_or("");
  manifest.skeleton = reader.text("skeleton").value_or("");
  manifest.skeleton_where = reader.where("skeleton");
  if (!reader.has("rate")) return;
  manifest.rate_hz =
      static_cast<float>(within(reader, "rate", kMinImportRate_hz, double{kMaxRate_hz}));
}

void read_character(const toml::table& table, Manifest& manifest) {
  const TomlReader reader(table, manifest.path, "[character]");
  reader.expect_keys({"mass_kg", "height_m", "sex"});
  CharacterOptions& character = manifest.character;
  if (reader.has("mass_kg")) character.mass_kg = static_cast<float>(positive(reader, "mass_kg"));
  if (reader.has("height_m")) character.height_m = static_cast<float>(positive(reader, "height_m"));
  if (reader.has("sex")) {
    character.sex = named<motion::Sex>(reader, "sex", motion::sex_named, {"female", "male"});
  }
}

FrameOptions read_frames(const TomlReader& reader) {
  FrameOptions frames;
  if (reader.has("rate_of_file")) {
    frames.rate_hz = within(reader, "rate_of_file", kMinSourceRate_hz, kMaxSourceRate_hz);
  }
  if (reader.has("frames")) {
    frames.range = frame_range_from(reader.needed_text("frames"));
    if (!frames.range) {
      reader.fail("frames", "needs frames = \"FIRST:LAST\", such as \"2:90\" or \"2:\"");
    }
  }
  frames.skip_first = reader.flag("skip_first");
  return frames;
}

ManifestSource read_source(const std::string& path, const TomlReader& reader) {
  reader.expect_keys({"units", "up", "rest", "rate_of_file", "frames", "skip_first", "roles"});
  ManifestSource source;
  source.path = path;
  source.where = reader.where();
  while (source.path.ends_with('/')) source.path.pop_back();
  if (reader.has("units")) {
    source.options.unit =
        named<LengthUnit>(reader, "units", length_unit_named, {"m", "cm", "mm", "inch", "cmu"});
  }
  if (reader.has("up")) {
    source.options.up =
        named<UpAxis>(reader, "up", up_axis_named, {"x", "y", "z", "-x", "-y", "-z"});
  }
  if (reader.has("rest")) source.options.rest = reader.needed_text("rest");
  source.options.frames = read_frames(reader);
  if (reader.has("roles")) {
    const toml::table* roles = reader.table()["roles"].as_table();
    if (roles == nullptr) reader.fail("roles", "needs a table of lines: role = \"joint\"");
    source.options.roles =
        role_overrides(TomlReader(*roles, reader.path(), "[source." + in_quotes(path) + ".roles]"));
  }
  return source;
}

void read_sources(const toml::table& table, Manifest& manifest) {
  const TomlReader whole(table, manifest.path, "[source]");
  for (const auto& [key, value] : table) {
    const std::string path(key.str());
    if (value.as_table() == nullptr) {
      whole.fail(path, "needs tables such as [source.\"folder or file\"]");
    }
    manifest.sources.push_back(read_source(
        path, TomlReader(*value.as_table(), manifest.path, "[source." + in_quotes(path) + "]")));
  }
}

}  // namespace

bool is_mirrored(const ManifestEntry& entry) {
  return entry.annotation || entry.purpose == motion::Purpose::push;
}

Manifest read_manifest(const std::string& path) {
  const toml::table file = read_toml(path);
  Manifest manifest;
  manifest.path = path;
  const TomlReader whole(file, path, "the manifest");
  whole.expect_keys({"library", "character", "source", "idle", "clip", "push", "stance"});
  if (const toml::table* library = table_in(file, "library", manifest)) {
    read_library(*library, manifest);
  }
  if (const toml::table* character = table_in(file, "character", manifest)) {
    read_character(*character, manifest);
  }
  if (const toml::table* sources = table_in(file, "source", manifest)) {
    read_sources(*sources, manifest);
  }
  read_entries(file, "idle", read_idle, manifest);
  read_entries(file, "clip", read_clip, manifest);
  read_entries(file, "push", read_push, manifest);
  read_entries(file, "stance", read_stance, manifest);
  if (manifest.entries.empty() || manifest.entries.front().purpose != motion::Purpose::idle) {
    throw Error(path,
                "has no [[idle]]: give the motion that responses start from, with its name "
                "and file");
  }
  check_names(manifest);
  if (manifest.skeleton.empty()) {
    manifest.skeleton = manifest.entries.front().file;
    manifest.skeleton_where = manifest.entries.front().where;
  }
  return manifest;
}

bool covers(const ManifestSource& source, const std::string& file) {
  return source.path == file || file.starts_with(source.path + "/");
}

SourceOptions options_for(const Manifest& manifest, const std::string& file) {
  std::vector<const ManifestSource*> matching;
  for (const ManifestSource& source : manifest.sources) {
    if (covers(source, file)) matching.push_back(&source);
  }
  std::stable_sort(matching.begin(), matching.end(),
                   [](const ManifestSource* one, const ManifestSource* other) {
                     return one->path.size() < other->path.size();
                   });
  SourceOptions options;
  for (const ManifestSource* source : matching) options = merged(options, source->options);
  return options;
}

}  // namespace flinch::database
