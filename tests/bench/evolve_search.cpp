// SPDX-License-Identifier: MIT
#include "tests/bench/evolve_search.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  std::size_t tested() const { return known_.size(); }

 private:
  const PoseTrial& trial_;
  int threads_;
  std::map<Chromosome, double> known_;
};

/// The best fitness after each generation.
struct Curve {
  struct Point {
    std::size_t tested = 0;  ///< poses
    double best = 0;         ///< N s
  };
  std::vector<Point> points;

  void add(std::size_t tested, double fitness) {
    points.push_back({tested, points.empty() ? fitness : std::min(best(), fitness)});
  }
  double best() const { return points.back().best; }
  /// Poses tested until the best is at most `bound`; infinite if it never is.
  double tested_to(double bound) const {
    for (const Point& point : points)
      if (point.best <= bound) return static_cast<double>(point.tested);
    return std::numeric_limits<double>::infinity();
  }
};

/// One way to search: it goes on until it has tested `budget` poses.
struct Search {
  std::string name;
  std::function<Curve(const PoseTrial& trial, std::uint64_t seed, std::size_t budget, int threads)>
      run;
};

Search genetic_search(std::string name, GeneticOptions options) {
  return {std::move(name), [options](const PoseTrial& trial, std::uint64_t seed, std::size_t budget,
                                     int threads) mutable {
            options.seed = seed;
            options.ends = ends_of(trial.options().gene_map);
            FixedFitness fitness(trial, threads);
            const auto evaluate = [&](std::size_t, std::span<const Chromosome> poses) {
              return fitness.of(poses);
            };
            const auto check = [](const Chromosome&) { return 0.0; };
            Curve curve;
            Evolution evolution = begin_evolution(options, trial.genes().size());
            while (fitness.tested() < budget) {
              advance(options, evaluate, check, evolution);
              curve.add(fitness.tested(), evolution.history.back().best_fitness);
            }
            return curve;
          }};
}

Search cma_es_search(int population) {
  return {
      "CMA-ES, " + std::to_string(population),
      [population](const PoseTrial& trial, std::uint64_t seed, std::size_t budget, int threads) {
        FixedFitness fitness(trial, threads);
        bench::CmaEs search(static_cast<int>(trial.genes().size()), population, seed);
        Curve curve;
        while (fitness.tested() < budget) {
          std::vector<Chromosome> poses;
          for (const Eigen::VectorXd& point : search.ask()) {
            Chromosome& pose = poses.emplace_back();
            for (const double x : point)
              pose.push_back(static_cast<Gene>(std::lround(x * kMaxGene)));
          }
          const std::vector<double> values = fitness.of(poses);
          search.tell(values);
          curve.add(fitness.tested(), *std::ranges::min_element(values));
        }
        return curve;
      }};
}

/// All searches; others are compared with the first.
std::vector<Search> all_searches() {
  std::vector<Search> searches;
  for (const MutationScheme scheme : kMutationSchemes)
    searches.push_back(genetic_search("scheme " + std::string(name_of(scheme)) + ", 400, 4",
                                      {.mutation = scheme}));
  for (const std::size_t population : {100, 200, 400, 800})
    for (const std::size_t tournament : {4, 8}) {
      if (population == 400 && tournament == 4) continue;
      searches.push_back(genetic_search(
          "scheme A, " + std::to_string(population) + ", " + std::to_string(tournament),
          {.population = population, .tournament = tournament}));
    }
  for (const int population : {13, 100})  // 13 is the default for 20 dimensions
    searches.push_back(cma_es_search(population));
  return searches;
}

/// The median of seeds, and its 95 % interval by 2000 resamples.
struct Estimate {
  double value = 0;
  double low = 0;
  double high = 0;
};
Estimate median_with_interval(const std::vector<double>& values) {
  features::Random random(1, features::RandomStream::bootstrap, 0);
  std::vector<double> medians;
  for (int k = 0; k < 2000; ++k) {
    std::vector<double> drawn;
    for (std::size_t i = 0; i < values.size(); ++i)
      drawn.push_back(values[random.index(values.size())]);
    medians.push_back(bench::quantile(std::move(drawn), 0.5));
  }
  return {bench::quantile(values, 0.5), bench::quantile(medians, 0.025),
          bench::quantile(medians, 0.975)};
}

std::string text_of(const Estimate& estimate, const char* format) {
  const auto number = [&](double value) {
    if (!std::isfinite(value)) return std::string("more");
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return std::string(text.data());
  };
  return number(estimate.value) + " (" + number(estimate.low) + " to " + number(estimate.high) +
         ")";
}

constexpr std::array kGoals{1.05, 1.25};  // times the best of all

void print_rows(std::span<const Search> searches, std::span<const std::vector<Curve>> curves) {
  double best = std::numeric_limits<double>::infinity();
  for (const std::vector<Curve>& seeds : curves)
    for (const Curve& curve : seeds) best = std::min(best, curve.best());
  std::printf(
      "best of all: %.3f N s\n"
      "| search | fitness at the end over the best of all, median (95 %% interval) | over the "
      "first row's, same seed | runs within 5 %% | poses to within 5 %% | to within 25 %% |\n",
      best);
  for (std::size_t i = 0; i < searches.size(); ++i) {
    std::vector<double> ends;
    std::vector<double> ratios;
    std::array<std::vector<double>, kGoals.size()> tested;
    for (std::size_t k = 0; k < curves[i].size(); ++k) {
      const Curve& curve = curves[i][k];
      ends.push_back(curve.best() / best);
      ratios.push_back(curve.best() / curves[0][k].best());
      for (std::size_t goal = 0; goal < kGoals.size(); ++goal)
        tested[goal].push_back(curve.tested_to(kGoals[goal] * best));
    }
    const auto within = std::ranges::count_if(ends, [](double end) { return end <= kGoals[0]; });
    std::printf("| %s | %s | %s | %td of %zu | %s | %s |\n", searches[i].name.c_str(),
                text_of(median_with_interval(ends), "%.2f").c_str(),
                text_of(median_with_interval(ratios), "%.2f").c_str(), within, ends.size(),
                text_of(median_with_interval(tested[0]), "%.0f").c_str(),
                text_of(median_with_interval(tested[1]), "%.0f").c_str());
  }
  std::fflush(stdout);
}

}  // namespace

void print_search(const PoseTrial& limits, const PoseTrial& full_turn, std::size_t budget,
                  std::size_t seeds, int threads) {
  std::vector<Search> searches = all_searches();
  const std::size_t turned = searches.size();
  searches.push_back(genetic_search("scheme A, 400, 4, equation 4.5", {}));
  std::vector<std::vector<Curve>> curves(searches.size());
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const double begin_s = bench::process_cpu_s();
    for (std::size_t i = 0; i < searches.size(); ++i)
      curves[i].push_back(searches[i].run(i == turned ? full_turn : limits, seed, budget, threads));
    std::printf("seed %llu: %.0f CPU s\n", static_cast<unsigned long long>(seed),
                bench::process_cpu_s() - begin_s);
    print_rows(searches, curves);
  }
}

}  // namespace flinch::evolve
