// SPDX-License-Identifier: MIT
#include "train/store/merge.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "motion/error.h"
#include "train/store/store.h"
#include "train/store/store_rows.h"

namespace flinch::train {

namespace {

/// Number of observations per commit: a few megabytes.
constexpr std::size_t kCommitSize = 1024;

struct StorePart {
  std::string path;
  ScenarioRange range;
};

/// An input store, kept open while its scenarios are read.
struct OpenStore {
  explicit OpenStore(const StorePart& merged) : part(merged), reader(merged.path) { advance(); }

  void advance() {
    more = reader.next(observation);
    if (more != (left-- > 0)) throw Error(part.path, "changed while it was read; merge again");
  }

  StorePart part;
  StoreReader reader;
  std::uint64_t left = part.range.count;
  Observation observation;
  bool more = false;
};

/// Returns the stores sorted by their first scenario, after checking that they fit together.
/// `header` becomes that of the first path.
std::vector<StorePart> parts_of(std::span<const std::string> paths, StoreHeader& header) {
  std::vector<StorePart> parts;
  for (const std::string& path : paths) {
    const StoreSummary store = summarise_store(path);
    if (store.observation_count == 0 || store.observation_count != store.range.count)
      throw Error(path, "is not finished; run the `flinch simulate` that made it again");
    if (parts.empty()) header = store.header;
    require_same_run(
        store.header, header, path,
        "only stores of one run can be merged, and " + paths.front() + " is of another run");
    parts.push_back({path, store.range});
  }
  std::ranges::stable_sort(parts, {}, [](const StorePart& part) { return part.range.first; });
  return parts;
}

/// Returns the range of all parts. Throws Error if there is a gap between them.
ScenarioRange merged_range(std::span<const StorePart> parts) {
  ScenarioRange range = parts.front().range;
  for (const StorePart& part : parts) {
    if (part.range.first > range.end()) {
      const ScenarioRange gap{range.end(), part.range.first - range.end()};
      throw Error(part.path, text_of(gap) +
                                 " are in none of the stores; simulate them with --first " +
                                 std::to_string(gap.first) + " -n " + std::to_string(gap.count) +
                                 " and merge that store too");
    }
    range.count = std::max(range.end(), part.range.end()) - range.first;
  }
  return range;
}

/// Appends missing observations in batches, and compares those that are there already.
class StoreMerger {
 public:
  StoreMerger(const std::string& out, const StoreHeader& header, ScenarioRange range,
              database::Overwrite overwrite)
      : writer_(out, header, range, overwrite), missing_(writer_.missing()) {}

  void take(const OpenStore& store) {
    while (!missing_.empty() && missing_.front().end() <= store.observation.number)
      missing_.erase(missing_.begin());
    if (missing_.empty() || store.observation.number < missing_.front().first) {
      if (!writer_.holds(store.observation)) refuse(store, writer_.partial_path());
      return;
    }
    if (!batch_.empty() && batch_.back().number + 1 != store.observation.number) commit();
    batch_.push_back(store.observation);
    if (batch_.size() == kCommitSize) commit();
  }

  void finish() {
    commit();
    writer_.finish();
  }

  [[noreturn]] static void refuse(const OpenStore& store, const std::string& other) {
    throw Error(store.part.path, "scenario " + std::to_string(store.observation.number) +
                                     " is not as in " + other +
                                     "; one of the two is wrong, leave it out or delete it");
  }

 private:
  void commit() {
    writer_.append(batch_);
    batch_.clear();
  }

  StoreWriter writer_;
  std::vector<ScenarioRange> missing_;  ///< from the current scenario on
  std::vector<Observation> batch_;
};

}  // namespace

void merge_stores(std::span<const std::string> paths, const std::string& out,
                  database::Overwrite overwrite) {
  StoreHeader header;
  const std::vector<StorePart> parts = parts_of(paths, header);
  const ScenarioRange range = merged_range(parts);
  StoreMerger merger(out, header, range, overwrite);
  std::vector<OpenStore> open;
  auto next = parts.begin();
  for (std::uint64_t number = range.first; number < range.end(); ++number) {
    for (; next != parts.end() && next->range.first == number; ++next) open.emplace_back(*next);
    for (const OpenStore& store : std::span(open).subspan(1))
      if (!have_same_row(store.observation, open.front().observation))
        StoreMerger::refuse(store, open.front().part.path);
    merger.take(open.front());
    for (OpenStore& store : open) store.advance();
    std::erase_if(open, [](const OpenStore& store) { return !store.more; });
  }
  merger.finish();
}

}  // namespace flinch::train
