// SPDX-License-Identifier: MIT
// The readers of TOML files: manifests, roles and characters. One input is read as each of them.
#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>

#include "database/author/character_toml.h"
#include "database/import/manifest.h"
#include "database/import/role_map.h"
#include "motion/error.h"
#include "tests/fuzz/fuzz.h"

namespace {

/// A file in memory alone.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("input.toml", 0)) {
    if (descriptor_ < 0 ||
        write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      throw std::runtime_error("cannot make a file in memory");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

template <class Read>
void try_to(Read read) {
  try {
    read();
  } catch (const flinch::Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using flinch::tests::require;
  const MemoryFile file(flinch::tests::text_of(data, size));
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
  return 0;
}
