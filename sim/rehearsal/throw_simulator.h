// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "features/ball.h"
#include "sim/rehearsal/simulator.h"
#include "sim/tree/tree_lanes.h"

namespace flinch::sim {

/// A ball, and the rehearsal whose figure it flies at from time 0 on.
struct Throw {
  const Rehearsal& rehearsal;
  features::Ball ball;
};

/// Simulates many throws, several side by side in lanes, in memory that it keeps. Each thread needs
/// its own.
class ThrowSimulator {
 public:
  /// `simulator` must outlive this and have made the rehearsals. `lanes` is 1 or 2 or, if this
  /// processor has registers for them, 4 or 8.
  explicit ThrowSimulator(const Simulator& simulator, std::size_t lanes = widest_lanes());
  ~ThrowSimulator();

  /// Returns what Simulator::simulate returns for each throw, to the same bits whatever the other
  /// throws and the number of lanes. Throws Error as it does, for the first such throw that it
  /// meets.
  std::vector<SimulationResult> simulate(std::span<const Throw> throws);

 private:
  class Lanes;
  template <std::size_t kLanes>
  class LanesOf;
  std::unique_ptr<Lanes> lanes_;
};

}  // namespace flinch::sim
