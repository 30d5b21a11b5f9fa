// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "database/files/output_check.h"
#include "models/selector.h"
#include "train/objective/observation.h"
#include "train/scenario/scenario_sampling.h"
#include "train/store/scenario_range.h"

namespace flinch::train {

/// Version of the stores that are written. 4 has kinds of threats, 5 their shapes, 6 rods and
/// places.
inline constexpr int kStoreFormatVersion = 6;
/// Version of the stores that are written where scenarios begin in several stances: 6 with these.
inline constexpr int kStanceStoreFormatVersion = 7;
/// The oldest version that is read. Its threats are of one kind. A writer continues none but its
/// own.
inline constexpr int kMinStoreFormatVersion = 3;

/// Describes a store that is about to be written.
database::Output store_output(const std::string& path);

/// Data common to all observations of a store. With it, training needs no other file.
struct StoreHeader {
  int format_version = kStoreFormatVersion;  ///< of the file that it was read from
  std::uint64_t library_hash = 0;            ///< hash of `library_file`
  std::string library_name;
  std::vector<std::byte> library_file;  ///< the whole file, for the selectors that are trained
  std::uint64_t seed = 0;
  std::string distribution;  ///< JSON text, see describe()
  std::string simulation;    ///< JSON text, see describe()
  std::string provenance;    ///< how it was made (database/files/provenance.h), or empty
  std::vector<features::KnownKind> kinds =
      std::vector<features::KnownKind>(1);  ///< that Threat::kind counts
  /// Largest impulse that a threat of the distribution can give, N·s; for readers, since D* is a
  /// kind's.
  double reference_impulse_ns = 1;
  double reference_work_j = 1;  ///< W*
  bool keeps_places = false;    ///< whether observations tell where bodies were hit
  std::vector<models::ClipSummary> clips;
  std::vector<double> clip_work_j;  ///< of each clip's reference response
  int idle = 0;
  /// Names of the library's stances, which CharacterState::stance counts; empty where all scenarios
  /// begin in the idle clip.
  std::vector<std::string> stances;
  /// Layout of the observations' features: the paper's, unless derive_features() has replaced them.
  /// Not in the file.
  features::Layout layout = features::feature_set_named("paper")->layout;
  motion::PerTarget<Eigen::Vector3f>
      idle_target_centres{};  ///< of the idle clip's first pose, in the character's frame
};

/// Returns the names of a library's stances.
std::vector<std::string> stance_names(const database::ClipLibrary& library);

/// Throws Error, naming the difference, unless the two are of the same run: same library, seed,
/// distribution and simulation. `path` is the file of `stored`; `remedy` tells the user what to do.
void require_same_run(const StoreHeader& stored, const StoreHeader& wanted, const std::string& path,
                      const std::string& remedy = "choose another --out, or delete it");

/// A store in memory: observations in ascending order of their number.
struct Store {
  StoreHeader header;
  std::vector<Observation> observations;
  std::uint64_t hash = 0;  ///< see StoreReader::hash()
};

/// Reads and checks a whole store; takes some kilobytes of memory per scenario. Throws Error for a
/// file that is missing, not a store, of another version or damaged.
Store read_store(const std::string& path);

/// Reads and checks a store observation by observation, whatever its size. Throws Error as
/// read_store does.
class StoreReader {
 public:
  explicit StoreReader(const std::string& path);
  ~StoreReader();
  StoreReader(StoreReader&&) noexcept;
  StoreReader& operator=(StoreReader&&) noexcept;

  const StoreHeader& header() const;
  /// Reads the next observation in ascending order of numbers. Returns false if there is none.
  bool next(Observation& observation);
  /// Returns the hash of what has been read: of library, seed, distribution and simulation, then of
  /// each row's checksum. After the last observation it identifies the store's content, without
  /// its provenance.
  std::uint64_t hash() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Contents of a store, without its observations.
struct StoreSummary {
  StoreHeader header;
  ScenarioRange range;                  ///< from the lowest number to the highest
  std::uint64_t observation_count = 0;  ///< less than the range's while the store is unfinished

  /// Whether the store holds all of `wanted` and nothing between them is missing.
  bool holds(const ScenarioRange& wanted) const;
};
StoreSummary summarise_store(const std::string& path);

/// Statistics of a store, from reading all of it.
struct StoreContents {
  std::uint64_t bytes = 0;     ///< of the file
  std::uint64_t trials = 0;    ///< simulations
  std::uint64_t impulses = 0;  ///< bodies with an impulse, over all trials
  std::uint64_t places = 0;    ///< where they were hit
  std::uint64_t hash = 0;      ///< see StoreReader::hash()
};
StoreContents count_contents(const std::string& path);

/// Writes the observations of a range of scenarios of one run, in any order, into "PATH.partial"
/// and renames the file when all are there. After an interruption at any moment, the partial file
/// keeps what was appended, and a new writer continues with what is missing. The finished file has
/// the same bytes whatever the interruptions and the order. A finished store is continued if a
/// range that contains its own is wanted.
class StoreWriter {
 public:
  /// Throws Error if the file at `path` or its partial file is not a store of this run and of
  /// the version that is written for it or holds scenarios that are not wanted, if another process
  /// is writing it, or if `wanted` is empty or exceeds the last scenario number. A file at `path`
  /// that is no store at all is replaced at the end if `overwrite` says so. If `path` is a link,
  /// the store is written where it leads.
  StoreWriter(const std::string& path, const StoreHeader& header, ScenarioRange wanted,
              database::Overwrite overwrite = database::Overwrite::refuse);
  ~StoreWriter();
  StoreWriter(const StoreWriter&) = delete;
  StoreWriter& operator=(const StoreWriter&) = delete;

  /// Returns what is missing of the wanted range, in ascending order.
  std::vector<ScenarioRange> missing() const;
  /// Returns how many of the wanted scenarios are there.
  std::uint64_t count() const;
  std::string partial_path() const;

  /// Whether exactly this observation of its scenario was appended, now or by an earlier writer.
  bool holds(const Observation& observation) const;

  /// Adds observations of consecutive missing scenarios, either all or none of them.
  void append(std::span<const Observation> observations);

  /// Gives the store its final name. No scenario may be missing, and nothing can be appended
  /// afterwards.
  void finish();

  /// Removes what a killed writer of the finished store at `path` left beside it, unless that holds
  /// scenarios which the store lacks or another process is writing it.
  static void remove_left_overs(const std::string& path);

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace flinch::train
