// SPDX-License-Identifier: MIT
#include "evolve/pain/pain.h"

#include <algorithm>

#include "database/files/toml_reader.h"

namespace flinch::evolve {
namespace {

constexpr double kMaxMultiplier = 1000;

constexpr PainMap kThesis{{15, 14, 10, 5, 5, 2, 4, 4, 2, 3, 3, 1, 1, 2, 3, 1}};

std::string all_names() {
  std::string names;
  for (const PainRegion region : kPainRegions)
    names += (names.empty() ? "" : ", ") + std::string(name_of(region));
  return names;
}

}  // namespace

const PainMap& thesis_pain() {
  return kThesis;
}

PainMap read_pain(const std::string& path) {
  const toml::table file = database::read_toml(path);
  const database::TomlReader reader(file, path, "a pain map");
  reader.expect_keys({"multipliers"});
  const toml::table* table = file["multipliers"].as_table();
  if (!table) reader.fail("multipliers", "needs a table [multipliers]");
  const database::TomlReader multipliers(*table, path, "[multipliers]");
  PainMap map = kThesis;
  for (const auto& [key, value] : *table) {
    const auto region = pain_region_named(key.str());
    if (!region)
      multipliers.fail(key.str(), "names a region '" + std::string(key.str()) +
                                      "' that does not exist; the regions are: " + all_names());
    const double multiplier = multipliers.needed_number(key.str());
    if (!(multiplier >= 0 && multiplier <= kMaxMultiplier))
      multipliers.fail(key.str(), "needs a number from 0 to 1000 for " + std::string(key.str()));
    map.multiplier[*region] = multiplier;
  }
  if (std::ranges::all_of(map.multiplier, [](double value) { return value == 0; }))
    multipliers.fail({}, "has only values of 0, so nothing would hurt; give one above 0");
  return map;
}

double pain_of(const PainMap& map, const motion::BodyModel& bodies,
               std::span<const sim::PlacedImpulse> impulses) {
  double sum = 0;
  for (const sim::PlacedImpulse& impulse : impulses) {
    const PainRegion region = pain_region_at(bodies, impulse.body, impulse.point.cast<float>());
    sum += map.multiplier[region] * impulse.impulse_ns;
  }
  return sum;
}

}  // namespace flinch::evolve
