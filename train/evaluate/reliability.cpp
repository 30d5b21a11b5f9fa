// SPDX-License-Identifier: MIT
#include "train/evaluate/reliability.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flinch::train {
namespace {

constexpr std::size_t kBinCount = 10;

void add_bins(const EvaluationRow& row, const char* said, const std::vector<float>& value,
              const EvaluationRow& oracle, std::vector<ReliabilityBin>& bins) {
  std::vector<std::size_t> order(value.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return value[i]; });
  const std::size_t count = std::min(kBinCount, order.size());
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t first = b * order.size() / count;
    const std::size_t end = (b + 1) * order.size() / count;
    ReliabilityBin bin{row.name, said};
    bin.scenarios = end - first;
    const double share = 1 / static_cast<double>(bin.scenarios);
    for (std::size_t k = first; k < end; ++k) {
      const std::size_t i = order[k];
      bin.mean_said += share * double{value[i]};
      bin.accuracy += share * row.hit[i];
      bin.mean_cost_ns += share * row.cost_ns[i];
      bin.mean_regret_ns += share * (row.cost_ns[i] - oracle.cost_ns[i]);
    }
    bins.push_back(bin);
  }
}

bool tells_costs(const EvaluationRow& row) {
  return std::ranges::all_of(row.expected_cost_ns, [](float cost) { return std::isfinite(cost); });
}

bool tells_votes(const EvaluationRow& row) {
  return std::ranges::any_of(row.vote, [](float vote) { return vote > 0; });
}

}  // namespace

std::vector<ReliabilityBin> reliability(const Evaluation& evaluation) {
  std::vector<ReliabilityBin> bins;
  const EvaluationRow& oracle = evaluation.rows.back();
  for (const EvaluationRow& row : evaluation.rows) {
    if (tells_costs(row)) {
      add_bins(row, "expected_cost_ns", row.expected_cost_ns, oracle, bins);
    } else if (tells_votes(row)) {
      add_bins(row, "vote", row.vote, oracle, bins);
    }
  }
  return bins;
}

}  // namespace flinch::train
