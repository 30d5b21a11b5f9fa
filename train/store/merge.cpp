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

/// Observations that are committed together: a few megabytes.
constexpr std::size_t kBatch = 1024;

struct Part {
  std::string path;
  ScenarioRange range;
};

/// A store that is merged, open while its scenarios are at hand.
struct Source {
  explicit Source(const Part& merged) : part(merged), reader(merged.path) { advance(); }

  void advance() {
    more = reader.next(observation);
    if (more != (left-- > 0)) throw Error(part.path, "changed while it was read; merge again");
  }

  Part part;
  StoreReader reader;
  std::uint64_t left = part.range.count;
  Observation observation;
  bool more = false;
};

/// The stores by their first scenario, once they are known to fit together. `header` becomes that
/// of the first path.
std::vector<Part> parts_of(std::span<const std::string> paths, StoreHeader& header) {
  std::vector<Part> parts;
  for (const std::string& path : paths) {
    const StoreSummary store = summarise_store(path);
    if (store.observation_count == 0 || store.observation_count != store.range.count)
      throw Error(path, "is not finished; run the `flinch simulate` that made it again");
    if (parts.empty()) header = store.header;
    require_same_run(store.header, header, path,
                     "merge stores of one run, as " + paths.front() + " is of another");
    parts.push_back({path, store.range});
  }
  std::ranges::stable_sort(parts, {}, [](const Part& part) { return part.range.first; });
  return parts;
}

/// All scenarios of the parts. Throws Error for a gap between them.
ScenarioRange joined(std::span<const Part> parts) {
  ScenarioRange range = parts.front().range;
  for (const Part& part : parts) {
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

/// Appends what is missing in batches, and checks what is not.
class Joiner {
 public:
  Joiner(const std::string& out, const StoreHeader& header, ScenarioRange range)
      : writer_(out, header, range), missing_(writer_.missing()) {}

  void take(const Source& source) {
    while (!missing_.empty() && missing_.front().end() <= source.observation.number)
      missing_.erase(missing_.begin());
    if (missing_.empty() || source.observation.number < missing_.front().first) {
      if (!writer_.holds(source.observation)) refuse(source, writer_.partial_path());
      return;
    }
    if (!batch_.empty() && batch_.back().number + 1 != source.observation.number) commit();
    batch_.push_back(source.observation);
    if (batch_.size() == kBatch) commit();
  }

  void finish() {
    commit();
    writer_.finish();
  }

  [[noreturn]] static void refuse(const Source& source, const std::string& other) {
    throw Error(source.part.path, "scenario " + std::to_string(source.observation.number) +
                                      " is not as in " + other +
                                      "; one of the two is wrong, leave it out or delete it");
  }

 private:
  void commit() {
    writer_.append(batch_);
    batch_.clear();
  }

  StoreWriter writer_;
  std::vector<ScenarioRange> missing_;  ///< from the scenario that is at hand
  std::vector<Observation> batch_;
};

}  // namespace

void merge_stores(std::span<const std::string> paths, const std::string& out) {
  StoreHeader header;
  const std::vector<Part> parts = parts_of(paths, header);
  const ScenarioRange range = joined(parts);
  Joiner joiner(out, header, range);
  std::vector<Source> open;
  auto next = parts.begin();
  for (std::uint64_t number = range.first; number < range.end(); ++number) {
    for (; next != parts.end() && next->range.first == number; ++next) open.emplace_back(*next);
    for (const Source& source : std::span(open).subspan(1))
      if (!have_same_row(source.observation, open.front().observation))
        Joiner::refuse(source, open.front().part.path);
    joiner.take(open.front());
    for (Source& source : open) source.advance();
    std::erase_if(open, [](const Source& source) { return !source.more; });
  }
  joiner.finish();
}

}  // namespace flinch::train
