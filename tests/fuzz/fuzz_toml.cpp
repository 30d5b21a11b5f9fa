// SPDX-License-Identifier: MIT
// The readers of TOML files: manifests, roles, characters, kinds of threats, tables of
// vulnerability and maps of pain. One input is read as each of them.
#include <algorithm>
#include <cmath>

#include "database/author/character_toml.h"
#include "database/import/manifest.h"
#include "database/import/role_map.h"
#include "evolve/pain/pain.h"
#include "motion/error.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/memory_file.h"
#include "train/objective/vulnerability.h"
#include "train/scenario/threat_file.h"

namespace {

template <class Read>
void try_to(Read read) {
  try {
    read();
  } catch (const flinch::Error&) {
  }
}

void require_sound(const flinch::train::ThreatKind& kind) {
  using flinch::tests::require;
  require(!kind.name.empty() && kind.weight >= 0 && kind.mass_kg.min > 0, "a threat is a thing");
  require(!kind.azimuth.empty() && kind.azimuth.size() <= 16, "a threat comes from somewhere");
  for (const flinch::train::ValueRange& range :
       {kind.radius_m, kind.mass_kg, kind.speed_mps, kind.elevation, kind.time_to_impact_s})
    require(std::isfinite(range.max - range.min) && range.min <= range.max, "ranges ascend");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using flinch::tests::require;
  const flinch::tests::MemoryFile file(flinch::tests::text_of(data, size));
  try_to([&] {
    const flinch::database::Manifest manifest = flinch::database::read_manifest(file.path());
    require(!manifest.entries.empty(), "a manifest has entries");
    for (const flinch::database::ManifestEntry& entry : manifest.entries) {
      require(!entry.name.empty() && !entry.file.empty(), "entries have a name and a file");
      static_cast<void>(options_for(manifest, entry.file));
    }
  });
  try_to([&] { static_cast<void>(flinch::database::read_role_overrides(file.path())); });
  try_to([&] {
    const flinch::motion::Physique character = flinch::database::read_character(file.path());
    require(character.mass_kg > 0 && character.mass_kg < 1000, "a character has a person's mass");
    for (const Eigen::Vector3f& offset : character.skeleton.offset)
      require(offset.allFinite() && offset.norm() < 3, "a character has a person's bones");
  });
  try_to([&] {
    const auto text = flinch::tests::text_of(data, size);
    const auto threats = flinch::train::parse_threats(text, "input.toml");
    require(!threats.kinds.empty(), "there are threats");
    for (const flinch::train::ThreatKind& kind : threats.kinds) require_sound(kind);
  });
  try_to([&] {
    const auto text = flinch::tests::text_of(data, size);
    for (const double value : flinch::train::parse_vulnerability(text, "input.toml").vulnerability)
      require(value >= 0 && value <= 1, "a vulnerability is a share");
  });
  try_to([&] {
    for (const double value : flinch::evolve::read_pain(file.path()).multiplier)
      require(value >= 0 && value <= 1000, "pain is bounded");
  });
  return 0;
}
