// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "models/selector.h"
#include "train/objective/observation.h"
#include "train/scenario/scenario_sampling.h"
#include "train/store/scenario_range.h"

namespace flinch::train {

inline constexpr int kStoreFormatVersion = 3;

/// What a store says of all its observations, so that training needs no other file.
struct StoreHeader {
  std::uint64_t library_hash = 0;  ///< as `library_file` has it
  std::string library_name;
  std::vector<std::byte> library_file;  ///< whole, for the selectors that are trained
  std::uint64_t seed = 0;
  std::string distribution;  ///< JSON text, see describe()
  std::string simulation;    ///< JSON text, see describe()
  /// The largest impulse that a threat of the distribution can give, N·s: D* is the largest
  /// vulnerability times this.
  double reference_impulse_ns = 1;
  double reference_work_j = 1;  ///< W*
  std::vector<models::ClipSummary> clips;
  std::vector<double> clip_work_j;  ///< of each clip's reference response
  int idle = 0;
  /// Of the observations' features: the paper's, unless derive_features() has put in others. Not in
  /// the file.
  features::Layout layout = features::feature_set_named("paper")->layout;
  TargetCentres idle_target_centres{};  ///< of the idle clip's first pose, in the character's frame
};

/// Throws Error naming what differs when the two are not of the same run: another library, seed,
/// distribution or simulation. `path` holds `stored`; `remedy` is what to do then.
void require_same_run(const StoreHeader& stored, const StoreHeader& wanted, const std::string& path,
                      const std::string& remedy = "choose another --out, or delete it");

/// A store as it is read: observations by rising number.
struct Store {
  StoreHeader header;
  std::vector<Observation> observations;
};

/// Reads and checks a whole store; some kilobytes of memory a scenario. Throws Error for a file
/// that is missing, not a store, of another version or damaged.
Store read_store(const std::string& path);

/// Reads and checks a store one observation after the other, whatever its size. Throws Error as
/// read_store does.
class StoreReader {
 public:
  explicit StoreReader(const std::string& path);
  ~StoreReader();
  StoreReader(StoreReader&&) noexcept;
  StoreReader& operator=(StoreReader&&) noexcept;

  const StoreHeader& header() const;
  /// Takes the next observation by rising number; false when there is none.
  bool next(Observation& observation);

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// What a store holds, without its observations.
struct StoreSummary {
  StoreHeader header;
  ScenarioRange range;                  ///< from the lowest number to the highest
  std::uint64_t observation_count = 0;  ///< less than the range's while it is being made

  /// Whether each of `wanted` is there, and nothing between them is missing.
  bool holds(const ScenarioRange& wanted) const;
};
StoreSummary summarise_store(const std::string& path);

/// How much was observed, from a reading of the whole store.
struct StoreContents {
  std::uint64_t bytes = 0;     ///< of the file
  std::uint64_t trials = 0;    ///< simulations
  std::uint64_t impulses = 0;  ///< bodies that took one, over all trials
};
StoreContents count_contents(const std::string& path);

/// Writes the observations of a range of scenarios of one run, in any order, into "PATH.partial"
/// and gives the file its name when all are there. Interrupted at any moment, what was appended
/// stays in the partial file, and a new writer goes on with what is missing; the finished file has
/// the same bytes however often that happened and in whatever order it was filled. A finished store
/// is continued when a range around its own is wanted.
class StoreWriter {
 public:
  /// Throws Error when what stands at `path` or its partial file is no store of this run or holds
  /// scenarios that are not wanted, when another process writes it, or when `wanted` is empty or
  /// goes past the last scenario number.
  StoreWriter(const std::string& path, const StoreHeader& header, ScenarioRange wanted);
  ~StoreWriter();
  StoreWriter(const StoreWriter&) = delete;
  StoreWriter& operator=(const StoreWriter&) = delete;

  /// What of the wanted range is not there yet, by rising number.
  std::vector<ScenarioRange> missing() const;
  /// How many of the wanted scenarios are there.
  std::uint64_t count() const;
  std::string partial_path() const;

  /// Whether exactly this was appended of its scenario, now or by an earlier writer.
  bool holds(const Observation& observation) const;

  /// Adds observations of consecutive missing scenarios, all or none of them.
  void append(std::span<const Observation> observations);

  /// Gives the store its name. Nothing may be missing, and nothing can be appended afterwards.
  void finish();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace flinch::train
