// SPDX-License-Identifier: MIT
#include "sim/rehearsal.h"

#include "sim/rehearsal_track.h"

namespace flinch::sim {

Rehearsal::Rehearsal(std::unique_ptr<const Track> track) : track_(std::move(track)) {}
Rehearsal::~Rehearsal() = default;
Rehearsal::Rehearsal(Rehearsal&&) noexcept = default;
Rehearsal& Rehearsal::operator=(Rehearsal&&) noexcept = default;

double Rehearsal::from_s() const {
  return track_->from_s;
}

double Rehearsal::duration_s() const {
  return track_->duration_s;
}

std::size_t Rehearsal::byte_count() const {
  return sizeof(Track) + track_->motion.poses.size() * sizeof(motion::Pose);
}

}  // namespace flinch::sim
