// SPDX-License-Identifier: MIT
#include "train/evaluate/split.h"

#include <algorithm>
#include <iterator>

#include "motion/error.h"

namespace flinch::train {
namespace {

bool share_a_number(std::span<const Observation> a, std::span<const Observation> b) {
  std::vector<std::uint64_t> of_both;
  const auto number = [](const Observation& observation) { return observation.number; };
  std::vector<std::uint64_t> in_a;
  std::vector<std::uint64_t> in_b;
  std::ranges::transform(a, std::back_inserter(in_a), number);
  std::ranges::transform(b, std::back_inserter(in_b), number);
  std::ranges::set_intersection(in_a, in_b, std::back_inserter(of_both));
  return !of_both.empty();
}

}  // namespace

void require_independent(const Store& training, const Store& test, const std::string& path) {
  const StoreHeader& fitted = training.header;
  const StoreHeader& tested = test.header;
  if (tested.library_hash != fitted.library_hash)
    throw Error(path, "was made from another library (" + tested.library_name +
                          ") than the training store (" + fitted.library_name +
                          "); simulate the same library");
  // Other kinds may also need other steps of simulation: the cause comes first.
  if (tested.kinds != fitted.kinds)
    throw Error(path,
                "has other kinds of threats than the training store; simulate both with the "
                "same --threats");
  if (tested.simulation != fitted.simulation)
    throw Error(path, "was made with another simulation, " + tested.simulation +
                          "; simulate it again with this program");
  if (tested.layout != fitted.layout)
    throw Error(path, "has other features than the training store; derive the same");
  if (tested.seed == fitted.seed && tested.distribution == fitted.distribution &&
      share_a_number(training.observations, test.observations))
    throw Error(path, "shares scenarios with the training store (both have seed " +
                          std::to_string(fitted.seed) +
                          "); simulate test scenarios with another --seed");
}

TrainTestSplit split_of(Store store) {
  TrainTestSplit split;
  const std::size_t count = store.observations.size();
  split.header = std::move(store.header);
  split.test_header = split.header;
  for (Observation& observation : store.observations)
    (is_held_out(observation.number) ? split.tested : split.fitted)
        .push_back(std::move(observation));
  if (split.tested.size() < 2)
    throw Error("", "comparing needs at least 8 scenarios and there are " + std::to_string(count) +
                        "; simulate more");
  return split;
}

TrainTestSplit split_of(Store training, Store test) {
  for (const Store* store : {&training, &test})
    if (store->observations.size() < 2)
      throw Error("", "comparing needs at least 2 scenarios in either store and there are " +
                          std::to_string(store->observations.size()) + "; simulate more");
  return {std::move(training.header), std::move(training.observations),
          std::move(test.observations), true, std::move(test.header)};
}

}  // namespace flinch::train
