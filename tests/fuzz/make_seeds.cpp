// SPDX-License-Identifier: MIT
// make_fuzz_seeds FOLDER: writes seeds for the fuzz targets of binary files, by our own writers:
// FOLDER/TARGET/NAME, and the selector that sequences of calls use as FOLDER/c_calls.flinch. Seeds
// of sealed files are without their header, which the targets make.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "database/author/authored_library.h"
#include "database/files/pose_packer.h"
#include "motion/default_character.h"
#include "motion/mirror.h"
#include "tests/runtime/made_up_selector.h"
#include "tests/scenes/file_damage.h"
#include "train/simulate/simulate.h"
#include "train/store/store.h"

namespace flinch::tests {
namespace {

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

void write_seeds(const std::filesystem::path& folder) {
  const database::ClipLibrary library = made_up_library(3, 90);
  write(folder / "library" / "three_clips", content_of(library_bytes(library)));
  database::ClipLibrary packed = library;
  snap(packed);
  packed.clips.push_back(motion::mirrored(packed.clips.back()));
  snap(packed);
  write(folder / "library" / "packed", content_of(library_bytes(packed)));
  const std::pair<const char*, ModelKind> kinds[] = {{"svm", ModelKind::svm},
                                                     {"knn", ModelKind::knn},
                                                     {"knn_cost", ModelKind::knn_cost},
                                                     {"network", ModelKind::network},
                                                     {"pairwise", ModelKind::pairwise}};
  for (const auto& [name, kind] : kinds) {
    MadeUpSelector made = made_up_selector(library, 20, kind);
    made.selector.kinds.push_back({.name = "stone"});
    write(folder / "selector" / name, content_of(made.file()));
  }

  const train::SimulationSetup setup(library, {});
  train::RehearsalCache rehearsals(std::uint64_t{1} << 26U);
  train::Batch batch;
  constexpr std::uint64_t kScenarios = 3;
  if (!simulate_batch(setup, rehearsals, {0, kScenarios}, {}, batch))
    throw std::runtime_error("the simulation was interrupted");
  const std::filesystem::path store = folder / "store" / "three_scenarios";
  std::filesystem::create_directories(store.parent_path());
  std::filesystem::remove(store);
  train::StoreWriter writer(store.string(), make_store_header(setup), {0, kScenarios});
  writer.append(batch.observations);
  writer.finish();

  std::mt19937 random(1);
  std::string words(4096, '\0');
  for (char& byte : words) byte = static_cast<char>(random());
  write(folder / "c_calls" / "random", words);
  const database::ClipLibrary authored = database::authored_library(motion::default_character());
  write(folder / "c_calls.flinch",
        with_response_costs(made_up_selector(authored, 60, ModelKind::knn)).file());
}

}  // namespace
}  // namespace flinch::tests

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("Usage: make_fuzz_seeds FOLDER\n", stderr);
    return 2;
  }
  try {
    flinch::tests::write_seeds(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_fuzz_seeds: %s\n", error.what());
    return 1;
  }
  return 0;
}
