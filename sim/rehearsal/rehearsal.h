// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>

namespace flinch::sim {

/// The undisturbed run of a response, the same for every ball that may meet it. Simulator::rehearse
/// creates it; the Simulator must outlive it. Immutable: one rehearsal may serve several threads at
/// a time.
class Rehearsal {
 public:
  struct Track;
  explicit Rehearsal(std::unique_ptr<const Track> track);
  ~Rehearsal();
  Rehearsal(Rehearsal&&) noexcept;
  Rehearsal& operator=(Rehearsal&&) noexcept;

  double from_s() const;      ///< a ball that touches the figure earlier cannot be simulated
  double duration_s() const;  ///< the response runs from time 0 to here
  std::size_t byte_count() const;
  const Track& track() const { return *track_; }

 private:
  std::unique_ptr<const Track> track_;
};

}  // namespace flinch::sim
