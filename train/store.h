// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "models/selector.h"
#include "train/observation.h"
#include "train/scenario_sampling.h"

namespace flinch::train {

inline constexpr int kStoreFormatVersion = 2;

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
/// distribution or simulation. `path` holds `stored`.
void require_same_run(const StoreHeader& stored, const StoreHeader& wanted,
                      const std::string& path);

/// A store as it is read: observations by rising number.
struct Store {
  StoreHeader header;
  std::vector<Observation> observations;
};

/// Reads and checks a whole store. Throws Error for a file that is missing, not a store, of another
/// version or damaged.
Store read_store(const std::string& path);

/// What a store holds, without its observations.
struct StoreSummary {
  StoreHeader header;
  std::uint64_t observation_count = 0;
};
StoreSummary summarise_store(const std::string& path);

/// Writes the observations of scenarios 0, 1, 2, … of one run into "PATH.partial" and gives the
/// file its name when all are there. Interrupted at any moment, what was appended stays in the
/// partial file, and a new writer goes on after it; the finished file has the same bytes however
/// often that happened. A finished store is continued when more scenarios are wanted.
class StoreWriter {
 public:
  /// Throws Error when what stands at `path` or its partial file is no store of this run, or
  /// another process writes it.
  StoreWriter(const std::string& path, const StoreHeader& header);
  ~StoreWriter();
  StoreWriter(const StoreWriter&) = delete;
  StoreWriter& operator=(const StoreWriter&) = delete;

  /// How many scenarios are there: the number of the next one.
  std::uint64_t count() const;
  std::string partial_path() const;

  /// Adds the next observations, all or none of them.
  void append(std::span<const Observation> observations);

  /// Gives the store its name. Nothing can be appended afterwards.
  void finish();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace flinch::train
