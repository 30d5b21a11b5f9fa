// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "features/random.h"

namespace flinch::evolve {

/// One degree of freedom of a solution, as an unsigned integer (Rose 2006, section 4.3.1). With 16
/// bits a mutation by 200 is 1.1 degrees of a full turn.
using Gene = std::uint16_t;
/// The largest gene, i_max.
inline constexpr Gene kMaxGene = std::numeric_limits<Gene>::max();
/// The genes of one solution.
using Chromosome = std::vector<Gene>;

/// What a gene stands for: the values from `min`, of gene 0, to `max`, of kMaxGene.
struct GeneRange {
  double min = 0;
  double max = 1;
};
/// Returns min + (max - min) gene / i_max. With the range -pi to pi this is equation 4.5.
double value_of(Gene gene, const GeneRange& range);

/// What becomes of a gene that a mutation takes beyond its range. A gene that is uniformly
/// distributed stays so either way.
enum class GeneEnds : std::uint8_t {
  reflect,  ///< it turns back at the end: for ranges with two different ends
  wrap,     ///< it goes on at the other end, as unsigned integers do: for whole turns
};

/// How the genes of a pose stand for the angles of joints.
enum class GeneMap : std::uint8_t {
  limits,     ///< from the joint's least angle to its largest: each gene means something
  full_turn,  ///< from -pi to pi by equation 4.5, held at the limits as the thesis' servos hold the
              ///< angles that are wanted of them (equation 3.15)
};
inline constexpr std::array kGeneMaps{GeneMap::limits, GeneMap::full_turn};
/// The name in options: "limits" or "full_turn".
std::string_view name_of(GeneMap map);
/// Returns the angle that a gene stands for, radians, between the limits of its joint.
double angle_of(Gene gene, const GeneRange& limits, GeneMap map);
/// Returns how genes end that are mapped so.
GeneEnds ends_of(GeneMap map);

/// MUTATE(n, d) of section 4.3.2: `genes` times a random gene, which may be the same again, is
/// increased or decreased by an amount uniform in [0, distance).
struct Mutation {
  std::size_t genes = 0;
  std::uint32_t distance = 1;  ///< from 1 to kMaxGene
};
/// Does one mutation.
void mutate(Chromosome& chromosome, const Mutation& mutation, GeneEnds ends,
            features::Random& random);

/// The mutations that a new chromosome goes through in turn (figure 5.1).
enum class MutationScheme : std::uint8_t { a, b, c, d };
/// All schemes.
inline constexpr std::array kMutationSchemes{MutationScheme::a, MutationScheme::b,
                                             MutationScheme::c, MutationScheme::d};
/// The name in options: "A", "B", "C" or "D".
std::string_view name_of(MutationScheme scheme);
std::span<const Mutation> mutations_of(MutationScheme scheme);

/// One-point crossover between genes: the first `split` genes of `head`, then the rest of `tail`,
/// which is as long.
Chromosome crossed(const Chromosome& head, const Chromosome& tail, std::size_t split);

}  // namespace flinch::evolve
