// SPDX-License-Identifier: MIT
#include "evolve/genetic/evolution.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "motion/error.h"

namespace flinch::evolve {
namespace {

features::Random random_of(const GeneticOptions& options, std::size_t generation) {
  return {options.seed, features::RandomStream::evolution, generation};
}

/// Appends the mutated children of two parents, at most `count`.
void add_children(const GeneticOptions& options, const Chromosome& first, const Chromosome& second,
                  std::size_t count, features::Random& random,
                  std::vector<Chromosome>& generation) {
  const std::size_t size = first.size();
  const std::size_t split = size > 1 ? 1 + random.index(size - 1) : 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(count, 2); ++k) {
    Chromosome child = k == 0 ? crossed(first, second, split) : crossed(second, first, split);
    for (const Mutation& mutation : mutations_of(options.mutation))
      mutate(child, mutation, options.ends, random);
    generation.push_back(std::move(child));
  }
}

double least_check(std::span<const GenerationRecord> history) {
  return std::ranges::min(history, {}, &GenerationRecord::check_fitness).check_fitness;
}

}  // namespace

void check_options(const GeneticOptions& options) {
  if (options.tournament < 4 || options.tournament % 4 != 0)
    throw Error("", "a tournament of " + std::to_string(options.tournament) +
                        "; it must be a multiple of 4, since pairs of its better half are crossed");
  if (options.population < options.tournament || options.population % 2 != 0)
    throw Error("", "a population of " + std::to_string(options.population) +
                        "; it must be even and at least as large as a tournament, " +
                        std::to_string(options.tournament));
  if (options.max_generations < 1) throw Error("", "there must be at least 1 generation");
}

Evolution begin_evolution(const GeneticOptions& options, std::size_t gene_count) {
  check_options(options);
  features::Random random = random_of(options, 0);
  Evolution evolution;
  evolution.chromosomes.assign(options.population, Chromosome(gene_count));
  for (Chromosome& chromosome : evolution.chromosomes) {
    for (Gene& gene : chromosome) gene = static_cast<Gene>(random.index(kMaxGene + 1));
  }
  return evolution;
}

std::vector<Chromosome> next_generation(const GeneticOptions& options, std::size_t generation,
                                        std::span<const Chromosome> chromosomes,
                                        std::span<const double> fitness) {
  features::Random random = random_of(options, generation);
  std::vector<int> order(chromosomes.size());
  std::iota(order.begin(), order.end(), 0);
  random.shuffle(order);
  std::vector<Chromosome> next;
  next.reserve(chromosomes.size());
  for (std::size_t begin = 0; begin < order.size(); begin += options.tournament) {
    const std::size_t size = std::min(options.tournament, order.size() - begin);
    const std::span<int> ranked = std::span(order).subspan(begin, size);
    std::ranges::sort(ranked, [&](int a, int b) {
      const double first = fitness[static_cast<std::size_t>(a)];
      const double second = fitness[static_cast<std::size_t>(b)];
      return first != second ? first < second : a < b;
    });
    const std::size_t kept = size / 2;
    const auto winner = [&](std::size_t rank) -> const Chromosome& {
      return chromosomes[static_cast<std::size_t>(ranked[rank % kept])];
    };
    for (std::size_t rank = 0; rank < kept; ++rank) next.push_back(winner(rank));
    for (std::size_t made = 0; made < size - kept; made += 2)
      add_children(options, winner(made), winner(made + 1), size - kept - made, random, next);
  }
  return next;
}

void advance(const GeneticOptions& options, const EvaluateGeneration& evaluate,
             const CheckFitness& check, Evolution& evolution) {
  const std::size_t generation = evolution.history.size();
  const std::vector<double> fitness = evaluate(generation, evolution.chromosomes);
  const auto best = std::ranges::min_element(fitness);
  GenerationRecord record;
  record.best_fitness = *best;
  record.mean_fitness =
      std::accumulate(fitness.begin(), fitness.end(), 0.0) / static_cast<double>(fitness.size());
  record.best = evolution.chromosomes[static_cast<std::size_t>(best - fitness.begin())];
  record.check_fitness = check(record.best);
  evolution.history.push_back(std::move(record));
  evolution.chromosomes = next_generation(options, generation + 1, evolution.chromosomes, fitness);
}

bool has_converged(const GeneticOptions& options, std::span<const GenerationRecord> history) {
  if (history.size() <= options.window) return false;
  const double before = least_check(history.first(history.size() - options.window));
  return before - least_check(history) < options.min_improvement * std::abs(before);
}

bool has_ended(const GeneticOptions& options, const Evolution& evolution) {
  return evolution.history.size() >= options.max_generations ||
         has_converged(options, evolution.history);
}

std::vector<Chromosome> finalists(const Evolution& evolution, std::size_t window,
                                  std::size_t count) {
  std::vector<Chromosome> chosen;
  const auto add = [&](const Chromosome& chromosome) {
    if (chosen.size() < count && std::ranges::find(chosen, chromosome) == chosen.end())
      chosen.push_back(chromosome);
  };
  const std::size_t recent = std::min(window, evolution.history.size());
  for (std::size_t k = 0; k < recent; ++k)
    add(evolution.history[evolution.history.size() - 1 - k].best);
  for (const Chromosome& chromosome : evolution.chromosomes) add(chromosome);
  return chosen;
}

}  // namespace flinch::evolve
