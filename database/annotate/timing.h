// SPDX-License-Identifier: MIT
#pragma once

#include "database/annotate/kind.h"

namespace flinch::database {

/// When a movement begins to protect, and when it protects most: frames of the take.
struct MovementTimes {
  std::size_t onset = 0;
  std::size_t peak = 0;  ///< after `onset`
};

/// Finds onset and peak of a movement of at least two frames.
///
/// The peak is where the guarded part is displaced most, or first held:
///
/// | kind | peak |
/// | --- | --- |
/// | duck, dodge | the head is lowest |
/// | step | the pelvis is farthest from where it was |
/// | lift | the foot is highest; in a jump, the lower foot |
/// | block by thrown hands (kThrownHand_mps) | the hands slow to a quarter of their speed |
/// | other blocks, flinch | the pose is farthest from the first, relative to the stance |
/// | push | the pelvis is farthest, as in a step |
///
/// The onset is the earlier of two moments, with d(a, b) the pose_distance of frames a and b, from
/// the first frame s to the peak p:
///
///   - the last with d(t, p) >= 0.95 max d(., p): nearly the whole way to the peak is still ahead;
///   - the last before d(s, t) > 0.15 max d(s, .): the body is still where it was.
///
/// The first finds the onset where a movement goes straight to its peak, however long the body
/// fidgets before; the second where it winds up first and comes back past the start. In a moving
/// stance, distances are relative to it and s moves back, by at most 0.15 s, as long as that is
/// farther from the peak; where the head is the guarded part, s is at most 0.3 s before the head
/// has gone 0.2 of its way: hands and knees lead the head by no more.
MovementTimes times_of(const TakeSignals& signals, const Movement& movement,
                       const MovementMeasures& measures, MovementKind kind);

/// Returns the frame of first contact of a push: the last before the peak of the chest's speed in
/// the direction of that peak at which it is below a tenth of it.
std::size_t contact_of(const TakeSignals& signals, const Movement& movement);

}  // namespace flinch::database
