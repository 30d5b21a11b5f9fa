// SPDX-License-Identifier: MIT
// The reader of unfinished evolutions, each of four poses with three genes each.
#include <cmath>

#include "evolve/run/evolution_file.h"
#include "motion/error.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/memory_file.h"

namespace {

using flinch::tests::require;

void require_sound(const std::vector<flinch::evolve::GenerationRecord>& history) {
  for (const flinch::evolve::GenerationRecord& record : history)
    require(std::isfinite(record.best_fitness) && std::isfinite(record.mean_fitness) &&
                record.best.size() == 3,
            "a generation is recorded whole");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const flinch::tests::MemoryFile file(flinch::tests::text_of(data, size));
  try {
    const auto series = flinch::evolve::read_evolution(file.path(), "key", 4, 3);
    require(series.has_value(), "a file is read or refused");
    const auto& chromosomes = series->current.chromosomes;
    require(chromosomes.size() == 4 || chromosomes.empty(), "the population is whole");
    for (const flinch::evolve::Chromosome& chromosome : chromosomes)
      require(chromosome.size() == 3, "a pose has all genes");
    require_sound(series->current.history);
    for (const auto& run : series->finished) require_sound(run.history);
  } catch (const flinch::Error&) {
  }
  return 0;
}
