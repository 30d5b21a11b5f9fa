// SPDX-License-Identifier: MIT
#pragma once

#include "motion/body.h"

namespace flinch::motion::de_leva {

/// One row of the table. Percentages as printed there.
struct Segment {
  float mass_percent;    ///< of the whole body's mass
  float centre_percent;  ///< of the segment's length, from its near (cranial or proximal) end
};

/// Segment masses and centres of mass for one sex: de Leva, P. (1996), "Adjustments to
/// Zatsiorsky-Seluyanov's segment inertia parameters", Journal of Biomechanics 29(9), 1223-1230,
/// table 4 and its alternative end points.
struct Table {
  Segment head_and_neck;  ///< vertex to cervicale
  Segment upper_trunk;    ///< suprasternale to xiphion
  Segment middle_trunk;   ///< xiphion to omphalion (navel)
  Segment lower_trunk;    ///< omphalion to mid-hip
  Segment upper_arm;      ///< shoulder to elbow
  Segment forearm;        ///< elbow to wrist
  Segment hand;           ///< wrist to third metacarpale (the knuckle)
  Segment thigh;          ///< hip to knee
  Segment shank;          ///< knee to ankle
  Segment foot;           ///< heel to toe tip
  float knuckle_length;   ///< wrist to third metacarpale over wrist to fingertip
};

const Table& table(Sex sex);

}  // namespace flinch::motion::de_leva
