// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>

namespace flinch::sim {

/// A response as the figure performs it while nothing touches it: the same for every ball that may
/// meet it. Made by Simulator::rehearse, which must outlive it, and never changed; one may serve
/// several threads at a time.
class Rehearsal {
 public:
  struct Track;
  explicit Rehearsal(std::unique_ptr<const Track> track);
  ~Rehearsal();
  Rehearsal(Rehearsal&&) noexcept;
  Rehearsal& operator=(Rehearsal&&) noexcept;

  double from_s() const;      ///< a ball that touches earlier cannot be simulated
  double duration_s() const;  ///< how long the response is performed, from time 0
  std::size_t byte_count() const;
  const Track& track() const { return *track_; }

 private:
  std::unique_ptr<const Track> track_;
};

}  // namespace flinch::sim
