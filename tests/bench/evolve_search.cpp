// SPDX-License-Identifier: MIT
#include "tests/bench/evolve_search.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "evolve/trial/pose_trial.h"
#include "tests/bench/cma_es.h"
#include "tests/bench/measures.h"

namespace flinch::evolve {
namespace {

/// Fitness on the balls of one draw. Poses that were tested before are not tested again.
class FixedFitness {
 public:
  FixedFitness(const PoseTrial& trial, int threads) : trial_(trial), threads_(threads) {}

  std::vector<double> of(std::span<const Chromosome> poses) {
    std::vector<Chromosome> fresh;
    for (const Chromosome& pose : poses)
      if (!known_.contains(pose)) fresh.push_back(pose);
    const std::vector<PoseScore> scores = *trial_.test(fresh, 0, threads_);
    for (std::size_t i = 0; i < fresh.size(); ++i) known_[fresh[i]] = scores[i].fitness();
    std::vector<double> values;
    for (const Chromosome& pose : poses) values.push_back(known_.at(pose));
    return values;
  }

 private:
  const PoseTrial& trial_;
  int threads_;
  std::map<Chromosome, double> known_;
};

/// The best fitness after each generation.
struct Curve {
  std::size_t population = 0;
  std::vector<double> best;

  /// Evaluations until the best is at most `bound`; infinite if it never is.
  double evaluations_to(double bound) const {
    for (std::size_t k = 0; k < best.size(); ++k)
      if (best[k] <= bound) return static_cast<double>((k + 1) * population);
    return std::numeric_limits<double>::infinity();
  }
  void add(double fitness) {
    best.push_back(best.empty() ? fitness : std::min(best.back(), fitness));
  }
};

Curve run_genetic(const PoseTrial& trial, const GeneticOptions& options, std::size_t budget,
                  int threads) {
  FixedFitness fitness(trial, threads);
  const auto evaluate = [&](std::size_t, std::span<const Chromosome> poses) {
    return fitness.of(poses);
  };
  Curve curve{options.population, {}};
  Evolution evolution = begin_evolution(options, pose_genes().size());
  while (curve.best.size() * options.population < budget) {
    advance(
        options, evaluate, [](const Chromosome&) { return 0.0; }, evolution);
    curve.add(evolution.history.back().best_fitness);
  }
  return curve;
}

Curve run_cma_es(const PoseTrial& trial, int population, std::uint64_t seed, std::size_t budget,
                 int threads) {
  FixedFitness fitness(trial, threads);
  bench::CmaEs search(static_cast<int>(pose_genes().size()), population, seed);
  Curve curve{static_cast<std::size_t>(population), {}};
  while (curve.best.size() * curve.population < budget) {
    std::vector<Chromosome> poses;
    for (const Eigen::VectorXd& point : search.ask()) {
      Chromosome pose;
      for (const double x : point) pose.push_back(static_cast<Gene>(std::lround(x * kMaxGene)));
      poses.push_back(std::move(pose));
    }
    const std::vector<double> values = fitness.of(poses);
    search.tell(values);
    curve.add(*std::ranges::min_element(values));
  }
  return curve;
}

struct Row {
  std::string name;
  std::vector<Curve> curves;  ///< one per seed
};

/// The median and its 95 % interval by 2000 resamples.
std::array<double, 3> median_with_interval(const std::vector<double>& values) {
  features::Random random(1, features::RandomStream::bootstrap, 0);
  std::vector<double> medians;
  for (int k = 0; k < 2000; ++k) {
    std::vector<double> drawn;
    for (std::size_t i = 0; i < values.size(); ++i)
      drawn.push_back(values[random.index(values.size())]);
    medians.push_back(bench::quantile(drawn, 0.5));
  }
  return {bench::quantile(values, 0.5), bench::quantile(medians, 0.025),
          bench::quantile(medians, 0.975)};
}

void print_rows(const std::vector<Row>& rows, std::size_t budget) {
  double best = std::numeric_limits<double>::infinity();
  for (const Row& row : rows)
    for (const Curve& curve : row.curves) best = std::min(best, curve.best.back());
  std::printf("best fitness of all: %.3f N s; budget: %zu evaluations\n", best, budget);
  std::printf(
      "| search | evaluations to within 5 %% of the best, median | 95 %% interval | runs that got "
      "there | fitness after all over the best, median |\n");
  for (const Row& row : rows) {
    std::vector<double> evaluations;
    std::vector<double> ends;
    std::size_t reached = 0;
    for (const Curve& curve : row.curves) {
      evaluations.push_back(curve.evaluations_to(1.05 * best));
      reached += std::isfinite(evaluations.back()) ? 1 : 0;
      ends.push_back(curve.best.back() / best);
    }
    const auto [median, low, high] = median_with_interval(evaluations);
    std::printf("| %s | %.0f | %.0f to %.0f | %zu of %zu | %.3f |\n", row.name.c_str(), median, low,
                high, reached, row.curves.size(), bench::quantile(ends, 0.5));
  }
}

}  // namespace

void print_search(const PoseTrial& trial, std::size_t budget, std::size_t seeds, int threads) {
  using Run = std::function<Curve(std::uint64_t seed)>;
  std::vector<Row> rows;
  std::vector<Run> runs;
  const auto add = [&](const std::string& name, Run run) {
    rows.push_back({name, {}});
    runs.push_back(std::move(run));
  };
  const auto add_genetic = [&](const std::string& name, GeneticOptions options) {
    add(name, [&trial, options, budget, threads](std::uint64_t seed) mutable {
      options.seed = seed;
      return run_genetic(trial, options, budget, threads);
    });
  };
  for (const MutationScheme scheme : kMutationSchemes)
    add_genetic("scheme " + std::string(name_of(scheme)) + ", 400, tournament 4",
                {.mutation = scheme});
  for (const std::size_t population : {100, 200, 400, 800})
    for (const std::size_t tournament : {4, 8}) {
      if (population == 400 && tournament == 4) continue;
      add_genetic(
          "scheme A, " + std::to_string(population) + ", tournament " + std::to_string(tournament),
          {.population = population, .tournament = tournament});
    }
  for (const int population : {13, 100})  // 13 is the default for 20 dimensions
    add("CMA-ES, " + std::to_string(population),
        [&trial, population, budget, threads](std::uint64_t seed) {
          return run_cma_es(trial, population, seed, budget, threads);
        });
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].curves.push_back(runs[i](seed));
    std::printf("after %llu of %zu seeds\n", static_cast<unsigned long long>(seed), seeds);
    print_rows(rows, budget);
    std::fflush(stdout);
  }
}

}  // namespace flinch::evolve
