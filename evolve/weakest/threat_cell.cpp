// SPDX-License-Identifier: MIT
#include "evolve/weakest/threat_cell.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "train/evaluate/bins.h"

namespace flinch::evolve {
namespace {

using train::ThreatKind;
using train::ValueRange;

constexpr double kEighth = std::numbers::pi / 4;
constexpr double kTurn = 2 * std::numbers::pi;

int nearest_eighth(double azimuth) {
  const auto eighths = static_cast<int>(std::lround(azimuth / kEighth));
  const int direction = ((eighths + 3) % 8 + 8) % 8 - 3;
  return direction;
}

/// The parts of `sectors` that are nearest to a direction.
std::vector<ValueRange> sectors_in(const std::vector<ValueRange>& sectors, double azimuth) {
  std::vector<ValueRange> parts;
  for (const ValueRange& sector : sectors) {
    for (const double turn : {-kTurn, 0.0, kTurn}) {
      const ValueRange part{std::max(sector.min, azimuth + turn - kEighth / 2),
                            std::min(sector.max, azimuth + turn + kEighth / 2)};
      const bool is_line = sector.min == sector.max && part.min == part.max;
      if (part.min < part.max || is_line) parts.push_back(part);
    }
  }
  return parts;
}

double width_of(const std::vector<ValueRange>& sectors) {
  double width = 0;
  for (const ValueRange& sector : sectors) width += sector.max - sector.min;
  return width;
}

/// The times to impact of a kind that are in a bin: all of them, and how many.
struct Times {
  ValueRange range;
  int count = 0;
};
Times times_in(const train::ScenarioDistribution& distribution, const ThreatKind& kind,
               const train::Bin& bin) {
  Times times;
  for (int time = 0; time < time_to_impact_count(distribution); ++time) {
    const float time_s = time_to_impact_s(distribution, time);
    const double slack_s = distribution.time_to_impact_step_s / 4;
    const bool is_of_kind = double{time_s} > kind.time_to_impact_s.min - slack_s &&
                            double{time_s} < kind.time_to_impact_s.max + slack_s;
    if (!is_of_kind || !bin.holds(time_s)) continue;
    if (times.count == 0) times.range.min = double{time_s};
    times.range.max = double{time_s};
    ++times.count;
  }
  return times;
}

/// The kind's threats in the cell; their weight is 0 if there are none.
ThreatKind kind_in(const train::ScenarioDistribution& distribution, const ThreatKind& kind,
                   const ThreatCell& cell) {
  const Times all = times_in(distribution, kind, {"", 0, train::kUnbounded});
  const Times times =
      times_in(distribution, kind, train::kTimeBins[static_cast<std::size_t>(cell.time)]);
  const std::vector<ValueRange> azimuth = sectors_in(kind.azimuth, cell.azimuth());
  const double aimed = kind.target_weight[cell.target] / sum(kind.target_weight);
  ThreatKind part = kind;
  if (times.count == 0 || azimuth.empty() || !(aimed > 0)) {
    part.weight = 0;
    return part;
  }
  const double width = width_of(kind.azimuth);
  part.weight *= aimed * times.count / all.count * (width > 0 ? width_of(azimuth) / width : 1);
  part.azimuth = azimuth;
  part.time_to_impact_s = times.range;
  part.target_weight = {};
  part.target_weight[cell.target] = 1;
  return part;
}

}  // namespace

double ThreatCell::azimuth() const {
  return direction * kEighth;
}

ThreatCell cell_of(const features::Scenario& scenario) {
  const Eigen::Vector3f& velocity = scenario.threat.velocity;
  ThreatCell cell;
  cell.target = scenario.target;
  cell.direction = nearest_eighth(
      std::atan2(-static_cast<double>(velocity.y()), -static_cast<double>(velocity.x())));
  const auto bin = std::ranges::find_if(train::kTimeBins, [&](const train::Bin& candidate) {
    return candidate.holds(scenario.time_to_impact_s);
  });
  cell.time = static_cast<int>(bin - train::kTimeBins.begin());
  return cell;
}

ThreatCell mirrored(const ThreatCell& cell) {
  return {cell.target, cell.direction == 4 ? 4 : -cell.direction, cell.time};
}

std::optional<train::ScenarioDistribution> threats_in(
    const train::ScenarioDistribution& distribution, const ThreatCell& cell) {
  train::ScenarioDistribution part = distribution;
  double weight = 0;
  for (ThreatKind& kind : part.kinds) {
    kind = kind_in(distribution, kind, cell);
    weight += kind.weight;
  }
  if (!(weight > 0)) return std::nullopt;
  return part;
}

}  // namespace flinch::evolve
