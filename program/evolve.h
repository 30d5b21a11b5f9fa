// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "database/files/output_check.h"
#include "database/library/library.h"
#include "evolve/genetic/evolution.h"
#include "program/command.h"

namespace flinch::program {

/// The options of flinch evolve.
struct EvolveOptions {
  std::string library;
  std::string out;
  std::optional<int> weakest;  ///< find this many cells; without it, evolve for one throw
  std::uint64_t scenarios = 8192;
  CostOptions cost;
  std::string target{"head"};
  double azimuth = 0;
  double elevation = 0;
  double speed_mps = 25;
  std::string style{"free"};
  std::optional<int> population;
  std::uint64_t tournament = evolve::GeneticOptions{}.tournament;
  std::string mutation{"A"};
  std::string gene_map{"limits"};
  std::optional<int> generations;
  std::uint64_t seed = 1;
  std::optional<std::string> pain;
  std::string figure{"people"};
  std::string failed_joints{"idle"};
  double limit_weight = 0;
  double extension_weight = 0;
  std::optional<std::string> log;
  std::optional<int> threads;
  bool force = false;
  bool json = false;
};

/// Returns the element of `all` with a name that the command line has accepted.
template <class All>
auto named(const All& all, const std::string& name) {
  return *std::ranges::find(all, name, [](auto item) { return std::string(name_of(item)); });
}

/// Returns the options of the genetic algorithm, and the defaults of `genetic` for those that are
/// not given. Throws Error for options that do not fit together.
evolve::GeneticOptions genetic_options(const EvolveOptions& options,
                                       evolve::GeneticOptions genetic);

/// The file that keeps an unfinished run.
std::string unfinished_file(const EvolveOptions& options);
/// Checks all files that the command writes, of which the log begins with `log_header`. Throws
/// Error.
void check_evolve_outputs(const EvolveOptions& options, std::string_view log_header);

/// The provenance of the library that a run makes from another, with the options that differ from
/// the defaults of its mode. Throws Error.
std::string evolved_provenance(const EvolveOptions& options, const evolve::GeneticOptions& defaults,
                               const database::ClipLibrary& from);

/// Tells how to continue a run of this many generations. Throws Error.
[[noreturn]] void throw_interrupted(const EvolveOptions& options, std::size_t generations);

/// Evolves for one throw.
void run_evolve_throw(const EvolveOptions& options);
/// Evolves for the cells in which the library protects worst.
void run_evolve_weakest(const EvolveOptions& options);

/// A line for each generation; on a terminal they replace each other.
class EvolutionDisplay {
 public:
  explicit EvolutionDisplay(bool json);
  EvolutionDisplay(const EvolutionDisplay&) = delete;
  EvolutionDisplay& operator=(const EvolutionDisplay&) = delete;
  ~EvolutionDisplay();

  /// Shows the last generation of a run, after what it is for, if that is not empty.
  void show(const std::string& what, const evolve::Evolution& evolution);

 private:
  bool shows_;
  bool terminal_;
  bool shown_ = false;
};

}  // namespace flinch::program
