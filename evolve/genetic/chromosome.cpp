// SPDX-License-Identifier: MIT
#include "evolve/genetic/chromosome.h"

#include <algorithm>
#include <numbers>

namespace flinch::evolve {
namespace {

constexpr std::array<Mutation, 3> kSchemeA{{{10, 200}, {2, 1000}, {1, kMaxGene}}};
constexpr std::array<Mutation, 1> kSchemeB{{{10, kMaxGene}}};
constexpr std::array<Mutation, 2> kSchemeC{{{5, 1000}, {5, kMaxGene}}};
constexpr std::array<Mutation, 3> kSchemeD{{{20, 200}, {2, 1000}, {1, kMaxGene}}};

/// Returns the gene that `value`, less than one range beyond either end, stands for.
Gene kept_in_range(std::int64_t value, GeneEnds ends) {
  constexpr std::int64_t kCount = std::int64_t{kMaxGene} + 1;
  if (value >= 0 && value < kCount) return static_cast<Gene>(value);
  if (ends == GeneEnds::wrap) return static_cast<Gene>((value + kCount) % kCount);
  // About -1/2 and i_max + 1/2, so that both ends are as likely as any other gene.
  return static_cast<Gene>(value < 0 ? -1 - value : 2 * kCount - 1 - value);
}

}  // namespace

double value_of(Gene gene, const GeneRange& range) {
  return range.min + (range.max - range.min) * (static_cast<double>(gene) / kMaxGene);
}

std::string_view name_of(GeneMap map) {
  return map == GeneMap::limits ? "limits" : "full_turn";
}

double angle_of(Gene gene, const GeneRange& limits, GeneMap map) {
  if (map == GeneMap::limits) return value_of(gene, limits);
  constexpr GeneRange kTurn{-std::numbers::pi, std::numbers::pi};
  return std::clamp(value_of(gene, kTurn), limits.min, limits.max);
}

GeneEnds ends_of(GeneMap map) {
  return map == GeneMap::limits ? GeneEnds::reflect : GeneEnds::wrap;
}

void mutate(Chromosome& chromosome, const Mutation& mutation, GeneEnds ends,
            features::Random& random) {
  for (std::size_t i = 0; i < mutation.genes; ++i) {
    Gene& gene = chromosome[random.index(chromosome.size())];
    const auto amount = static_cast<std::int64_t>(random.index(mutation.distance));
    const bool increases = random.index(2) == 1;
    gene = kept_in_range(std::int64_t{gene} + (increases ? amount : -amount), ends);
  }
}

std::string_view name_of(MutationScheme scheme) {
  constexpr std::array<std::string_view, 4> kNames{"A", "B", "C", "D"};
  return kNames[static_cast<std::size_t>(scheme)];
}

std::span<const Mutation> mutations_of(MutationScheme scheme) {
  switch (scheme) {
    case MutationScheme::a:
      return kSchemeA;
    case MutationScheme::b:
      return kSchemeB;
    case MutationScheme::c:
      return kSchemeC;
    case MutationScheme::d:
      break;
  }
  return kSchemeD;
}

Chromosome crossed(const Chromosome& head, const Chromosome& tail, std::size_t split) {
  const auto at = static_cast<std::ptrdiff_t>(split);
  Chromosome child(head.begin(), head.begin() + at);
  child.insert(child.end(), tail.begin() + at, tail.end());
  return child;
}

}  // namespace flinch::evolve
