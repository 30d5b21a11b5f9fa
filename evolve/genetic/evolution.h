// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "evolve/genetic/chromosome.h"

namespace flinch::evolve {

/// How to evolve. The defaults are those that Rose (2006, chapter 5) settles on.
struct GeneticOptions {
  std::size_t population = 400;  ///< chromosomes in a generation: even, at least `tournament`
  std::size_t tournament = 4;    ///< chromosomes in a tournament: a multiple of 4
  MutationScheme mutation = MutationScheme::a;
  GeneEnds ends = GeneEnds::reflect;
  std::size_t max_generations = 60;
  /// The second end condition: for this many generations the best pose has improved by less than
  /// this share of its fitness, on a test that is the same for all generations.
  std::size_t window = 10;
  double min_improvement = 0.01;
  std::uint64_t seed = 1;
};

/// Throws Error, with what is allowed, for options outside these bounds.
void check_options(const GeneticOptions& options);

/// A generation that has been evaluated.
struct GenerationRecord {
  double best_fitness = 0;  ///< the least
  double mean_fitness = 0;
  Chromosome best;  ///< the first that has the best fitness
  /// The fitness of `best` on a test that is the same for all generations.
  double check_fitness = 0;
};

/// A run between two generations: all that is needed to go on with it.
struct Evolution {
  std::vector<GenerationRecord> history;  ///< of the generations so far
  std::vector<Chromosome> chromosomes;    ///< of the next generation
};

/// Several runs, one after the other.
struct EvolutionSeries {
  struct Finished {
    std::optional<Chromosome> kept;  ///< what came of it
    std::vector<GenerationRecord> history;
  };
  std::vector<Finished> finished;
  Evolution current;
};

/// Returns the fitness of each chromosome of a generation; less is better. Chromosomes that are
/// kept are evaluated again in each generation, so that it may be tested differently from the last.
using EvaluateGeneration =
    std::function<std::vector<double>(std::size_t generation, std::span<const Chromosome>)>;

/// Returns the fitness of one chromosome on a test that is the same for all generations.
using CheckFitness = std::function<double(const Chromosome&)>;

/// Returns a run before its first generation, whose genes are uniformly random.
Evolution begin_evolution(const GeneticOptions& options, std::size_t gene_count);

/// Evaluates the next generation, records it and makes the one after it. The same options and
/// fitness give the same bits, also if the run is continued from a copy.
void advance(const GeneticOptions& options, const EvaluateGeneration& evaluate,
             const CheckFitness& check, Evolution& evolution);

/// Whether either end condition is met.
bool has_ended(const GeneticOptions& options, const Evolution& evolution);
/// Whether the second is met. The thesis asks that the mean fitness of a generation stands still
/// (section 4.3.4), and finds that it often ends a run too early. Where each generation meets other
/// balls, the mean and the best move with the balls and never stand still. So the best of each
/// generation is tested once more, on balls that are the same for all generations and that none
/// evolves on: the run ends when that has stopped to improve.
bool has_converged(const GeneticOptions& options, std::span<const GenerationRecord> history);

/// Tournament selection with elitism (section 4.3.3): the shuffled generation is cut into
/// tournaments. The better half of each goes on unchanged, and mutated crossings of its pairs take
/// the place of the other half. What is left over forms a smaller, last tournament. Of equal
/// fitness, the chromosome that comes first wins.
std::vector<Chromosome> next_generation(const GeneticOptions& options, std::size_t generation,
                                        std::span<const Chromosome> chromosomes,
                                        std::span<const double> fitness);

/// Returns chromosomes among which to look for the best of a run, at most `count`, each once: the
/// best of the last `window` generations, the last first, and as many of the next generation as
/// there is room for. Among these are the winners of the last.
std::vector<Chromosome> finalists(const Evolution& evolution, std::size_t window,
                                  std::size_t count);

}  // namespace flinch::evolve
